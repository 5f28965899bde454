"""Whatever is wrong with the input: exit status 2, one line, nothing lost, no run begun."""

import json
import os
import shutil
import tempfile
import zipfile
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.scenes import changed
from workbench.cli.verbs.kinds import count
from workbench.files.session import Session, write_session
from workbench.geometry.faces import FaceArrays
from workbench.scene import Scene


@pytest.fixture(autouse=True)
def no_run(monkeypatch):
    def run(*_):
        pytest.fail("a run began")
        yield

    monkeypatch.setattr("workbench.design.run.run", run)


@pytest.fixture
def refusal(freeform):
    """Runs a command that is refused; gives the reason."""

    def run(*arguments):
        status, stdout, stderr = freeform(*arguments)
        assert (status, stdout) == (2, "")
        assert stderr.startswith("freeform: ")
        assert stderr.count("\n") == 1
        return stderr.removeprefix("freeform: ").rstrip("\n")

    return run


@pytest.fixture
def session_file(tmp_path, make_scene):
    path = tmp_path / "begun.freeform"
    write_session(Session(make_scene(), np.ones((32, 32))), path)
    return path


@pytest.mark.parametrize(
    "arguments, reason",
    [
        ([], "COMMAND"),
        (["frobnicate"], "frobnicate"),
        (["design"], "SCENE"),
        (["design", "scene.json"], "-o"),
        (["design", "scene.json", "-o", "o", "--iterations", "many"], "many"),
        (["design", "scene.json", "-o", "o", "--seconds", "0"], "a number greater than 0"),
        (["design", "scene.json", "-o", "o", "--seconds", "nan"], "a number greater than 0"),
        (["design", "scene.json", "-o", "o", "--seconds", "soon"], "'soon'"),
        (["design", "scene.json", "-o", "o", "--iter", "3"], "--iter"),
        (["validate"], "SESSION"),
        (["validate", "o", "--rays", "0"], "a whole number greater than 0"),
        (["validate", "o", "--rays", "2.5"], "'2.5'"),
        (["validate", "o", "--rays", "1e-3"], "'1e-3'"),
        (["validate", "o", "--rays", "1e99"], "'1e99'"),
        (["pictures", "o"], "FOLDER"),
    ],
)
def test_wrong_use(refusal, arguments, reason):
    stderr = refusal(*arguments)
    assert stderr.startswith("usage: ")
    assert reason in stderr


@pytest.mark.parametrize(
    "text, number", [("1000", 1000), ("1e6", 1_000_000), ("1.5e3", 1500), ("2.0", 2)]
)
def test_counts_may_have_an_exponent(text, number):
    assert count(text) == number


class TestScene:
    @pytest.mark.parametrize(
        "part, field, value, reason",
        [
            ("lens", "colour", "red", "lens.colour: unknown field"),
            ("lens", "control_points", [3, 9], "lens.control_points[0]: 3 is too few"),
            ("lens", "refractive_index", 0.9, "lens.refractive_index: 0.9"),
            ("source", "kind", "laser", "source.kind: 'laser' is not available"),
            ("screen", "z", -1.0, "screen.z: -1 may touch the lens"),
            ("screen", "pixels", [0, 8], "screen.pixels[0]: 0 is too small"),
            ("run", "method", "magic", "run.method: 'magic' is not available"),
        ],
    )
    def test_unknown_and_impossible_fields(
        self, refusal, scene_file, scene_data, out, part, field, value, reason
    ):
        scene_data[part][field] = value
        scene_file.write_text(json.dumps(scene_data))
        assert refusal("design", scene_file, "-o", out).startswith(reason)
        assert not out.exists()

    @pytest.mark.parametrize("content", [b"", b"{", b"null", b"\xff\xd8\xff\xe0", b"\0" * 100])
    def test_no_scene_at_all(self, refusal, scene_file, out, content):
        scene_file.write_bytes(content)
        assert str(scene_file) in refusal("design", scene_file, "-o", out)

    def test_no_file(self, refusal, tmp_path, out):
        missing = tmp_path / "missing.json"
        assert refusal("design", missing, "-o", out).startswith(f"{missing}: does not exist")
        assert refusal("design", tmp_path, "-o", out).startswith(f"{tmp_path}: is a folder")

    @pytest.mark.parametrize("iterations", [-1, 10**9])
    def test_impossible_iterations(self, refusal, scene_file, out, iterations):
        stderr = refusal("design", scene_file, "-o", out, f"--iterations={iterations}")
        assert stderr.startswith(f"run.iterations: {iterations} is too")


class TestTarget:
    @pytest.fixture
    def with_image(self, refusal, scene_file, scene_data, out):
        def run(name):
            scene_data["target"] = {"image": name}
            scene_file.write_text(json.dumps(scene_data))
            stderr = refusal("design", scene_file, "-o", out)
            assert stderr.startswith("target.image: ")
            assert name in stderr
            return stderr

        return run

    def test_missing(self, with_image):
        with_image("missing.png")

    def test_control_characters_are_printed_escaped(self, refusal, scene_file, scene_data, out):
        scene_data["target"] = {"image": "a\x1b[2J\u202e.png"}
        scene_file.write_text(json.dumps(scene_data))
        stderr = refusal("design", scene_file, "-o", out)
        assert stderr.isprintable()
        assert r"a\x1b[2J\u202e.png" in stderr

    def test_folder(self, with_image, tmp_path):
        (tmp_path / "folder.png").mkdir()
        with_image("folder.png")

    def test_no_image(self, with_image, tmp_path):
        (tmp_path / "letter.png").write_text("Dear reader,\nthis is no image.")
        with_image("letter.png")

    def test_truncated(self, with_image, tmp_path, rng):
        pixels = rng.integers(0, 255, (64, 64), dtype=np.uint8)
        Image.fromarray(pixels).save(tmp_path / "half.png")
        content = (tmp_path / "half.png").read_bytes()
        (tmp_path / "half.png").write_bytes(content[: len(content) // 2])
        with_image("half.png")

    def test_all_black(self, with_image, tmp_path):
        Image.new("L", (8, 8)).save(tmp_path / "night.png")
        assert "black" in with_image("night.png")

    def test_nan(self, with_image, tmp_path):
        np.save(tmp_path / "hole.npy", np.array([[1.0, np.nan]]))
        assert "NaN" in with_image("hole.npy")

    def test_objects(self, with_image, tmp_path):
        np.save(tmp_path / "pickle.npy", np.array([[1, None]]), allow_pickle=True)
        with_image("pickle.npy")


@pytest.mark.parametrize("command", ["design", "validate", "pictures"])
class TestSession:
    @pytest.fixture
    def stderr(self, refusal, session_file, out, tmp_path, command):
        def run():
            tail = {"design": ["-o", out], "validate": [], "pictures": [tmp_path / "folder"]}
            return refusal(command, session_file, *tail[command])

        return run

    def test_truncated(self, stderr, session_file):
        session_file.write_bytes(session_file.read_bytes()[:-100])
        assert stderr().startswith(f"{session_file}: is a damaged or incomplete zip")

    def test_foreign_zip(self, stderr, session_file):
        with zipfile.ZipFile(session_file, "w") as archive:
            archive.writestr("mimetype", "application/epub+zip")
        assert stderr().startswith(f"{session_file}: session.json: is missing")


@pytest.mark.parametrize("command", [["validate"], ["pictures", "folder"]])
def test_commands_that_need_a_lens(refusal, session_file, scene_file, command):
    verb, *tail = command
    assert refusal(verb, session_file, *tail).startswith(f"{session_file}: holds no lens yet")
    assert refusal(verb, scene_file, *tail).startswith(f"{scene_file}: is no session")


@pytest.mark.parametrize("command", [["validate"], ["export", "lens.stl"], ["report", "lens.html"]])
def test_commands_say_that_the_task_was_edited_after_the_run(refusal, tmp_path, command):
    scene = Scene.from_data(changed({"target.blur": 1.0}))
    path = tmp_path / "edited.freeform"
    start = np.full(scene.optic.net_shape, 0.5)
    write_session(Session(scene, np.ones((32, 32)), start=FaceArrays({"exit": start})), path)
    verb, *tail = command
    said = refusal(verb, path, *tail)
    assert "its lens was designed for another task" in said
    assert "goes on from it" in said


class TestOutput:
    def test_missing_folder(self, refusal, scene_file, tmp_path):
        stderr = refusal("design", scene_file, "-o", tmp_path / "missing" / "lens.freeform")
        assert stderr.endswith("cannot be written: its folder does not exist")

    def test_a_folder(self, refusal, scene_file, tmp_path):
        stderr = refusal("design", scene_file, "-o", tmp_path)
        assert stderr.endswith("cannot be written: a folder of that name is there")

    def test_the_scene_itself(self, refusal, scene_file):
        before = scene_file.read_bytes()
        assert "is the scene itself" in refusal("design", scene_file, "-o", scene_file)
        assert scene_file.read_bytes() == before

    def test_read_only_folder(self, refusal, make_scene):
        folder = Path(tempfile.mkdtemp())
        (folder / "scene.json").write_text(make_scene().to_json())
        (folder / "lens.freeform").write_bytes(b"old")
        folder.chmod(0o555)
        before = os.geteuid()
        os.seteuid(before or 65534)  # root may write everywhere
        try:
            stderr = refusal("design", folder / "scene.json", "-o", folder / "lens.freeform")
        finally:
            os.seteuid(before)
            content = (folder / "lens.freeform").read_bytes()
            folder.chmod(0o755)
            shutil.rmtree(folder)
        assert "cannot be written" in stderr
        assert content == b"old"


def test_a_picture_folder_that_is_a_file(refusal, freeform, scene_file, out, fake_run):
    fake_run({})
    assert freeform("design", scene_file, "-o", out)[0] == 0
    stderr = refusal("pictures", out, scene_file)
    assert stderr == f"{scene_file}: cannot be made: File exists"
