"""Sessions of mirrors keep the face in an entry of the mirror's name."""

import io
import json
import zipfile

import numpy as np
import pytest

from tests.accounts import account_of
from workbench.design.lens_state import LensState
from workbench.design.snapshot import Result
from workbench.files.session import Session, read_session, write_session
from workbench.geometry.faces import FaceArrays
from workbench.scene import Scene


@pytest.fixture
def session(rng):
    scene = Scene.from_data(
        {
            "mirror": {"half_width": [1.0, 0.7], "control_points": [7, 6], "reflectance": 0.9},
            "source": {"kind": "collimated"},
            "screen": {"z": -5.0, "center": [2.0, 0.0], "half_width": [1.0, 1.0], "pixels": [4, 4]},
            "target": {"builtin": "tophat"},
        }
    )
    state = LensState(
        heights=FaceArrays({"mirror.face": 0.05 * rng.normal(size=(7, 6))}),
        irradiance=0.01 * rng.random((4, 4)),
        loss=0.1,
        account=account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1),
    )
    result = Result(state, losses=np.full(1, 0.1), seconds=1.0)
    return Session(scene, np.ones((4, 4)), result)


def test_a_mirror_comes_back_from_its_session(session, tmp_path):
    path = tmp_path / "mirror.freeform"
    write_session(session, path)
    with zipfile.ZipFile(path) as archive:
        header = json.loads(archive.read("session.json"))
        heights = np.load(io.BytesIO(archive.read("faces/mirror.face.npy")))
    assert [element["kind"] for element in header["scene"]["elements"]] == ["mirror"]
    np.testing.assert_array_equal(heights, session.heights["mirror.face"])
    again = read_session(path)
    assert again.scene == session.scene
    np.testing.assert_array_equal(again.heights["mirror.face"], heights)
