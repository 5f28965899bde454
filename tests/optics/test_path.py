"""The walk along a path: what elements promise, and what the path makes of them."""

import pytest
import torch

from tests.optics.points import GRID, POINT, smooth
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Passed
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import Plane

COLLIMATED = {"kind": "collimated", "rays": [40, 30]}
SOURCES = pytest.mark.parametrize(
    "source", [COLLIMATED, POINT, GRID], ids=["collimated", "point", "grid"]
)


class Unchanged:
    """An interface that lets all light pass straight on."""

    compiled = False

    def turn(self, rays, meeting):
        flux = torch.where(meeting.met, rays.flux, 0.0)
        return Passed(RayBundle(meeting.position, rays.direction, flux, meeting.met), {})


@SOURCES
def test_a_plate_in_pieces_is_the_plate(make_scene, source):
    """Two planes in the glass that let all light pass change no ray."""
    scene = make_scene({"source": source})
    net = ControlNet.of(scene.optic)
    whole = Path.of(scene, net, torch.float64)
    between = [
        FaceStep(Plane(f"inner {z}", z - whole.datum, Rectangle((9.0, 9.0))), Unchanged(), "aside")
        for z in (0.1, 0.2)
    ]
    entrance, *rest = whole.steps
    pieces = Path(
        whole.emitter,
        [entrance, *between, *rest],
        whole.receiver,
        datum=whole.datum,
        outline=whole.outline,
        seed=0,
        dtype=torch.float64,
    )
    heights = {"lens.back": smooth(scene)}
    one, other = whole.walk(heights), pieces.walk(heights)
    for here, there in zip(
        (one.column, one.row, one.rays.flux),
        (other.column, other.row, other.rays.flux),
        strict=True,
    ):
        assert torch.allclose(here, there, rtol=0, atol=1e-12)
    assert other.lost["aside"].item() == 0
