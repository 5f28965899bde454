"""The independent check of lenses lit by points."""

import numpy as np
import pytest
import torch

from workbench.analysis.validation import validate
from workbench.optics.plan import Plan
from workbench.scene import BoxFilter

POINT = {"kind": "point", "position": [0.4, -0.3, -2.0]}
GRID = {"kind": "grid", "center": [0.1, 0, -2], "half_width": [0.5, 1], "points": [3, 4]}


def uniform(scene):
    n_x, n_y = scene.receiver.pixels
    return np.ones((n_y, n_x))


@pytest.fixture(params=["wavy", "rough"])
def heights(request, rng):
    """A smooth lens, and one so steep that some rays could meet it several times."""
    amplitude = {"wavy": 0.05, "rough": 0.6}[request.param]
    return 0.5 + amplitude * (rng.random((12, 10)) - 0.5)


@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
@pytest.mark.parametrize("source", [POINT, GRID], ids=["point", "grid"])
def test_the_optimisers_trace_agrees(make_scene, heights, source, emission):
    rays = 1 << 16 if source is POINT else (1 << 16) // 12
    scene = make_scene(
        {
            "source": source | {"emission": emission, "rays": rays},
            "screen.half_width": [2.0, 1.5],
            "screen.pixels": [4, 3],
        }
    )
    found = validate(scene, uniform(scene), {"lens.back": heights}, 1 << 16)
    traced = Plan(scene, filter=BoxFilter(), dtype=torch.float64).trace(
        {"lens.back": torch.tensor(heights)}
    )
    for name, value in found.account.to_data().items():
        assert value == pytest.approx(traced.account.to_data()[name], abs=5e-3)
    expected = traced.flux.numpy() / scene.receiver.pixel_measure
    error = np.linalg.norm(found.irradiance - expected) / np.linalg.norm(expected)
    assert error < 0.06
    emitted, *parts = found.account.to_data().values()
    assert sum(parts) == pytest.approx(emitted, abs=1e-12)


@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
def test_a_grid_is_the_sum_of_its_points_with_equal_intensity(make_scene, emission):
    grid = {"kind": "grid", "center": [0.5, 0, -0.6], "half_width": [1.2, 0], "points": [2, 1]}
    view = {"screen.half_width": [16.0, 16.0], "screen.pixels": [4, 4]}
    heights = np.full((12, 10), 0.5)
    scene = make_scene(view | {"source": grid | {"emission": emission}})
    both = validate(scene, uniform(scene), {"lens.back": heights}, 1 << 18)
    light, irradiance = 0.0, 0.0
    for x in (-0.7, 1.7):
        point = {"kind": "point", "position": [x, 0, -0.6], "emission": emission}
        one = make_scene(view | {"source": point})
        found = validate(one, uniform(one), {"lens.back": heights}, 1 << 18)
        # What enters by the face as the point sees it: by numbers, not by the cone.
        t = (np.arange(400) + 0.5) / 200 - 1
        away2 = (t[:, None] - x) ** 2 + t**2 + 0.36
        power = 4 if emission == "lambertian" else 3
        entering = (0.6 ** (power - 2) / away2 ** (power / 2)).sum()
        flux = entering / (1 - found.account.lost["missed_lens"])
        light, irradiance = light + flux, irradiance + flux * found.irradiance
    assert both.irradiance == pytest.approx(irradiance / light, rel=0.02, abs=1e-5)
