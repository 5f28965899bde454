"""No command writes over what it reads, nor one file twice: status 2, and every byte stays."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from PIL import Image


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def picture(folder):
    """A target image under the name of a picture of the lens."""
    Image.fromarray(np.full((8, 8), 200, dtype=np.uint8)).save("lens.png")
    return Path("lens.png")


@pytest.fixture
def scene(folder, scene_data, picture):
    """A scene with that image."""
    path = Path("scene.json")
    path.write_text(json.dumps(scene_data | {"target": {"image": str(picture)}}))
    return path


@pytest.fixture
def session(folder, lens):
    """A session with a flat lens."""
    return lens.relative_to(folder)


@pytest.fixture
def refused(freeform, folder):
    """Runs a command that is refused for a file; no file of the folder changes."""

    def contents():
        return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    def run(*arguments):
        before = contents()
        status, stdout, stderr = freeform(*arguments)
        assert (status, stdout) == (2, "")
        assert stderr.count("\n") == 1
        assert contents() == before
        return stderr.removeprefix("freeform: ").rstrip("\n")

    return run


PLOTS = [
    ("manufacture", "{}", "--plot"),
    ("tolerances", "{}", "--tilt", "1", "--plot"),
    ("validate", "{}", "--through-focus", "4:6:2", "--plot"),
]


@pytest.mark.parametrize("command", [*PLOTS, ("report", "{}")])
def test_the_session_is_not_replaced(refused, session, command):
    shutil.copy(session, "same.html")
    arguments = [part.format("same.html") for part in command]
    assert (
        refused(*arguments, "same.html")
        == "same.html: is the session itself; another file is needed"
    )


def test_pictures_do_not_replace_the_session(refused, session):
    shutil.copy(session, "loss.png")
    assert refused("pictures", "loss.png", ".").startswith("loss.png: is the session itself")


def test_a_design_does_not_replace_its_scene_or_image(refused, scene, picture):
    assert "is the scene itself" in refused("design", scene, "-o", scene)
    stderr = refused("design", scene, "-o", picture)
    assert stderr == f"{picture}: is the target image of {scene}; another file is needed"
