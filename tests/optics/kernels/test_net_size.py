"""Heights of a net of another size are refused by compiled traces, which would read beyond them."""

import pytest
import torch

from workbench.geometry.surface import freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import Plan
from workbench.scene import Scene

LENS = {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [9, 8]}
POINT = {"kind": "point", "position": [0.1, 0, -3]}
SUN = {"kind": "collimated", "angular_diameter": 0.5}
REST = {
    "source": {"kind": "collimated", "rays": [16, 16]},
    "target": {"builtin": "tophat"},
    "version": 2,
}
FAR, NEAR = ({"z": z, "half_width": [1, 1], "pixels": [8, 8]} for z in (6, -6))
TWO_FACES = LENS | {"entrance": {"shape": "freeform", "control_points": [7, 6]}}

BEAMS = {
    "collimated": ({"lens": LENS, "screen": FAR}, "lens.back"),
    "mirror": (
        {"mirror": {"half_width": [1, 1], "control_points": [9, 8]}, "screen": NEAR},
        "mirror.face",
    ),
    "face": ({"lens": LENS, "screen": FAR, "source": POINT}, "lens.back"),
    "origins": ({"lens": LENS, "screen": FAR, "source": SUN}, "lens.back"),
    "two faces": ({"lens": TWO_FACES, "screen": FAR}, "lens.front"),
    "two faces, the second": ({"lens": TWO_FACES, "screen": FAR}, "lens.back"),
}
RAYS = {name: BEAMS[name] for name in ("collimated", "mirror")} | {
    "point": ({"lens": LENS, "screen": FAR, "source": POINT | {"rays": 500}}, "lens.back")
}


def refused(plan, scene, face):
    """Trace lenses on larger, smaller and turned nets; what is stated of each, and what fits."""
    assert plan.notes[0].startswith("fused")
    nets = freeform_nets(scene.optic)
    heights = {
        name: torch.full(net.shape, 0.5 * (name == "lens.back")) for name, net in nets.items()
    }
    plan.trace(heights)
    n_u, n_v = nets[face].shape
    for shape in ((n_u + 90, n_v + 90), (n_u - 2, n_v - 2), (n_v, n_u), (n_u,)):
        theirs = " × ".join(map(str, shape))
        with pytest.raises(
            ValueError, match=rf"traces {n_u} × {n_v} control heights, not {theirs}$"
        ):
            plan.trace(heights | {face: torch.zeros(shape)})


@pytest.mark.parametrize("kernel", BEAMS)
def test_beams_refuse_heights_of_a_net_of_another_size(kernel):
    data, face = BEAMS[kernel]
    scene = Scene.from_data(REST | data)
    plan = BeamPlan(scene, (6, 6))
    refused(plan, scene, face)


@pytest.mark.parametrize("kernel", RAYS)
def test_rays_refuse_heights_of_a_net_of_another_size(kernel):
    data, face = RAYS[kernel]
    scene = Scene.from_data(REST | data)
    plan = Plan(scene)
    refused(plan, scene, face)
