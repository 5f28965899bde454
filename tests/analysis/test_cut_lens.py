"""Light through what a cutter leaves."""

import numpy as np
import pytest

from workbench.analysis.cut_lens import tracing_cut
from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import freeform_nets
from workbench.watch import finished


@pytest.fixture
def scene(make_scene):
    return make_scene({"lens.control_points": [8, 8], "screen.pixels": [16, 16]})


def raster_of(scene, heights, radius, scallop):
    face = CutFace(freeform_nets(scene.optic)["exit"], heights, outline_of(scene.optic))
    return finished(face.plan_raster(radius, scallop, 10**6))


def test_a_fine_cut_leaves_the_image_and_a_coarse_one_does_not(scene):
    heights = np.full((8, 8), 0.5)
    target = np.ones((16, 16))
    target[4:12] = 3.0  # a plate lights the screen evenly: its error is known
    wanted, even = target / target.sum(), 1 / target.size
    error = np.linalg.norm(wanted - even) / np.linalg.norm(wanted)
    fine, coarse = (
        finished(tracing_cut(scene, {"exit": heights}, target, raster, 100_000))
        for raster in (raster_of(scene, heights, 0.5, scallop) for scallop in (1e-4, 0.05))
    )
    assert fine.designed.distance == pytest.approx(error, abs=3 * fine.designed.off + 1e-9)
    assert fine.cut.distance == pytest.approx(error, abs=0.02)
    assert abs(coarse.cut.distance - error) > 0.05
    assert f"as designed {100 * coarse.designed.distance:.3g} %" in coarse.sentence


def test_ridges_turn_light_by_their_slope(scene):
    """On a plane between two cuts the face leans by half their distance over the radius."""
    heights = np.full((8, 8), 0.5)
    raster = raster_of(scene, heights, 0.5, 1e-3)
    apart = raster.y[1] - raster.y[0]
    between = raster.y[3] + 0.4999 * apart
    height, normal = raster.cut(np.zeros(1), np.array([between]))
    assert abs(normal[0, 1]) == pytest.approx(apart / 2 / 0.5, rel=1e-2)
    assert height == pytest.approx(0.5 + 0.5 - np.sqrt(0.25 - (apart / 2) ** 2), abs=1e-6)
