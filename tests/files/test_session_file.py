import io
import json
import os
import zipfile
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.accounts import account_of
from workbench import __version__
from workbench.design.lens_state import LensState
from workbench.design.shortfall import Shortfall
from workbench.design.snapshot import Result
from workbench.errors import Refused
from workbench.files import atomic
from workbench.files.session import (
    Session,
    is_session,
    open_design,
    read_session,
    write_session,
)
from workbench.geometry.faces import FaceArrays

ARRAYS = ["target.npy", "control_points.npy", "irradiance.npy", "loss.npy"]


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene({"lens.control_points": [5, 4], "screen.pixels": [7, 6]})
    result = Result(
        LensState(
            heights=FaceArrays({"exit": rng.random((5, 4))}),
            irradiance=rng.random((6, 7)) / 3,
            loss=1 / 3,
            account=account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1 - 1e-17),
        ),
        losses=rng.random(8),
        seconds=2.1,
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


class TestRoundTrip:
    def test_everything_comes_back_exactly(self, session, path):
        write_session(session, path)
        again = read_session(path)
        assert again.scene == session.scene
        assert same(again.target, session.target)
        assert same(again.result.state.heights["exit"], session.result.state.heights["exit"])
        assert same(again.result.state.irradiance, session.result.state.irradiance)
        assert same(again.result.losses, session.result.losses)
        assert again.result.state.loss == session.result.state.loss
        assert again.result.seconds == session.result.seconds
        assert again.result.state.account == session.result.state.account

    def test_without_a_result(self, session, path):
        write_session(Session(session.scene, session.target), path)
        assert sorted(entries_of(path)) == ["session.json", "target.npy"]
        again = read_session(path)
        assert again.result is None
        assert same(again.target, session.target)

    def test_a_lens_whose_limits_are_too_narrow(self, session, path):
        short = Shortfall("height_range", (-2.0, 3.0), (-0.3, 0.3), 0.25)
        for each in (short, replace(short, cause="max_thickness", needed=None)):
            result = session.result.with_state(shortfall=each)
            write_session(replace(session, result=result), path)
            assert read_session(path).result.state.shortfall == each

    def test_a_run_of_no_iterations(self, session, path):
        result = replace(session.result, losses=np.zeros(0))
        write_session(Session(session.scene, session.target, result), path)
        assert read_session(path).result.losses.shape == (0,)

    def test_arrays_in_any_order_and_precision_are_stored_in_c_order(self, session, path):
        target = np.asfortranarray(session.target.astype(np.float32))
        write_session(Session(session.scene, target), path)
        assert same(read_session(path).target, np.ascontiguousarray(target, dtype=np.float64))

    def test_the_same_session_gives_the_same_bytes(self, session, path):
        write_session(session, path)
        first = path.read_bytes()
        write_session(read_session(path), path)
        assert path.read_bytes() == first


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
            assert np.array_equal(arrays["control_points"], session.result.state.heights["exit"])
    assert header["format"] == "freeform-session"
    assert header["version"] == 1
    assert header["program"] == f"freeform-lens-workbench {__version__}"
    assert header["scene"] == session.scene.to_data()
    assert header["result"] == {
        "loss": session.result.state.loss,
        "iterations": 8,
        "seconds": 2.1,
        "efficiency": 0.7,
        "ledger": session.result.state.account.to_data(),
    }


def test_an_image_goes_along_with_the_file(session, tmp_path, path):
    target = {"image": str(tmp_path / "images" / "flame.png")}
    scene = session.scene.from_data(session.scene.to_data() | {"target": target})
    write_session(Session(scene, session.target), path)
    assert b'"image": "images/flame.png"' in path.read_bytes()
    moved = tmp_path / "elsewhere"
    moved.mkdir()
    path.rename(moved / "lens.freeform")
    again = read_session(moved / "lens.freeform")
    assert again.scene.target.image == str(moved / "images" / "flame.png")


class TestWithScene:
    def test_run_settings_leave_the_result(self, session):
        run = session.scene.run.model_copy(update={"iterations": 5})
        scene = session.scene.model_copy(update={"run": run})
        again = session.with_scene(scene, session.target.copy())
        assert again.scene == scene
        assert again.result is session.result

    def test_another_task_removes_the_result(self, session, make_scene):
        scene = make_scene(
            {"lens.control_points": [5, 4], "screen.pixels": [7, 6], "screen.z": 6.0}
        )
        assert session.with_scene(scene, session.target).result is None

    def test_another_image_removes_the_result(self, session):
        assert session.with_scene(session.scene, session.target * 2).result is None


class TestOpenDesign:
    def test_a_session(self, session, path):
        write_session(session, path)
        found = open_design(path).result.state.heights["exit"]
        assert same(found, session.result.state.heights["exit"])

    def test_a_scene_with_its_target_whatever_its_name(self, path, make_scene):
        path.write_text(make_scene().to_json())
        opened = open_design(path)
        assert opened.scene == make_scene()
        assert opened.target.shape == (32, 32)
        assert opened.result is None

    def test_a_scene_whose_image_is_missing(self, path, scene_data):
        path.write_text(json.dumps(scene_data | {"target": {"image": "missing.png"}}))
        with pytest.raises(Refused, match=r"target\.image: .*missing\.png"):
            open_design(path)

    def test_sessions_and_scenes_are_distinguished_by_content(self, session, path, make_scene):
        write_session(session, path)
        assert is_session(path)
        path.write_bytes(path.read_bytes()[:30])
        assert is_session(path)
        path.write_text(make_scene().to_json())
        assert not is_session(path)
        path.write_bytes(b"")
        assert not is_session(path)
        with pytest.raises(Refused, match="does not exist"):
            is_session(path.with_name("missing"))


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

    def test_a_foreign_zip(self, path):
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("word/document.xml", "<xml/>")
        assert refused(path).startswith(": session.json: is missing")

    def test_an_empty_zip(self, path):
        zipfile.ZipFile(path, "w").close()
        assert refused(path).startswith(": session.json: is missing")

    @pytest.mark.parametrize("name", ["session.json", *ARRAYS])
    def test_a_missing_entry(self, forge, name):
        assert refused(forge({name: None})).startswith(f": {name}: is missing")

    def test_a_field_that_is_given_twice(self, session, path, forge):
        write_session(session, path)
        text = entries_of(path)["session.json"].replace(b'"z":', b'"z": 6.0, "z":')
        sentence = ": session.json: scene.screen.z: is given twice; each field can be there once"
        assert refused(forge({"session.json": text})) == sentence

    def test_an_unknown_entry(self, forge):
        assert refused(forge({"../evil": b""})).startswith(": '../evil': does not belong")

    def test_arrays_without_a_result(self, forge_header):
        assert "does not belong" in refused(forge_header({"result": None}))

    @pytest.mark.filterwarnings("ignore:Duplicate name")
    def test_an_entry_twice(self, session, path):
        write_session(session, path)
        with zipfile.ZipFile(path, "a") as archive:
            archive.writestr("target.npy", npy(session.target))
        assert "holds an entry twice" in refused(path)

    @pytest.mark.parametrize("name", ["session.json", *ARRAYS])
    def test_a_compressed_entry(self, session, path, forge, name):
        write_session(session, path)
        content = entries_of(path)[name]
        forge({name: None})
        with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(name, content)
        assert refused(path).startswith(f": {name}: is compressed")

    def test_a_zip_bomb(self, forge):
        path = forge({"target.npy": bytes(100_000_000)}, zipfile.ZIP_DEFLATED)
        assert "is compressed" in refused(path)

    @pytest.mark.parametrize("name", ["session.json", *ARRAYS])
    def test_an_entry_larger_than_it_can_be(self, forge, name):
        assert f": {name}: has 2000000 bytes; at most" in refused(forge({name: bytes(2_000_000)}))

    def test_a_claimed_size_beyond_the_file(self, forge_header, session):
        figures = {
            "loss": 1.0,
            "iterations": 10**11,
            "seconds": 1.0,
            "efficiency": 1.0,
            "ledger": session.result.state.account.to_data(),
        }
        path = forge_header({"result": figures})
        size = len(npy(session.result.losses)).to_bytes(4, "little")
        huge = (4 * 10**9).to_bytes(4, "little")
        content = path.read_bytes()
        at = content.rindex(b"loss.npy") - 46
        record = content[at:].replace(size, huge)
        path.write_bytes(content[:at] + record)
        assert refused(path) == ": loss.npy: is cut off"

    @pytest.mark.parametrize("value", [1e308, -1e308, 1e6])
    def test_a_pixel_with_more_than_all_light(self, session, path, forge, value):
        write_session(session, path)
        irradiance = session.result.state.irradiance.copy()
        irradiance[5, 2] = value
        message = refused(forge({"irradiance.npy": npy(irradiance)}))
        assert message == (
            f": irradiance.npy[5, 2]: {value:.5g} is more than all light of the source in this "
            "pixel; 10.5 would be all of it"
        )

    @pytest.mark.parametrize("height", [1e308, -1e308, 5001.0])
    def test_a_height_that_is_out_of_all_bounds(self, session, path, forge, height):
        write_session(session, path)
        heights = session.result.state.heights["exit"].copy()
        heights[1, 2] = height
        message = refused(forge({"control_points.npy": npy(heights)}))
        assert message == (
            f": control_points.npy[1, 2]: {height:.5g} is no height of this lens; at most 5000 cm "
            "from the entrance face are possible"
        )

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

    def test_fortran_order(self, session, forge):
        array = np.asfortranarray(session.target)
        assert "C order is needed" in refused(forge({"target.npy": npy(array)}))

    @pytest.mark.parametrize("content", [b"", b"\x93NUMPY", b"text", b"\x93NUMPY\x03\x00" * 20])
    def test_what_is_no_array(self, forge, content):
        assert "target.npy: is no .npy array" in refused(forge({"target.npy": content}))

    @pytest.mark.parametrize("change", [lambda c: c[:-8], lambda c: c + bytes(8)])
    def test_an_array_of_the_wrong_length(self, session, forge, change):
        message = refused(forge({"target.npy": change(npy(session.target))}))
        assert "shape (6, 7) needs 336" in message

    @pytest.mark.parametrize("peak", [1.7e308, 1e-310])
    def test_only_ratios_of_a_huge_or_tiny_target_count(self, forge, session, peak):
        ratios = session.target / session.target.max()
        found = read_session(forge({"target.npy": npy(peak * ratios)})).target
        np.testing.assert_allclose(found, ratios, atol=1e-12)
        assert not found.flags.writeable

    @pytest.mark.parametrize("target", [np.zeros((6, 7)), np.full((6, 7), -1.0)])
    def test_a_target_without_light(self, forge, target):
        assert "some light is needed" in refused(forge({"target.npy": npy(target)}))

    @pytest.mark.parametrize(
        "changes, message",
        [
            ({"format": "freeform-scene"}, ": session.json: format: 'freeform-scene'"),
            ({"format": None}, ": session.json: format: missing"),
            ({"version": 0}, ": session.json: version: 0 is too small; at least 1"),
            ({"version": 3}, ": session.json: version: 3 is of a newer Freeform Lens Workbench"),
            ({"version": 3, "new": 3}, ": session.json: version: 3 is of a newer Freeform"),
            ({"scene": None}, ": session.json: scene: missing"),
            ({"scene": {}}, ": session.json: source: missing"),
            ({"scene": 3}, ": session.json: scene: "),
            ({"note": "mine"}, ": session.json: note: unknown field"),
            ({"result": {"loss": 1.0}}, ": session.json: result.iterations: missing"),
            ({"program": 3}, ": session.json: program: 3 is not text"),
        ],
    )
    def test_a_wrong_header(self, forge_header, changes, message):
        assert refused(forge_header(changes)).startswith(message)

    @pytest.mark.parametrize("text", [b"", b"{", b"\xff\xfe", b"[]", b"NaN"])
    def test_a_header_that_is_no_object(self, forge, text):
        assert refused(forge({"session.json": text})).startswith(": session.json: text: ")

    def test_an_impossible_scene(self, forge_header, session):
        data = session.scene.to_data()
        data["lens"]["control_points"] = [3, 4]
        message = refused(forge_header({"scene": data}))
        assert message == (
            ": session.json: lens.control_points[0]: 3 is too few for degree 3; at least 4"
        )

    @pytest.mark.parametrize("name, value", [("loss", float("nan")), ("iterations", -1)])
    def test_an_impossible_figure(self, session, path, forge_header, name, value):
        write_session(session, path)
        figures = json.loads(entries_of(path)["session.json"])["result"]
        message = refused(forge_header({"result": figures | {name: value}}))
        assert message.startswith(f": session.json: result.{name}: ")

    def test_an_unknown_part_of_the_account(self, session, path, forge_header):
        write_session(session, path)
        figures = json.loads(entries_of(path)["session.json"])["result"]
        figures["ledger"]["lost"] = 0.0
        message = refused(forge_header({"result": figures}))
        assert message.startswith(": session.json: result.ledger.lost: unknown field")

    def test_a_scene_file(self, path, make_scene):
        path.write_text(make_scene().to_json())
        assert refused(path) == ": is no session: it does not begin like a zip"

    def test_no_file(self, path, tmp_path):
        assert "does not exist" in refused(path)
        assert "is a folder" in refused(tmp_path)


@settings(
    max_examples=300,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
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
        assert same(again.result.state.heights["exit"], session.result.state.heights["exit"])


def test_a_disk_that_fails_leaves_the_old_session(session, path, monkeypatch, tmp_path):
    write_session(session, path)
    before = path.read_bytes()

    class FullDisk(io.FileIO):
        def write(self, content):
            raise OSError(28, "No space left on device")

    def open_full(self, mode):
        return io.BufferedWriter(FullDisk(self, mode), 512)

    with monkeypatch.context() as patch:
        patch.setattr(atomic.Path, "open", open_full)
        with pytest.raises(Refused, match="No space left on device"):
            write_session(Session(session.scene, session.target), path)
    assert path.read_bytes() == before
    assert os.listdir(tmp_path) == ["lens.freeform"]


def test_stages_of_a_run_are_kept(session, path):
    staged = replace(session.result, stage_starts=(2,), stages_left=1)
    write_session(replace(session, result=staged), path)
    found = read_session(path).result
    assert (found.stage_starts, found.stages_left) == ((2,), 1)
    write_session(session, path)
    assert read_session(path).result.stages_left == 0


def test_an_account_from_before_there_was_light_through_the_side(session, path, forge_header):
    write_session(session, path)
    figures = json.loads(entries_of(path)["session.json"])["result"]
    del figures["ledger"]["left_side"]
    assert (
        read_session(forge_header({"result": figures})).result.state.account.lost["left_side"] == 0
    )
