"""Elliptic outlines and screens at other distances in the check."""

import math

import numpy as np
import pytest
import torch

from tests.analysis.lenses import net_of
from workbench.analysis.focus import focus_series, screen_at, with_screen_at
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources import light_source
from workbench.analysis.tracing.trace import BATCHES
from workbench.analysis.validation import validate
from workbench.errors import Refused
from workbench.optics.beam_plan import BeamPlan


@pytest.fixture
def scene(make_scene):
    return make_scene({"lens.control_points": [8, 8], "screen.pixels": [16, 16]})


@pytest.fixture
def lens(make_scene, rng):
    scene = make_scene({"screen.pixels": [16, 12], "screen.half_width": [0.8, 0.9]})
    return scene, np.ones((12, 16)), {"lens.back": 0.5 + 0.05 * rng.random((12, 10))}


def test_each_distance_as_if_the_screen_stood_there(lens):
    found = list(focus_series(*lens, (3.0, 5.0, 7.5), 20_000))
    assert [each.z for each in found] == [3.0, 5.0, 7.5]
    for each in found:
        alone = validate(*lens, 20_000, screen_z=each.z)
        assert each.relative_l2 == pytest.approx(alone.relative_l2, rel=1e-9)
        assert each.efficiency == pytest.approx(alone.efficiency, rel=1e-9)
        assert each.irradiance == pytest.approx(alone.irradiance, rel=1e-9)


def test_within_the_lens(lens):
    with pytest.raises(Refused, match=r"images\[0\]\.receiver\.position\[2\]: 0\.7 may touch"):
        list(focus_series(*lens, (5.0, 0.7), 100))


def test_parts_of_the_way_to_the_screen_clear_the_lens(make_scene):
    scene, flat = make_scene(), np.full((12, 10), 0.5)
    top = scene.optic.highest
    assert screen_at(scene, {"lens.back": flat}, 1) == scene.receiver.z
    assert screen_at(scene, {"lens.back": flat}, 0.5) - top == pytest.approx(
        (scene.receiver.z - top) / 2
    )
    with_screen_at(scene, screen_at(scene, {"lens.back": flat}, 1e-6))
    with pytest.raises(Refused, match="may touch the lens"):
        with_screen_at(scene, screen_at(scene, {"lens.back": flat}, 0))


POINT = {"kind": "point", "position": [0.3, -0.2, -3.0]}


ROUND = {"lens.outline": "ellipse", "lens.half_width": [1.0, 0.8]}


def wavy(scene):
    return {"lens.back": net_of(scene, lambda x, y: 0.5 - 0.1 * x**2 + 0.04 * np.sin(x + 2 * y))}


@pytest.mark.parametrize("source", [{"kind": "collimated"}, POINT], ids=["collimated", "point"])
def test_cells_rays_and_the_design_see_the_same_light(make_scene, source):
    scene = make_scene(ROUND | {"source": source, "screen.half_width": [1.5, 1.5]})
    lens = wavy(scene)
    found = validate(scene, np.ones((32, 32)), lens, rays=400_000, accuracy=1e-3)
    assert sum(found.account.to_data().values()) == pytest.approx(2, abs=1e-9)  # and emitted: 1
    assert found.by_cells.difference_over_noise == pytest.approx(1, abs=0.15)
    assert found.by_cells.bound < 1e-3
    plan = BeamPlan(scene, (400, 400), dtype=torch.float64)
    image, account = plan.trace({"lens.back": torch.tensor(lens["lens.back"])})
    irradiance = image.numpy() / scene.receiver.pixel_measure
    exact = found.by_cells.irradiance
    assert np.linalg.norm(irradiance - exact) < 3e-3 * np.linalg.norm(exact)
    for name, flux in account.to_data().items():
        assert flux == pytest.approx(found.account.to_data()[name], abs=1e-3), name


def test_parallel_light_beside_the_ellipse_is_counted_without_a_ray(make_scene):
    scene = make_scene(ROUND)
    found = validate(scene, np.ones((32, 32)), wavy(scene), rays=1000)
    assert found.account.lost["missed_lens"] == pytest.approx(1 - math.pi / 4, abs=1e-12)
    assert found.account.lost["left_side"] == 0


def test_rays_fill_the_ellipse_evenly(make_scene):
    lens = make_scene(ROUND).optic
    light = light_source(make_scene(ROUND).source, lens, Pose(), 40_000, 1)
    places = np.vstack([r.position for n in range(BATCHES) for r in light.batch(n)])
    x, y = places[:, 0], places[:, 1] / 0.8
    assert (x**2 + y**2 <= 1).all()
    assert np.mean(x**2) == pytest.approx(0.25, abs=1e-3)
    assert np.mean(y**2) == pytest.approx(0.25, abs=1e-3)
    assert np.mean((x > 0) & (y > 0)) == pytest.approx(0.25, abs=1e-3)
