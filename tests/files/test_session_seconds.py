"""Sessions keep when each iteration and why the run ended, which earlier ones did not."""

import zipfile
from dataclasses import replace

import numpy as np
import pytest

from tests.accounts import account_of
from workbench.design.lens_state import LensState
from workbench.design.session import KeptRun, Session
from workbench.design.snapshot import Result
from workbench.errors import Refused
from workbench.files.session import read_session, write_session
from workbench.geometry.faces import FaceArrays


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene({"lens.control_points": [5, 4], "screen.pixels": [7, 6]})
    result = Result(
        LensState(
            heights=FaceArrays({"exit": rng.random((5, 4))}),
            irradiance=rng.random((6, 7)),
            loss=0.25,
            account=account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1),
        ),
        losses=rng.random(3),
        seconds=2.0,
        seconds_at=np.array([1.0, 1.25, 2.0]),
        ended="stopped",
    )
    target = rng.random((6, 7))
    earlier = replace(result, seconds_at=None, ended="")
    runs = (KeptRun("now", scene, target, result), KeptRun("earlier", scene, target, earlier))
    return Session(scene, target, result, runs=runs)


def test_seconds_come_back(session, tmp_path):
    write_session(session, tmp_path / "lens.freeform")
    found = read_session(tmp_path / "lens.freeform")
    now, earlier = (run.result for run in found.runs)
    for result in (found.result, now):
        assert result.times().tolist() == [1.0, 1.25, 2.0]
        assert result.ended == "stopped"
    assert earlier.ended == ""
    assert earlier.seconds_at is None
    assert earlier.times().tolist() == pytest.approx([2 / 3, 4 / 3, 2])


def test_a_long_reason_is_cut_short(session, tmp_path):
    path = tmp_path / "lens.freeform"
    ended = "failed: " + 2000 * "x"
    write_session(replace(session, result=replace(session.result, ended=ended)), path)
    assert read_session(path).result.ended == ended[:1000]


def test_seconds_of_another_number_of_iterations_are_refused(session, tmp_path):
    path = tmp_path / "lens.freeform"
    write_session(replace(session, runs=()), path)
    with zipfile.ZipFile(path) as archive:
        content = {name: archive.read(name) for name in archive.namelist()}
    content["seconds.npy"] = content["target.npy"]
    with zipfile.ZipFile(path, "w") as archive:
        for name, entry in content.items():
            archive.writestr(name, entry)
    with pytest.raises(Refused, match=r"seconds\.npy"):
        read_session(path)
