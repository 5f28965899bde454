"""Two lenses that are designed together, one freeform face each."""

import zipfile

import numpy as np
import pytest
import torch

from workbench.analysis.validation import validate
from workbench.design.design_run import DesignRun
from workbench.design.limits import HeightLimits
from workbench.design.live import LiveDesign
from workbench.design.session import Session
from workbench.design.transport.shared import shared_start
from workbench.errors import Refused
from workbench.files.session import read_session, write_session
from workbench.geometry.surface import ControlNet, nets_of
from workbench.optics.plan import Plan
from workbench.scene import Scene
from workbench.scene.paths import with_values

FACES = [{"shape": "plane"}, {"shape": "bspline", "control_points": [24, 20]}]
LENS = {"kind": "lens", "material": {"index": 1.49}, "thickness": 4, "min_thickness": 1}
DATA = {
    "version": 3,
    "source": {"kind": "collimated", "rays": [128, 128]},
    "elements": [
        LENS | {"name": "first", "half_width": [10, 8], "faces": FACES},
        LENS | {"name": "second", "half_width": [16, 13], "faces": FACES, "position": [0, 0, 20]},
    ],
    "images": [
        {
            "receiver": {
                "kind": "plane",
                "position": [0, 0, 80],
                "half_width": [40, 30],
                "pixels": [64, 48],
            },
            "target": {"builtin": "tophat"},
        }
    ],
}


@pytest.fixture(scope="module")
def scene():
    return Scene.from_data(DATA)


@pytest.fixture(scope="module")
def target():
    """A bright spot that lies to one side in dim light."""
    row, column = np.mgrid[:48, :64]
    return 0.3 + np.exp(-np.square((row - 18) / 12) - np.square((column - 24) / 16))


@pytest.fixture(scope="module")
def designed(scene, target):
    run = DesignRun(Session(scene, target), iterations=6)
    for _ in run:
        pass
    return run.session


def test_both_lenses_take_part_in_the_deflection(scene, target):
    heights = shared_start(scene, target)
    assert list(heights) == list(nets_of(scene)) == ["first.back", "second.back"]
    steepest = []
    for face, net in nets_of(scene).items():
        x = net.positions[0]
        slope = np.diff(heights[face], axis=0) / np.diff(x)[:, None]
        steepest.append(np.abs(slope).max())
    assert min(steepest) > 0.5 * max(steepest) > 0.05


def test_a_wide_image_loses_little_by_total_reflection(scene, target):
    """Whole changes of the slopes would be too much there, and send half of the light nowhere."""
    wide = scene.receiver.model_copy(update={"half_width": (70.0, 52.0)})
    (image,) = scene.images
    scene = scene.model_copy(update={"images": (image.model_copy(update={"receiver": wide}),)})
    found = validate(scene, target, shared_start(scene, target), 30_000)
    reflected = [found.account.lost[f"total_reflection@{name}"] for name in ("first", "second")]
    assert 0 < sum(reflected) < 0.03
    assert found.relative_l2_corrected < 0.2


def test_the_design_is_as_the_independent_check_finds_it(designed, scene, target):
    state = designed.result.state
    norm = np.linalg.norm(target / target.sum())
    seen = state.loss * target.size**0.5 / norm
    found = validate(scene, target, state.heights, 400_000)
    assert found.relative_l2_corrected == pytest.approx(seen, abs=0.01)
    assert seen < 0.06
    assert found.efficiency == pytest.approx(state.account.efficiency, abs=2e-3)


def test_lenses_stay_within_limits_clear_of_each_other(designed, scene):
    heights, limits = designed.heights, HeightLimits.of_scene(scene)
    for face, each in limits.items():
        assert each.hold(heights[face])
    assert limits["first.back"].upper.max() < scene.elements[1].lowest


def test_a_session_keeps_both_faces_in_the_coordinates_of_their_elements(designed, tmp_path):
    path = tmp_path / "two.freeform"
    write_session(designed, path)
    again = read_session(path)
    assert again.heights == designed.heights
    with zipfile.ZipFile(path) as archive, archive.open("faces/second.back.npy") as entry:
        np.testing.assert_allclose(np.load(entry) + 20, designed.heights["second.back"])


def test_both_faces_follow_a_lens_that_is_moved(designed):
    moved = with_values(designed.scene, {"elements[1].position": [0, 0, 26]})
    edited = designed.with_scene(moved, designed.target)
    lenses = LiveDesign().snapshots(edited, before=designed)
    present, first = next(lenses).state, next(lenses).state
    lenses.close()
    assert present.heights == edited.heights
    assert set(first.heights) == {"first.back", "second.back"}
    assert first.loss < 0.6 * present.loss


@pytest.mark.parametrize("cells", [None, (24, 24)])
def test_gradients_of_both_faces_by_central_differences(scene, target, cells, rng):
    """In random directions, compiled in float64, against differences and the torch walk."""
    heights = {
        face: torch.tensor(each.undesigned + 0.1 * rng.normal(size=each.undesigned.shape))
        for face, each in HeightLimits.of_scene(scene).items()
    }
    weights = torch.tensor(rng.normal(size=(48, 64)))
    net = ControlNet.of(scene.optic)

    def figure(plan, z):
        return (plan.trace(z).flux.double() * weights).sum()

    plans = [Plan(scene, net, dtype=torch.float64, fused=fused, samples=cells) for fused in (1, 0)]
    gradients = []
    for plan in plans:
        leaves = {face: z.clone().requires_grad_() for face, z in heights.items()}
        figure(plan, leaves).backward()
        gradients.append({face: leaf.grad for face, leaf in leaves.items()})
    for face in heights:
        scale = gradients[1][face].abs().max()
        assert torch.allclose(gradients[0][face], gradients[1][face], atol=1e-9 * scale)
        way = torch.tensor(rng.normal(size=heights[face].shape))
        ends = [figure(plans[1], heights | {face: heights[face] + s * way}) for s in (-1e-6, 1e-6)]
        slope = float(ends[1] - ends[0]) / 2e-6
        assert float((gradients[0][face] * way).sum()) == pytest.approx(slope, rel=1e-3)


def test_elements_in_each_other_are_refused():
    first, second = DATA["elements"]
    with pytest.raises(Refused, match="reaches into first") as caught:
        Scene.from_data(DATA | {"elements": [first, second | {"position": [0, 0, 2]}]})
    assert caught.value.path == "elements[1].position[2]"
