"""Variants of one computation: what is timed is what a design computes."""

import itertools

import numpy as np
import pytest
import torch

from tests.benchmarks import kernels, skips
from tests.benchmarks.comparison import Variant, compare, image_error, table
from tests.benchmarks.kernels import Descent, rays_of
from tests.benchmarks.precision import difference, differences
from tests.benchmarks.precision import table as precision_table
from workbench.analysis.benchmark.examples import wavy
from workbench.design.loss import paper_loss, share
from workbench.optics.plan import Plan

POINT = {"kind": "point", "position": [0.0, 0.0, -5.0], "rays": 4000}
GRID = {
    "kind": "grid",
    "center": [0.0, 0.0, -5.0],
    "half_width": [0.5, 0.5],
    "points": [3, 2],
    "rays": 500,
}


def test_a_descent_is_loss_and_gradient(make_example):
    example = make_example()
    heights = wavy(example.scene)
    image, loss, gradient = Descent(example, heights, torch.float64)()
    leaf = torch.tensor(heights, requires_grad=True)
    flux = Plan(example.scene, dtype=torch.float64).trace({"exit": leaf}).flux
    expected = paper_loss(flux, torch.as_tensor(share(example.target)))
    expected.backward()
    np.testing.assert_allclose(image, flux.detach().numpy(), atol=1e-15)
    assert loss == pytest.approx(expected.item(), rel=1e-12)
    np.testing.assert_allclose(gradient, leaf.grad.numpy(), atol=1e-15)


def test_each_second_call_traces_the_same_lens(make_example):
    example = make_example()
    descent = Descent(example, wavy(example.scene), torch.float64)
    first, second, third = (descent()[1] for _ in range(3))
    assert first != second
    assert third == pytest.approx(first, rel=1e-12)


def test_the_number_of_threads_is_restored(make_example):
    example = make_example()
    usual = torch.get_num_threads()
    one, *_ = Descent(example, wavy(example.scene), threads=1)()
    assert torch.get_num_threads() == usual
    many, *_ = Descent(example, wavy(example.scene))()
    assert image_error(one, many) < 1e-5


@pytest.mark.parametrize(
    ("source", "rays"),
    [({"kind": "collimated", "rays": [5, 7]}, 35), (POINT, 4000), (GRID, 3000)],
)
def test_rays_of(make_scene, source, rays):
    assert rays_of(make_scene({"source": source})) == rays


def test_ratios_are_to_the_first_variant():
    steps = itertools.count()
    rows = compare("which", [Variant(n, lambda: next(steps), 1000) for n in "abc"], 0.01)
    assert [row.variant for row in rows] == ["a", "b", "c"]
    assert rows[0].ratio == 1.0
    for row in rows:
        assert row.question == "which" and row.error is None
        assert row.nanoseconds_a_ray == pytest.approx(1e6 * row.milliseconds / 1000)
    data = table("Times", rows).to_data()
    assert [each["ratio"] for each in data] == [row.ratio for row in rows]


def test_image_error_compares_at_equal_light(rng):
    image = rng.random((5, 6))
    assert image_error(3 * image, image) == pytest.approx(0, abs=1e-15)
    other = np.zeros((1, 2))
    other[0, 0] = 1.0
    assert image_error(other[:, ::-1], other) == pytest.approx(np.sqrt(2))


@pytest.mark.parametrize("source", [{"kind": "collimated", "rays": [64, 64]}, POINT])
def test_float32_is_near_float64_but_not_it(make_example, source):
    example = make_example({"source": source})
    found = difference(example, wavy(example.scene))
    for value in (found.image, found.loss, found.gradient):
        assert 0 < value < 1e-2
    (data,) = precision_table([found]).to_data()
    assert data == {
        "scene": "small",
        "image": found.image,
        "loss": found.loss,
        "gradient": found.gradient,
    }


@pytest.mark.slow
@pytest.mark.parametrize("question", skips.SKIPS)
def test_a_skip_leaves_the_image_unchanged(question):
    for variant in skips.SKIPS[question]():
        # The rays of a point far away are others: their scatter stays.
        limit = 0.2 if "intersection" in question else 1e-3
        assert variant.error is None or variant.error < limit


@pytest.mark.slow
def test_every_comparison_gives_rows(monkeypatch, progress):
    for module in (kernels, skips):
        monkeypatch.setattr(module, "_SECONDS", 0.01)
    for rows in (
        list(kernels.measurements(None, progress)),
        list(skips.measurements(None, progress)),
    ):
        questions = {row.question for row in rows}
        assert questions <= {case for case, _ in progress.lines}
        for row in rows:
            assert row.milliseconds > 0 and row.rays > 0
    assert len(list(differences(None, progress))) >= 5
