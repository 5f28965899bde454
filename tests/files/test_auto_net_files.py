"""Sessions of scenes that leave the net to the program: what it took stands in the file."""

import json
import zipfile

import pytest

from workbench.files.session import Session, read_session, write_session


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene({"lens.control_points": "auto", "screen.pixels": [8, 6]})
    return Session(scene, rng.random((6, 8)))


@pytest.fixture
def path(tmp_path):
    return tmp_path / "lens.freeform"


def header_of(path):
    with zipfile.ZipFile(path) as archive:
        return json.loads(archive.read("session.json"))


def test_a_session_says_what_the_program_took(session, path):
    write_session(session, path)
    header = header_of(path)
    assert (header["version"], header["scene"]["version"]) == (3, 3)
    assert header["scene"]["elements"][0]["faces"][1]["control_points"] == "auto"
    assert header["control_points"] == [20, 15]
    assert read_session(path).scene == session.scene
