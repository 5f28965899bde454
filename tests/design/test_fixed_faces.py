"""B-spline faces that a design leaves as they are, with control heights from a file."""

import io
import json
from dataclasses import replace

import numpy as np
import pytest

from workbench.analysis.validation import validate
from workbench.design.design_run import DesignRun
from workbench.design.limits import HeightLimits
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


def written(folder):
    """A scene, and beside it the heights of a face that makes light diverge."""
    x, y = np.linspace(-1, 1, 9)[:, None], np.linspace(-1, 1, 7)
    np.save(folder / "bowl.npy", 4 + 0.9 * (x**2 + 0.7 * y**2))
    (folder / "scene.json").write_text(json.dumps(DATA))
    return folder


@pytest.fixture
def folder(tmp_path):
    return written(tmp_path)


def designed(session):
    run = DesignRun(session)
    for _ in run:
        pass
    return run.session


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    """The design of the scene."""
    return designed(open_design(written(tmp_path_factory.mktemp("fixed")) / "scene.json"))


def test_a_fixed_face_stays_as_its_file_says_and_the_other_one_makes_the_image(folder, found):
    assert found.scene.elements[0].faces[1].control_points == (9, 7)
    given = np.load(folder / "bowl.npy")
    np.testing.assert_allclose(found.heights["stock.back"], given, atol=1e-12)
    norm = np.linalg.norm(found.target / found.target.sum())
    seen = found.result.state.loss * found.target.size**0.5 / norm
    assert seen < 0.35  # a disc with a sharp edge on a coarse net
    check = validate(found.scene, found.target, found.heights, 400_000)
    assert check.relative_l2_corrected == pytest.approx(seen, abs=0.02)
    assert check.efficiency == pytest.approx(found.result.state.account.efficiency, abs=3e-3)


def test_a_session_keeps_the_file_of_a_fixed_face(found, tmp_path):
    write_session(found, tmp_path / "found.freeform")
    again = read_session(tmp_path / "found.freeform")
    assert again.heights == found.heights
    assert designed(again).heights["stock.back"].shape == (9, 7)


def test_a_designed_face_that_becomes_fixed_keeps_its_heights(folder, found):
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


def test_an_uneven_fixed_face_is_traced_as_a_whole_before_an_even_target(folder):
    x, y = np.linspace(-1, 1, 9)[:, None], np.linspace(-1, 1, 7)
    np.save(folder / "bowl.npy", 4 + 0.4 * x + 0.5 * x**2 * (1 + 0.3 * x) + 0.2 * y**2)
    begun = open_design(folder / "scene.json")
    even = replace(begun, target=np.ones_like(begun.target))
    for snapshot in DesignRun(even, iterations=2):
        assert not any("mirror symmetry: a quarter" in note for note in snapshot.notes)
    found = validate(even.scene, even.target, snapshot.state.heights, 400_000)
    seen = snapshot.state.loss * even.target.size  # of an even target
    assert found.relative_l2_corrected == pytest.approx(seen, abs=0.01)


def test_heights_without_a_file_keep_their_place_in_another_unit(folder):
    begun = open_design(folder / "scene.json")
    with pytest.raises(Refused, match=r"bowl\.npy are in the unit") as caught:
        begun.scene.in_unit("cm")
    assert caught.value.path == "unit"
    data = begun.scene.to_data()
    del data["elements"][0]["faces"][1]["heights"]
    scene = Scene.from_data(data)
    kept = scene.with_fixed_heights("stock.back", (folder / "bowl.npy").read_bytes())
    in_cm = HeightLimits.of_scene(kept.in_unit("cm"))["stock.back"].undesigned
    np.testing.assert_allclose(10 * in_cm, np.load(folder / "bowl.npy"))
