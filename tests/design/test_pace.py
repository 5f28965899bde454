"""The pace of a run, by a clock that a test sets."""

import pytest

from workbench.design.pace import Pace


def test_the_pace_is_that_of_the_last_seconds():
    pace = Pace()
    assert pace.rate is None and pace.left(10) is None
    for iteration in range(101):
        pace.note(0.1 * iteration, iteration)
    assert pace.rate == pytest.approx(10)
    for iteration in range(1, 21):  # then four times slower
        pace.note(10 + 0.4 * iteration, 100 + iteration)
    assert pace.rate == pytest.approx(2.5)
    assert pace.left(10) == pytest.approx(4)
