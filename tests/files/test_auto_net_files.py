"""Sessions of scenes that leave the net to the program: what it took stands in the file."""

import json
import zipfile
from dataclasses import replace

import numpy as np
import pytest

from tests.accounts import account_of
from workbench.design.lens_state import LensState
from workbench.design.snapshot import Result
from workbench.files.scene import read_scene, write_scene
from workbench.files.session import Session, read_session, write_session
from workbench.geometry.faces import FaceArrays


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene({"lens.control_points": "auto", "screen.pixels": [8, 6]})
    return Session(scene, rng.random((6, 8)))


@pytest.fixture
def path(tmp_path):
    return tmp_path / "lens.freeform"


def result_on(shape, rng):
    account = account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1)
    heights = FaceArrays({"exit": 0.5 + 0.01 * rng.random(shape)})
    return Result(LensState(heights, rng.random((6, 8)), 0.5, account), rng.random(3), 1.0)


def header_of(path):
    with zipfile.ZipFile(path) as archive:
        return json.loads(archive.read("session.json"))


def test_a_session_says_what_the_program_took(session, path):
    write_session(session, path)
    header = header_of(path)
    assert (header["version"], header["scene"]["version"]) == (2, 2)
    assert header["scene"]["lens"]["control_points"] == "auto"
    assert header["control_points"] == [20, 15]
    assert read_session(path).scene == session.scene


def test_a_lens_keeps_the_net_that_was_chosen_for_it(session, path, rng):
    """Another program, or a later one, may choose another net for the same task."""
    other = replace(session, scene=session.scene.with_net((10, 7)), result=result_on((10, 7), rng))
    write_session(other, path)
    again = read_session(path)
    assert again.scene.optic.net_shape == (10, 7)
    np.testing.assert_array_equal(again.heights["exit"], other.heights["exit"])


def test_scene_files_hold_auto_and_nothing_else(session, tmp_path):
    path = tmp_path / "scene.json"
    write_scene(session.scene, path)
    assert read_scene(path) == session.scene.with_net(None)
    assert json.loads(path.read_text())["version"] == 2
