"""The curve of the error against the distance of the screen."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.error_curves import FocusCurve

ERRORS = [(4.0, 0.5), (5.0, 0.02), (6.0, 0.8)]


@pytest.fixture
def curve(make_scene):
    return FocusCurve(Figure().add_subplot(), make_scene(), (4.0, 6.0))


def test_errors_are_drawn_in_percent_over_the_whole_range(curve):
    assert curve.update(ERRORS, 5.5)
    axes = curve.mark.axes
    np.testing.assert_allclose(curve._curve.get_xydata(), [(4, 50), (5, 2), (6, 80)])
    assert axes.get_xlim() == (4, 6)
    assert axes.get_ylim() == (0, pytest.approx(88))
    assert "cm" in axes.get_xlabel()


def test_another_distance_moves_the_mark_alone(curve):
    curve.update(ERRORS, 5.5)
    assert not curve.update(list(ERRORS), 4.25)
    assert list(curve.mark.get_xdata()) == [4.25, 4.25]
    assert curve.update(ERRORS[:2], 4.25)


@pytest.mark.parametrize("errors", [[], [(4.0, 0.0)]])
def test_no_error_at_all_has_a_scale(curve, errors):
    curve.update(errors, 5.0)
    low, high = curve.mark.axes.get_ylim()
    assert low == 0 < high
