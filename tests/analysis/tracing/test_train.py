"""Elements that the check follows, and the aperture of a bent mirror."""

import pytest
import torch

from workbench.analysis.tracing.trace import Trace, added
from workbench.geometry.surface import freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.scene import Scene

TILTED = {"kind": "collimated", "direction": [20.0, -10.0]}


SCENES = {
    "mirror": {"mirror": {}, "source": TILTED},
    "mirror of an ellipse": {"mirror": {"outline": "ellipse"}, "source": TILTED},
    "mirror beside a point": {
        "mirror": {},
        "source": {"kind": "point", "position": [2.0, 0.0, -3.0]},
    },
    "mirror beside an emitter": {
        "mirror": {},
        "source": {"kind": "area", "center": [2.0, 0.0, -3.0], "half_width": [0.1, 0.1]},
    },
    "narrow beam on a mirror": {
        "mirror": {},
        "source": TILTED | {"profile": {"kind": "gaussian", "radius": 0.05}},
    },
}


def scene_of(parts):
    optic = {"half_width": [1.0, 1.0], "control_points": [8, 8]}
    data = {"mirror": optic | parts["mirror"], "source": parts["source"]}
    return Scene.from_data(
        data
        | {
            "format": "freeform-scene",
            "version": 2,
            "unit": "mm",
            "screen": {"z": -5.0, "half_width": [9.0, 9.0], "pixels": [16, 16]},
            "target": {"builtin": "tophat"},
        }
    )


@pytest.mark.parametrize("parts", SCENES.values(), ids=SCENES)
def test_as_much_light_reaches_a_bent_mirror_in_each_trace(parts):
    scene = scene_of(parts)
    x, y = freeform_nets(scene.optic)["mirror.face"].positions
    heights = {"mirror.face": 0.15 * x[:, None] ** 2 - 0.1 * y**2 + 0.1 * x[:, None]}
    run = BeamPlan(scene, (64, 64), dtype=torch.float64)
    account = run.trace({"mirror.face": torch.as_tensor(heights["mirror.face"])}).account
    assert min(account.on_screen, *account.lost.values()) > -1e-4
    total = None
    for tally in Trace(scene, heights, 60_000, 0).batches(1):
        total = added(total, tally)
    rays = float(total.flux.sum()) / total.emitted
    missed = total.lost["missed_mirror"] / total.emitted
    assert account.on_screen == pytest.approx(rays, abs=4e-3)
    assert account.lost["missed_mirror"] == pytest.approx(missed, abs=4e-3)
