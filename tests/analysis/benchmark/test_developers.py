"""Benchmarks that developers run: comparisons of variants, and their timing."""

import itertools

import numpy as np
import pytest
import torch

from tests.benchmarks import timing
from tests.benchmarks.comparison import Variant, compare, table
from tests.benchmarks.kernels import Descent
from tests.benchmarks.timing import in_turns
from workbench.analysis.benchmark.examples import wavy
from workbench.design.loss import paper_loss, share
from workbench.optics.plan import Plan


def test_a_descent_is_loss_and_gradient(make_example):
    example = make_example()
    heights = wavy(example.scene)
    image, loss, gradient = Descent(example, heights, torch.float64)()
    leaf = torch.tensor(heights, requires_grad=True)
    flux = Plan(example.scene, dtype=torch.float64).trace({"lens.back": leaf}).flux
    expected = paper_loss(flux, torch.as_tensor(share(example.target)))
    expected.backward()
    np.testing.assert_allclose(image, flux.detach().numpy(), atol=1e-15)
    assert loss == pytest.approx(expected.item(), rel=1e-12)
    np.testing.assert_allclose(gradient, leaf.grad.numpy(), atol=1e-15)


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


@pytest.fixture
def clock(monkeypatch):
    """A clock that only calls move."""

    class Clock:
        now = 0.0

        def call(self, *seconds):
            each = itertools.cycle(seconds)

            def run():
                self.now += next(each)

            return run

    clock = Clock()
    monkeypatch.setattr(timing.time, "perf_counter", lambda: clock.now)
    return clock


def test_calls_are_interleaved():
    order = []
    times = in_turns({name: lambda n=name: order.append(n) for name in "ab"}, rounds=4)
    assert order == ["a", "b"] * 5  # once to warm up
    assert {name: len(each.seconds) for name, each in times.items()} == {"a": 4, "b": 4}


def test_medians_and_ratios_are_of_rounds(clock):
    # The first call warms up. A round in which the machine is busy slows both.
    calls = {"a": clock.call(9.0, 1.0, 10.0, 1.0), "b": clock.call(9.0, 2.0, 20.0, 2.0)}
    times = in_turns(calls, rounds=3, seconds=1e9)
    assert times["a"].seconds == (1.0, 10.0, 1.0)
    assert times["b"].median == 2.0
    assert times["b"].ratio(times["a"]) == 2.0
    assert times["a"].ratio(times["a"]) == 1.0
