"""Lenses whose exit face is out of its place over the entrance face, and rough entrance faces."""

import math

import numpy as np
import pytest

from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.train import OpticalTrain
from workbench.geometry.surface import ControlNet

INDEX = 1.5
FREEFORM = {"shape": "freeform", "control_points": [6, 6], "height_range": [-0.2, 0.2]}


def leaving(scene, heights, pose, x=0.0, y=0.0):
    """Direction behind the lens of the ray along the axis through (x, y), and where it leaves."""
    train = OpticalTrain.of(scene, heights, 1, 0, pose, [scene.receiver])
    rays = TracedRays(np.array([[x, y, -1.0]]), np.array([[0.0, 0.0, 1.0]]), np.ones(1))
    found = train.leaving(rays)
    assert found.flux[0] > 0
    return found.direction[0], found.position[0]


@pytest.mark.parametrize("tilt", [(0.02, 0.0), (0.0, -0.05), (0.03, 0.04)])
def test_light_through_a_plate_with_a_tilted_face_is_bent_as_by_a_prism(make_scene, tilt):
    plate = {"exit": np.full((12, 10), 0.5)}
    direction, _ = leaving(make_scene(), plate, Pose(exit_tilt=tilt))
    angle = math.hypot(*tilt)
    away = math.asin(INDEX * math.sin(angle)) - angle
    # Turned about x the normal leans to -y, about y to +x; light goes the other way.
    leans = np.array([tilt[1], -tilt[0]]) / angle
    assert direction[:2] == pytest.approx(-math.sin(away) * leans, abs=1e-15)


def test_an_afocal_pair_bends_by_what_one_face_is_tilted(make_scene):
    """Two alike wedges undo each other; the exit face then deviates as a thin prism does."""
    scene = make_scene({"version": 2, "lens.entrance": FREEFORM})
    heights = {}
    for face, shape, z in (("entrance", (6, 6), 0.0), ("exit", (12, 10), 0.5)):
        x, _ = ControlNet(shape, (3, 3), scene.optic.half_width).positions
        heights[face] = np.tile(z + 0.1 * x[:, None], (1, shape[1]))
    straight, _ = leaving(scene, heights, Pose())
    assert straight == pytest.approx([0.0, 0.0, 1.0], abs=1e-14)
    small = 1e-4
    deflected, _ = leaving(scene, heights, Pose(exit_tilt=(0.0, small)))
    slope = math.atan(0.1)
    inside, outside = math.cos(math.asin(math.sin(slope) / INDEX)), math.cos(slope)
    assert deflected[0] == pytest.approx(-(INDEX * inside / outside - 1) * small, rel=1e-3)
    assert deflected[0] == pytest.approx(-(INDEX - 1) * small, rel=0.01)


def test_a_ray_meets_a_decentred_face_where_it_met_the_face_beside(make_scene, rng):
    heights, shift = {"exit": 0.5 + 0.05 * rng.random((12, 10))}, (0.07, -0.04)
    scene = make_scene()
    there, place = leaving(scene, heights, Pose(exit_decentre=shift), 0.3, 0.2)
    here, beside = leaving(scene, heights, Pose(), 0.3 - shift[0], 0.2 - shift[1])
    assert there == pytest.approx(here, abs=1e-14)
    assert place - beside == pytest.approx([*shift, 0.0], abs=1e-14)
