"""Light of a lens with an elliptic outline: what is beside it misses the lens, exactly by area."""

import math

import numpy as np
import pytest
import torch

from tests.analysis.lenses import net_of
from workbench.geometry.outlines import Ellipse
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.paths import ray_paths
from workbench.optics.plan import Plan

POINT = {"kind": "point", "position": [0.1, -0.2, -4.0], "rays": 1 << 16}
ROUND = {"lens.outline": "ellipse", "lens.half_width": [1.0, 0.8]}


def plate(scene):
    return {"lens.back": torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64)}


def test_the_image_of_a_plate_is_the_ellipse(make_scene):
    """Pixels that the rim does not cut are dark, or as bright as those behind a rectangle."""
    scene = make_scene(ROUND | {"screen.pixels": [40, 32]})
    image, _ = BeamPlan(scene, (320, 320), dtype=torch.float64).trace(plate(scene))
    x, y = np.linspace(-1, 1, 41), np.linspace(1, -1, 33)[:, None]
    inside = Ellipse((1.0, 0.8)).area_inside((x[:-1], x[1:]), (y[1:], y[:-1]))
    expected = torch.tensor(inside) / (4 * 0.8) * 0.96**2
    assert (image - expected).abs().max() < 0.01 * expected.max()
    assert (image - expected).abs().sum() < 1e-3 * expected.sum()


def test_slanted_rays_that_meet_the_wall_leave_by_the_side(make_scene):
    scene = make_scene(ROUND | {"source": POINT | {"position": [0, 0, -1.0]}})
    wide = make_scene(
        ROUND | {"source": POINT | {"position": [0, 0, -1.0]}, "lens.outline": "rectangle"}
    )
    found, whole = (
        Plan(each, dtype=torch.float64).trace(plate(each)).account.lost for each in (scene, wide)
    )
    assert found["left_side"] > 0.05
    assert found["missed_lens"] > whole["missed_lens"] + 0.05


@pytest.mark.parametrize("source", [{"kind": "collimated"}, POINT])
def test_the_gradient_at_the_rim_is_that_of_differences(make_scene, source, rng):
    scene = make_scene(ROUND | {"source": source, "lens.control_points": [9, 8]})
    heights = 0.5 + 0.01 * torch.tensor(rng.standard_normal((9, 8)))
    plan = BeamPlan(scene, (40, 36), dtype=torch.float64)
    cotangent = torch.tensor(rng.standard_normal((32, 32)))

    def value(heights):
        return (plan.trace({"lens.back": heights}).flux * cotangent).sum()

    leaf = heights.clone().requires_grad_()
    (gradient,) = torch.autograd.grad(value(leaf), leaf)
    for i, j in ((4, 0), (1, 1), (8, 4), (7, 6)):
        step = torch.zeros_like(heights)
        step[i, j] = 1e-6
        differences = (value(heights + step) - value(heights - step)) / 2e-6
        assert gradient[i, j].item() == pytest.approx(differences.item(), rel=1e-4, abs=1e-7)


def test_a_round_plano_convex_lens_focuses_like_its_closed_form(make_scene):
    """Parallel light enters a flat face and leaves a sphere: Snell's law, ray by ray."""
    radius, n, height = 3.0, 1.5, 0.6
    base = {"shape": "sphere", "height": height, "radius": radius, "form": "convex"}
    focus = height + radius / (n - 1)  # of rays near the axis
    changes = {"lens.base": base, "lens.control_points": [40, 40], "lens.degree": [5, 5]}
    screen = {"z": focus, "half_width": [0.4, 0.4], "pixels": [64, 64]}
    changes |= {"lens.outline": "ellipse", "lens.height_range": [-0.5, 0.5], "screen": screen}
    scene = make_scene(changes)
    lens = {"lens.back": net_of(scene, scene.optic.base.height_at)}
    paths = ray_paths(scene, lens, (15, 15))
    _, _, exits, hits = paths.points.transpose(1, 0, 2)
    h = np.hypot(exits[:, 0], exits[:, 1])
    inside = np.arcsin(h / radius)  # angle to the normal
    deflection = np.arcsin(n * h / radius) - inside
    place = height - radius + np.sqrt(radius**2 - h**2)
    expected = (focus - place) * np.tan(deflection) - h  # beyond the axis, as they meet it before
    np.testing.assert_allclose(np.hypot(hits[:, 0], hits[:, 1]), expected, atol=1e-6)
    widest = (focus - (height - radius + math.sqrt(8))) * math.tan(
        math.asin(n / radius) - math.asin(1 / radius)
    ) - 1
    image, account = BeamPlan(scene, (200, 200), dtype=torch.float64).trace(
        {"lens.back": torch.tensor(lens["lens.back"])}
    )
    x = (np.arange(64) + 0.5) / 64 * 0.8 - 0.4
    lit = image.numpy() > 1e-9
    assert np.hypot(x, x[:, None])[lit].max() == pytest.approx(
        widest, abs=0.02
    )  # a pixel and a cell
    assert account.lost["off_screen"] == pytest.approx(0, abs=1e-12)
