"""Lenses of two freeform faces in the independent check."""

import numpy as np
import pytest
import torch

from workbench.analysis.cells.image import imaging
from workbench.analysis.validation import validate
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import freeform_nets
from workbench.optics.beam_plan import BeamPlan

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
        if name == "entrance":
            heights[name] += 0.12 * (x**2 + y**2)
    return heights


def finished(generator):
    while True:
        try:
            next(generator)
        except StopIteration as stop:
            return stop.value


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


@pytest.mark.parametrize("scene", ["collimated"], indirect=True)
def test_rays_and_the_design_see_the_same_light(scene):
    heights, target = lens_of(scene), np.ones((10, 12))
    traced = validate(scene, target, FaceArrays(heights), rays=400_000)
    tensors = {name: torch.tensor(each) for name, each in heights.items()}
    light = BeamPlan(scene, (200, 200), dtype=torch.float64).trace(tensors)
    designed = light.flux.numpy() / scene.receiver.pixel_measure
    size = np.linalg.norm(designed)
    assert np.linalg.norm(traced.irradiance - designed) < (2 * traced.noise + 2e-3) * size
    expected, found = light.account.to_data(), traced.account.to_data()
    for loss in ("fresnel_entrance", "fresnel_exit", "left_side", "missed_lens"):
        assert found[loss] == pytest.approx(expected[loss], abs=1e-3)
