"""The pace of a run, by a clock that a test sets."""

import pytest

from workbench.design.pace import Pace


def noted(steps):
    pace = Pace()
    for seconds, iteration in steps:
        pace.note(seconds, iteration)
    return pace


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


def test_slow_iterations_have_a_pace_too():
    assert noted((30.0 * i, i) for i in range(5)).rate == pytest.approx(1 / 30)


def test_the_first_lens_and_the_first_step_tell_no_pace():
    """Compiling and a first lens of 15 s each, then steps of 0.1 s."""
    steps = [(0.0, 0), *((30 + 0.1 * i, i) for i in range(1, 8))]
    for count in range(1, 5):
        assert noted(steps[:count]).left(300) is None
    assert noted(steps[:5]).left(300) == pytest.approx(30)


def test_a_step_that_took_long_once_does_not_count():
    steps = [(0.1 * i if i < 4 else 20 + 0.1 * i, i) for i in range(8)]
    assert noted(steps).left(100) == pytest.approx(10)


def test_frames_that_were_left_out_count_by_their_iterations():
    assert noted([(0.0, 0), (2.0, 20), (4.0, 40)]).rate == pytest.approx(10)


def test_another_run_begins_anew():
    pace = noted((i, i) for i in range(10))
    pace.note(0.0, 0)
    assert pace.rate is None
    for iteration in range(5, 10):
        pace.note(0.1 * iteration, iteration)
    assert pace.rate == pytest.approx(10)
