"""Light of origins right before fixed faces, sampled by directions."""

import pytest
import torch

from workbench.analysis.tracing.trace import Trace, added
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.path import Path
from workbench.optics.sampled import SampledTrain
from workbench.optics.samples import Corners
from workbench.scene import Scene


def under_a_dome(center=(0.0, 0.0, -10.0)):
    """An LED right before a dome, and a lens behind it that bends its light."""
    dome = {
        "kind": "lens",
        "name": "dome",
        "position": [0, 0, -9.9],
        "half_width": [2.4, 2.4],
        "outline": "ellipse",
        "material": {"index": 1.41},
        "thickness": 2.5,
        "faces": [{"shape": "plane"}, {"shape": "conic", "radius": -2.5}],
    }
    lens = {
        "kind": "lens",
        "name": "lens",
        "half_width": [12, 12],
        "outline": "ellipse",
        "material": {"index": 1.49},
        "thickness": 5,
        "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": [9, 8]}],
    }
    receiver = {"kind": "plane", "position": [0, 0, 100], "half_width": [100, 80]}
    scene = Scene.from_data(
        {
            "format": "freeform-scene",
            "version": 3,
            "unit": "mm",
            "source": {
                "kind": "area",
                "position": list(center),
                "half_width": [0.5, 0.4],
            },
            "elements": [dome, lens],
            "images": [
                {"receiver": receiver | {"pixels": [20, 16]}, "target": {"builtin": "tophat"}}
            ],
        }
    )
    ((face, net),) = freeform_nets(scene.optic).items()
    x, y = (torch.linspace(-1, 1, n, dtype=torch.float64) for n in net.shape)
    return scene, {face: 5.0 - 0.8 * x[:, None] ** 2 - 1.2 * y**2 + 0.4 * x[:, None] * y}


CENTERS = pytest.mark.parametrize("center", [(0.0, 0.0, -10.0), (0.3, -0.2, -10.0)])


@CENTERS
def test_the_check_finds_the_light_of_few_beams(center):
    scene, heights = under_a_dome(center)
    found = {face: each.numpy() for face, each in heights.items()}
    tally = None
    for batch in Trace(scene, found, 400_000, 1).batches(2):
        tally = added(tally, batch) if batch is not None else tally
    drawn = torch.as_tensor(tally.flux.reshape(16, 20) / tally.emitted)
    for cells in (Corners(64, 64, 64), Corners.and_of_source(64, 64, (4, 4))):
        light = BeamPlan(scene, cells, dtype=torch.float64).trace(heights)
        assert (light.flux - drawn).norm().item() < 0.03 * drawn.norm().item()
        assert light.account.on_screen + sum(light.account.lost.values()) == pytest.approx(1)
        for key, lost in tally.lost.items():
            assert light.account.lost[key] == pytest.approx(lost / tally.emitted, abs=6e-3), key


@CENTERS
def test_light_of_a_sample_meets_again_on_the_designed_face(center):
    scene, _ = under_a_dome(center)
    cells = Corners.and_of_source(8, 8, (4, 4))
    train = SampledTrain.of(Path.of(scene, ControlNet.of(scene.optic), samples=cells))
    x, y, _ = (part.reshape(9, 25, 9) for part in train.followed().rays.position)
    for axis in (x, y):
        meets = axis[3:6, :, 3:6]
        assert (meets.amax(1) - meets.amin(1)).max() < 0.4  # 1.4 mm in even directions
        assert meets.amax() - meets.amin() > 3.5
