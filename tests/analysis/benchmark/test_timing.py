import itertools

import pytest

from tests.benchmarks import timing
from tests.benchmarks.timing import in_turns


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
