"""What a session holds besides one design: locks, kept runs and the window's view."""

import json
import zipfile
from dataclasses import replace

import numpy as np
import pytest

from tests.accounts import result_of
from workbench.design.session import KeptRun, Session, VerifiedError
from workbench.errors import Refused
from workbench.files.session import read_session, write_session
from workbench.geometry.faces import NO_LOCKS, FaceArrays

VIEW = {"camera": [1.5, None, True], "docks": {"state": "AAAA"}, "map": "viridis"}


@pytest.fixture
def make_run(make_scene, rng):
    def make(name, net=(5, 4), pixels=(7, 6), losses=8):
        scene = make_scene({"lens.control_points": list(net), "screen.pixels": list(pixels)})
        result = result_of(rng.random(net), rng.random(pixels[::-1]), rng.random(losses))
        return KeptRun(name, scene, rng.random(pixels[::-1]), result)

    return make


@pytest.fixture
def session(make_run, rng):
    design = make_run("open")
    checked = VerifiedError(0.0123, (0.011, 0.0135))
    runs = (
        replace(make_run("coarse", (4, 4), (3, 2)), verified=checked),
        make_run("fein gemäß α = 4", losses=0),
    )
    locked = FaceArrays({"lens.back": rng.random((5, 4)) < 0.5})
    return Session(design.scene, design.target, design.result, locked, runs, VIEW)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "lens.freeform"


@pytest.fixture
def forge(session, path):
    """Writes the session with entries changed, or left out where None; or fields of its text."""

    def make(entries=None, **fields):
        write_session(session, path)
        with zipfile.ZipFile(path) as archive:
            content = {name: archive.read(name) for name in archive.namelist()}
        text = json.loads(content["session.json"]) | fields
        content |= {"session.json": json.dumps(text).encode()} | (entries or {})
        with zipfile.ZipFile(path, "w") as archive:
            for name in content:
                if content[name] is not None:
                    archive.writestr(name, content[name])
        return path

    return make


def refused(path):
    with pytest.raises(Refused) as caught:
        read_session(path)
    return str(caught.value).removeprefix(str(path))


def assert_same(found, expected):
    assert found.scene == expected.scene
    np.testing.assert_array_equal(found.target, expected.target)
    for name in ("heights", "irradiance"):
        one, other = (getattr(session.result.state, name) for session in (found, expected))
        np.testing.assert_array_equal(one, other)
    np.testing.assert_array_equal(found.result.losses, expected.result.losses)
    one, other = found.result, expected.result
    assert (one.state.loss, one.state.account) == (other.state.loss, other.state.account)
    assert one.seconds == other.seconds


def test_everything_comes_back(session, path):
    write_session(session, path)
    found = read_session(path)
    assert_same(found, session)
    assert found.locked["lens.back"].dtype == np.bool_
    assert not found.locked["lens.back"].flags.writeable
    assert found.locked == session.locked
    assert [run.name for run in found.runs] == ["coarse", "fein gemäß α = 4"]
    for run, expected in zip(found.runs, session.runs, strict=True):
        assert run.verified == expected.verified
        assert_same(run, expected)
    assert found.view == VIEW


def test_a_lens_to_start_from_is_kept_until_there_is_a_result(session, path):
    start = session.result.state.heights
    write_session(replace(session, result=None, start=start), path)
    found = read_session(path)
    assert found.start == start
    assert found.result is None and not found.start["lens.back"].flags.writeable
    write_session(replace(session, start=FaceArrays({"lens.back": start["lens.back"] + 1})), path)
    assert read_session(path).start is None


class TestWithScene:
    def test_runs_and_view_outlive_every_edit(self, session, make_scene):
        other = make_scene({"lens.control_points": [8, 9], "screen.pixels": [7, 6]})
        found = session.with_scene(other, session.target)
        assert (found.result, found.locked) == (None, NO_LOCKS)
        assert found.runs is session.runs
        assert found.view is session.view


class TestRefused:
    def test_locks_of_another_net(self, forge, path):
        other = np.zeros((4, 5), bool)
        np.save(path.with_suffix(".npy"), other)
        message = refused(
            forge({"faces/lens.back.locked.npy": path.with_suffix(".npy").read_bytes()})
        )
        assert message == ": faces/lens.back.locked.npy: has shape (4, 5); the scene needs (5, 4)"
