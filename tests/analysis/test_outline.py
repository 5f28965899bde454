"""The independent check of lenses with an elliptic outline."""

import math

import numpy as np
import pytest
import torch

from tests.analysis.lenses import net_of
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources import light_source
from workbench.analysis.tracing.trace import BATCHES
from workbench.analysis.validation import validate
from workbench.optics.beam_plan import BeamPlan

POINT = {"kind": "point", "position": [0.3, -0.2, -3.0]}
ROUND = {"lens.outline": "ellipse", "lens.half_width": [1.0, 0.8]}


def wavy(scene):
    return {"exit": net_of(scene, lambda x, y: 0.5 - 0.1 * x**2 + 0.04 * np.sin(x + 2 * y))}


@pytest.mark.parametrize("source", [{"kind": "collimated"}, POINT], ids=["collimated", "point"])
def test_cells_rays_and_the_design_see_the_same_light(make_scene, source):
    scene = make_scene(ROUND | {"source": source, "screen.half_width": [1.5, 1.5]})
    lens = wavy(scene)
    found = validate(scene, np.ones((32, 32)), lens, rays=400_000, accuracy=1e-3)
    assert sum(found.account.to_data().values()) == pytest.approx(2, abs=1e-9)  # and emitted: 1
    assert found.by_cells.difference_over_noise == pytest.approx(1, abs=0.15)
    assert found.by_cells.bound < 1e-3
    plan = BeamPlan(scene, (400, 400), dtype=torch.float64)
    image, account = plan.trace({"exit": torch.tensor(lens["exit"])})
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
