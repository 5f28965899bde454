"""Whatever is wrong with the input: exit status 2, one line, nothing lost, no run begun."""

import json
import os
import shutil
import tempfile
from pathlib import Path

import numpy as np
import pytest

from tests.scenes import changed
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


class TestScene:
    @pytest.mark.parametrize(
        "part, field, value, reason",
        [
            ("lens", "colour", "red", "lens.colour: unknown field"),
            ("screen", "z", -1.0, "screen.z: -1 may touch the lens"),
        ],
    )
    def test_unknown_and_impossible_fields(
        self, refusal, scene_file, scene_data, out, part, field, value, reason
    ):
        scene_data[part][field] = value
        scene_file.write_text(json.dumps(scene_data))
        assert refusal("design", scene_file, "-o", out).startswith(reason)
        assert not out.exists()

    def test_no_file(self, refusal, tmp_path, out):
        missing = tmp_path / "missing.json"
        assert refusal("design", missing, "-o", out).startswith(f"{missing}: does not exist")
        assert refusal("design", tmp_path, "-o", out).startswith(f"{tmp_path}: is a folder")


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
    write_session(Session(scene, np.ones((32, 32)), start=FaceArrays({"lens.back": start})), path)
    verb, *tail = command
    stated = refusal(verb, path, *tail)
    assert "its lens was designed for another task" in stated
    assert "goes on from it" in stated


class TestOutput:
    def test_missing_folder(self, refusal, scene_file, tmp_path):
        stderr = refusal("design", scene_file, "-o", tmp_path / "missing" / "lens.freeform")
        assert stderr.endswith("cannot be written: its folder does not exist")

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
