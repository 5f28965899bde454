"""The check of lenses of two freeform faces, and of faces out of place."""

import math

import numpy as np
import pytest
import torch

from workbench.analysis.cells.image import imaging
from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.train import OpticalTrain
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.progress import finished

INDEX = 1.5


FREEFORM = {"shape": "freeform", "control_points": [6, 6], "height_range": [-0.2, 0.2]}


def leaving(scene, heights, pose, x=0.0, y=0.0):
    """Direction behind the lens of the ray along the axis through (x, y), and where it leaves."""
    train = OpticalTrain.of(scene, heights, 1, 0, pose, [scene.receiver])
    rays = TracedRays(np.array([[x, y, -1.0]]), np.array([[0.0, 0.0, 1.0]]), np.ones(1))
    found, _ = train.leaving(rays)
    assert found.flux[0] > 0
    return found.direction[0], found.position[0]


@pytest.mark.parametrize("tilt", [(0.02, 0.0), (0.0, -0.05), (0.03, 0.04)])
def test_light_through_a_plate_with_a_tilted_face_is_bent_as_by_a_prism(make_scene, tilt):
    plate = {"lens.back": np.full((12, 10), 0.5)}
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
    for face, shape, z in (("lens.front", (6, 6), 0.0), ("lens.back", (12, 10), 0.5)):
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


SOURCES = {
    "collimated": {"kind": "collimated", "rays": [64, 64]},
    "tilted": {"kind": "collimated", "rays": [64, 64], "direction": [5, -3]},
    "point": {"kind": "point", "position": [0.1, 0, -9], "rays": 1000},
}


def lens_of(scene):
    """Heights of two faces with some waves; the first gathers light, so that none leaves aside."""
    heights = {}
    for (name, net), z in zip(freeform_nets(scene.optic).items(), (0.0, 0.6), strict=True):
        x, y = net.positions[0][:, None], net.positions[1]
        heights[name] = z + 0.01 * np.sin(2 * x + len(name)) * np.cos(3 * y)
        if name == "lens.front":
            heights[name] += 0.12 * (x**2 + y**2)
    return heights


@pytest.fixture(params=SOURCES)
def scene(request, make_scene):
    entrance = {"shape": "freeform", "control_points": [7, 9], "height_range": [-0.05, 0.3]}
    return make_scene(
        {
            "version": 2,
            "lens.entrance": entrance,
            "lens.base": {"shape": "flat", "height": 0.6},
            "source": SOURCES[request.param],
            "screen.half_width": [1.4, 1.4],
            "screen.pixels": [12, 10],
        }
    )


def test_cells_and_the_design_see_the_same_light(scene):
    heights = lens_of(scene)
    cells = finished(imaging(scene, FaceArrays(heights), accuracy=0.005))
    tensors = {name: torch.tensor(each) for name, each in heights.items()}
    light = BeamPlan(scene, (200, 200), dtype=torch.float64).trace(tensors)
    designed = light.flux.numpy() / scene.receiver.pixel_measure
    # Of cells at the rim from which some light leaves through the side, the design draws none; the
    # light of cells that the aperture cuts is spread over all of them.
    cut = 1e-3 if scene.source.kind == "collimated" else 1e-2
    tolerance = 1e-4 if scene.source.along_axis else cut
    assert np.linalg.norm(cells.irradiance - designed) < tolerance * np.linalg.norm(designed)
