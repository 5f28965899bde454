import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.loss import LossCurve


@pytest.fixture
def axes():
    return Figure().subplots()


def test_first_loss_stands_at_iteration_1(axes):
    curve = LossCurve(axes)
    curve.update(np.array([3.0, 2.0]), 100)
    x, y = curve.artists[0].get_data()
    np.testing.assert_array_equal(x, [1, 2])
    np.testing.assert_array_equal(y, [3.0, 2.0])
    assert axes.get_xlim() == (0, 100)


def test_limits_change_only_when_the_curve_leaves_them(axes):
    curve = LossCurve(axes)
    assert curve.update(np.array([3.0]), 10) is True
    assert axes.get_ylim() == (2, 5)
    assert curve.update(np.array([3.0, 2.5, 4.9]), 10) is False
    assert curve.update(np.array([3.0, 2.5, 4.9, 0.3]), 10) is True
    assert axes.get_ylim() == pytest.approx((0.2, 5))


def test_what_a_logarithm_cannot_show_is_left_out_of_the_limits(axes):
    curve = LossCurve(axes)
    curve.update(np.array([3.0, 0.0, np.nan]), 10)
    assert axes.get_ylim() == (2, 5)


def test_no_losses_yet(axes):
    curve = LossCurve(axes)
    curve.update(np.zeros(0), 300)
    assert axes.get_xlim() == (0, 300)
    assert curve.artists[1].get_text() == ""
