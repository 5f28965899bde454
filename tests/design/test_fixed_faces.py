"""B-spline faces that a design leaves as they are, with control heights from a file."""

import io
import json

import numpy as np
import pytest

from workbench.analysis.validation import validate
from workbench.design.design_run import DesignRun
from workbench.design.task import with_task
from workbench.errors import Refused
from workbench.files.session import open_design, read_session, write_session
from workbench.scene import Scene

FIXED = {"shape": "bspline", "fixed": True, "heights": "bowl.npy", "control_points": "auto"}
LENS = {"kind": "lens", "material": {"index": 1.49}, "thickness": 4, "min_thickness": 1}
DESIGNED = {"shape": "bspline", "control_points": [24, 20]}
RECEIVER = {
    "kind": "plane",
    "position": [0, 0, 80],
    "half_width": [20, 15],
    "pixels": [48, 36],
}
DATA = {
    "version": 3,
    "source": {"kind": "collimated"},
    "elements": [
        LENS | {"name": "stock", "half_width": [10, 8], "faces": [{"shape": "plane"}, FIXED]},
        LENS
        | {
            "name": "lens",
            "half_width": [14, 12],
            "faces": [{"shape": "plane"}, DESIGNED],
            "position": [0, 0, 12],
        },
    ],
    "images": [{"receiver": RECEIVER, "target": {"builtin": "tophat"}}],
    "run": {"iterations": 5},
}


@pytest.fixture
def folder(tmp_path):
    """A scene, and beside it the heights of a face that makes light diverge."""
    x, y = np.linspace(-1, 1, 9)[:, None], np.linspace(-1, 1, 7)
    np.save(tmp_path / "bowl.npy", 4 + 0.9 * (x**2 + 0.7 * y**2))
    (tmp_path / "scene.json").write_text(json.dumps(DATA))
    return tmp_path


def designed(session):
    run = DesignRun(session)
    for _ in run:
        pass
    return run.session


def test_a_fixed_face_stays_as_its_file_says_and_the_other_one_makes_the_image(folder):
    begun = open_design(folder / "scene.json")
    assert begun.scene.elements[0].faces[1].control_points == (9, 7)
    found = designed(begun)
    given = np.load(folder / "bowl.npy")
    np.testing.assert_allclose(found.heights["stock.back"], given, atol=1e-12)
    norm = np.linalg.norm(found.target / found.target.sum())
    seen = found.result.state.loss * found.target.size**0.5 / norm
    assert seen < 0.35  # a disc with a sharp edge on a coarse net
    check = validate(found.scene, found.target, found.heights, 400_000)
    assert check.relative_l2_corrected == pytest.approx(seen, abs=0.02)
    assert check.efficiency == pytest.approx(found.result.state.account.efficiency, abs=3e-3)


def test_a_session_keeps_the_file_of_a_fixed_face(folder):
    found = designed(open_design(folder / "scene.json"))
    write_session(found, folder / "found.freeform")
    (folder / "bowl.npy").unlink()
    again = read_session(folder / "found.freeform")
    assert again.heights == found.heights
    assert designed(again).heights["stock.back"].shape == (9, 7)


def test_a_designed_face_that_becomes_fixed_keeps_its_heights(folder):
    found = designed(open_design(folder / "scene.json"))
    data = found.scene.to_data()
    data["elements"][1]["faces"][1]["fixed"] = True
    data["elements"][0]["faces"][1] |= {"fixed": False, "heights": None}
    edited = with_task(found, Scene.from_data(data), folder)
    on = designed(edited)
    np.testing.assert_allclose(on.heights["lens.back"], found.heights["lens.back"], atol=1e-12)
    assert np.abs(on.heights["stock.back"] - found.heights["stock.back"]).max() > 1e-6


def refusal(folder, content=None, changes=None):
    data = json.loads(json.dumps(DATA))
    data["elements"][0]["faces"][1] |= changes or {}
    if content is not None:
        (folder / "bowl.npy").write_bytes(content)
    (folder / "scene.json").write_text(json.dumps(data))
    with pytest.raises(Refused) as caught:
        designed(open_design(folder / "scene.json"))
    return caught.value


def array_file(values):
    file = io.BytesIO()
    np.save(file, values)
    return file.getvalue()


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"no array", "no array of control heights"),
        (array_file(np.full((9, 7), np.nan)), "no array of control heights"),
        (array_file(np.zeros(9)), "no array of control heights"),
        (array_file(np.zeros((3, 7))), "too few for degree 3"),
    ],
)
def test_a_file_without_control_heights_is_refused_at_its_field(folder, content, reason):
    refused = refusal(folder, content)
    assert refused.path.startswith("elements[0].faces[1].heights")
    assert reason in refused.reason


def test_other_numbers_of_control_points_and_missing_heights_are_refused(folder):
    assert "9 × 7" in refusal(folder, changes={"control_points": [9, 8]}).reason
    missing = refusal(folder, changes={"heights": None, "control_points": [9, 7]})
    assert (missing.path, "are missing" in missing.reason) == (
        "elements[0].faces[1].heights",
        True,
    )
