import io
import json
import math
import zipfile
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.accounts import account_of, result_of
from workbench import __version__
from workbench.design.limits import Shortfall
from workbench.errors import Refused
from workbench.files.session import Session, read_session, write_session
from workbench.optics.account import Account

TARGET, FACE = "images/0/target.npy", "faces/lens.back.npy"
ARRAYS = [TARGET, FACE, "images/0/irradiance.npy", "loss.npy"]


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene({"lens.control_points": [5, 4], "screen.pixels": [7, 6]})
    account = account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1 - 1e-17)
    result = result_of(
        rng.random((5, 4)), rng.random((6, 7)) / 3, rng.random(8), 2.1, 1 / 3, account
    )
    return Session(scene, rng.random((6, 7)), result)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "lens.freeform"


def npy(array):
    file = io.BytesIO()
    np.save(file, array, allow_pickle=True)
    return file.getvalue()


def entries_of(path):
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


@pytest.fixture
def forge(session, path):
    """Writes the session with some entries changed, or left out where None."""

    def make(changes, compression=zipfile.ZIP_STORED):
        write_session(session, path)
        entries = entries_of(path) | changes
        with zipfile.ZipFile(path, "w", compression) as archive:
            for name, content in entries.items():
                if content is not None:
                    archive.writestr(name, content)
        return path

    return make


@pytest.fixture
def forge_header(session, path, forge):
    """Writes the session with fields of session.json changed, or left out where None."""

    def make(changes):
        write_session(session, path)
        header = json.loads(entries_of(path)["session.json"]) | changes
        header = {name: value for name, value in header.items() if value is not None}
        return forge({"session.json": json.dumps(header)})

    return make


def refused(path):
    with pytest.raises(Refused) as caught:
        read_session(path)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)
    return str(caught.value).removeprefix(str(path))


def same(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def test_the_format_is_the_one_that_others_rely_on(session, path):
    write_session(session, path)
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        assert all(info.compress_type == zipfile.ZIP_STORED for info in archive.infolist())
        assert sorted(archive.namelist()) == sorted(["session.json", *ARRAYS])
        header = json.loads(archive.read("session.json").decode("utf-8"))
        with np.load(path, allow_pickle=False) as arrays:
            for name in ARRAYS:
                array = arrays[name.removesuffix(".npy")]
                assert array.dtype == np.float64
                assert array.flags.c_contiguous
            assert np.array_equal(
                arrays["faces/lens.back"], session.result.state.heights["lens.back"]
            )
    assert header["format"] == "freeform-session"
    assert header["version"] == 3
    assert header["program"] == f"freeform-lens-workbench {__version__}"
    assert header["scene"] == session.scene.to_data()
    assert header["result"] == {
        "loss": session.result.state.loss,
        "iterations": 8,
        "seconds": 2.1,
        "efficiency": 0.7,
        "ledger": session.result.state.account.to_data(),
    }


def test_a_session_says_what_the_program_took(make_scene, rng, path):
    """The scene leaves the net to the program."""
    scene = make_scene({"lens.control_points": "auto", "screen.pixels": [8, 6]})
    session = Session(scene, rng.random((6, 8)))
    write_session(session, path)
    header = json.loads(entries_of(path)["session.json"])
    assert (header["version"], header["scene"]["version"]) == (3, 3)
    assert header["scene"]["elements"][0]["faces"][1]["control_points"] == "auto"
    assert header["control_points"] == [36, 27]
    assert read_session(path).scene == session.scene


@pytest.mark.parametrize("thickest", [2.0, math.inf])
def test_what_the_limits_kept_from_a_lens_comes_back(session, path, thickest):
    """In the far field, no screen limits the thickness."""
    short = Shortfall("min_thickness", None, (0.5, thickest), 0.3)
    write_session(replace(session, result=session.result.with_state(shortfall=short)), path)
    assert read_session(path).result.state.shortfall == short


class TestRefused:
    @pytest.mark.parametrize("part", [0.02, 0.3, 0.7, 0.99])
    def test_truncated(self, session, path, part):
        write_session(session, path)
        content = path.read_bytes()
        path.write_bytes(content[: int(part * len(content))])
        assert "damaged or incomplete zip" in refused(path)

    def test_a_flipped_bit(self, session, path):
        write_session(session, path)
        content = bytearray(path.read_bytes())
        content[content.index(session.target.tobytes()) + 5] ^= 4
        path.write_bytes(content)
        assert "Bad CRC-32" in refused(path)

    def test_a_zip_bomb(self, forge):
        path = forge({TARGET: bytes(100_000_000)}, zipfile.ZIP_DEFLATED)
        assert "is compressed" in refused(path)

    @pytest.mark.parametrize("name", ARRAYS)
    @pytest.mark.parametrize(
        "change, reason",
        [
            (lambda a: a[:-1], "has shape"),
            (lambda a: a[..., None], "has shape"),
            (lambda a: a.astype(np.float32), "holds float32; float64 is needed"),
            (lambda a: a.astype(">f8"), "float64 is needed"),
            (lambda a: a.astype(object), "float64 is needed"),
            (lambda a: np.where(a == a.flat[0], np.nan, a), "NaN or infinite"),
            (lambda a: np.where(a == a.flat[0], np.inf, a), "NaN or infinite"),
        ],
    )
    def test_a_wrong_array(self, session, path, forge, name, change, reason):
        write_session(session, path)
        array = np.load(io.BytesIO(entries_of(path)[name]))
        message = refused(forge({name: npy(change(array))}))
        assert message.startswith(f": {name}: ")
        assert reason in message

    @pytest.mark.parametrize(
        "changes, message",
        [
            ({"format": "freeform-scene"}, ": session.json: format: 'freeform-scene'"),
            ({"format": None}, ": session.json: format: missing"),
            ({"version": 0}, ": session.json: version: 0 is too small; at least 1"),
            ({"version": 4}, ": session.json: version: 4 is of a newer Freeform Lens Workbench"),
            ({"version": 4, "new": 3}, ": session.json: version: 4 is of a newer Freeform"),
            ({"scene": None}, ": session.json: scene: missing"),
            ({"scene": {"version": 3}}, ": session.json: source: missing"),
            ({"scene": {}}, ": session.json: lens: missing; it or mirror is required"),
            ({"scene": 3}, ": session.json: scene: "),
            ({"note": "mine"}, ": session.json: note: unknown field"),
            ({"result": {"loss": 1.0}}, ": session.json: result.iterations: missing"),
            ({"program": 3}, ": session.json: program: 3 is not text"),
        ],
    )
    def test_a_wrong_header(self, forge_header, changes, message):
        assert refused(forge_header(changes)).startswith(message)


class TestLedger:
    def test_losses_at_elements_come_back(self, session, path):
        at_elements = {
            "off_screen": 0.1,
            "missed_lens@dome": 0.125,
            "absorbed_mirror@fold_2": 0.075,
        }
        account = Account(0.7, at_elements)
        result = session.result.with_state(account=account)
        write_session(replace(session, result=result), path)
        header = json.loads(entries_of(path)["session.json"])
        assert header["result"]["ledger"] == {"emitted": 1, "on_screen": 0.7, **at_elements}
        assert read_session(path).result.state.account == account

    @pytest.mark.parametrize(
        ("changes", "message"),
        [
            ({"shade": 0.1}, ".shade: 'shade' is no part of a light account"),
            (
                {"absorbed@a b": 0.1},
                ".'absorbed@a b': 'absorbed@a b' is no part of a light account",
            ),
            ({"on_screen@lens": 0.1}, ".'on_screen@lens': 'on_screen@lens' is no part of a light"),
            ({"absorbed@lens": None}, ".'absorbed@lens': None is not a number"),
            ({"emitted": 0.0}, ": the parts emitted, greater than 0, and on_screen are needed"),
        ],
    )
    def test_what_is_no_account_is_refused(self, session, path, forge_header, changes, message):
        write_session(session, path)
        result = json.loads(entries_of(path)["session.json"])["result"]
        result["ledger"] |= changes
        expected = f": session.json: result.ledger{message}"
        assert refused(forge_header({"result": result})).startswith(expected)


@settings(
    max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(data=st.data())
def test_no_damage_gets_past_the_refusals(session, path, data):
    write_session(session, path)
    content = bytearray(path.read_bytes())
    for _ in range(data.draw(st.integers(1, 5))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    path.write_bytes(content)
    try:
        again = read_session(path)
    except Refused as refusal:
        assert "\n" not in str(refusal)
    else:
        assert same(again.target, session.target)
        assert same(
            again.result.state.heights["lens.back"], session.result.state.heights["lens.back"]
        )
