"""The price of bends: right in itself, the same in any unit, and obeyed by both methods."""

import numpy as np
import pytest
import torch

from workbench.analysis.manufacture import manufacture
from workbench.design.run import run
from workbench.design.smoothness import Smoothness
from workbench.geometry.surface import ControlNet

CPU = torch.device("cpu")
DISC = (np.hypot(*np.meshgrid(np.linspace(-1, 1, 32), np.linspace(-1, 1, 32))) < 0.6).astype(float)


def smoothness_of(scene):
    found = Smoothness.of(scene, DISC, CPU)
    assert found is not None
    return found


def best(scene):
    return [s for s in run(scene, DISC) if s.best][-1]


def tightest(scene, heights):
    found = manufacture(scene.optic, {"lens.back": heights})
    return min(found.tightest_concave.value, found.tightest_convex.value)


def quadratic(scene, r, s, t):
    """Control heights of d = r x²/2 + s xy + t y²/2 over the base, which is flat here."""
    net = ControlNet.of(scene.optic)
    x, y = net.positions
    # Blossoms of x² and y² at the inner knots give the coefficients (Farin, section 8.6).
    squares = []
    for knots, p, r_ in zip(net.knots, net.degree, net.half_width, strict=True):
        places = (2 * knots - 1) * r_
        inner = np.array([places[i + 1 : i + p + 1] for i in range(len(places) - p - 1)])
        pairs = inner.sum(1) ** 2 - (inner**2).sum(1)
        squares.append(pairs / (p * (p - 1)))
    height = scene.optic.base.height
    curved = r / 2 * squares[0][:, None] + t / 2 * squares[1] + s * x[:, None] * y
    return torch.as_tensor(height + curved)


@pytest.mark.parametrize("degree", [(2, 2), (3, 3), (4, 2)])
def test_bending_energy_of_a_quadratic_face(make_scene, degree):
    changes = {"lens.half_width": [1.0, 0.7], "lens.degree": list(degree)}
    scene = make_scene(changes | {"run.smoothness": 1.0})
    r, s, t = 0.03, -0.02, 0.05
    energy = smoothness_of(scene).faces["lens.back"].bending(quadratic(scene, r, s, t))
    assert energy.item() == pytest.approx((r**2 + 2 * s**2 + t**2) * 4 * 1.0 * 0.7, rel=1e-10)


def test_curvature_violation_of_a_quadratic_face(make_scene):
    """At the middle the curvatures are those of the quadric; a small net looks near it only."""
    size = {"lens.half_width": [1e-3, 1e-3], "lens.height_range": [-0.3, 0.3]}
    scene = make_scene(size | {"run.min_radius": 2.0})
    heights = quadratic(scene, 0.5, 0.5, 0.5)  # principal curvatures 1 and 0
    found = smoothness_of(scene)
    assert found.faces["lens.back"].curvature_violation(heights, 2.0).item() == pytest.approx(
        1.0, rel=1e-4
    )
    assert found.faces["lens.back"].curvature_violation(
        2 * scene.optic.base.height - heights, 2.0
    ).item() == pytest.approx(1.0, rel=1e-4)
    assert found.faces["lens.back"].curvature_violation(heights, 0.99).item() == 0


def test_gradient_is_that_of_finite_differences(make_scene, rng):
    scene = make_scene({"run.smoothness": 0.01, "run.min_radius": 0.5})
    found = smoothness_of(scene)
    heights = torch.as_tensor(0.5 + 0.05 * rng.random((12, 10))).requires_grad_()
    assert found.faces["lens.back"].curvature_violation(heights, 0.5).item() > 0
    (gradient,) = torch.autograd.grad(found.penalty({"lens.back": heights}), [heights])
    ahead, step = torch.as_tensor(rng.normal(size=(12, 10))), 1e-6
    with torch.no_grad():
        change = found.penalty({"lens.back": heights + step * ahead}) - found.penalty(
            {"lens.back": heights - step * ahead}
        )
    assert (gradient * ahead).sum().item() == pytest.approx(change.item() / (2 * step), rel=1e-6)


def test_penalty_is_the_same_in_any_unit_and_on_any_net(make_scene, rng):
    settings = {"run.smoothness": 0.01, "run.min_radius": 0.5}
    scene = make_scene(settings)
    heights = 0.5 + 0.05 * rng.random((12, 10))
    penalty = smoothness_of(scene).penalty({"lens.back": torch.as_tensor(heights)}).item()
    scaled = make_scene(
        {
            "lens.half_width": [10.0, 10.0],
            "lens.base": {"shape": "flat", "height": 5.0},
            "lens.height_range": [-3.0, 3.0],
            "screen.z": 50.0,
            "run.smoothness": 0.01,
            "run.min_radius": 5.0,
        }
    )
    assert smoothness_of(scaled).penalty(
        {"lens.back": torch.as_tensor(10 * heights)}
    ).item() == pytest.approx(penalty, rel=1e-9)
    finer = make_scene(settings | {"lens.control_points": [21, 17]})  # twice as many spans
    refined = ControlNet.of(scene.optic).refine(heights, ControlNet.of(finer.optic))
    assert smoothness_of(finer).faces["lens.back"].bending(
        torch.as_tensor(refined)
    ).item() == pytest.approx(
        smoothness_of(scene).faces["lens.back"].bending(torch.as_tensor(heights)).item(), rel=1e-9
    )


@pytest.mark.parametrize(("method", "iterations"), [("auto", 24), ("paper", 100)])
def test_a_lens_keeps_to_the_smallest_radius(make_scene, monkeypatch, method, iterations):
    monkeypatch.setattr("workbench.analysis.manufacture._PARTS", 96)  # made sooner
    task = {"run": {"method": method, "iterations": iterations}}
    task["lens.control_points"] = [16, 16]
    free = make_scene(task)
    sharp = tightest(free, best(free).state.heights["lens.back"])
    limit = 1.5 * sharp
    task["run"]["min_radius"] = limit
    scene = make_scene(task)
    found = best(scene)
    assert tightest(scene, found.state.heights["lens.back"]) >= 0.99 * limit
    assert found.state.loss < 0.7 * next(run(scene, DISC)).state.loss
