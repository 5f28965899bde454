import numpy as np
import pytest
from matplotlib.figure import Figure

from workbench.pictures.error_curves import draw_errors

ERRORS = [0.3, 0.1, 0.2, 0.4]


def test_the_distribution_has_a_step_for_each_lens():
    axes = Figure().subplots()
    draw_errors(axes, 0.05, ERRORS)
    curve, nominal, middle, most = axes.get_lines()
    x, y = curve.get_data()
    np.testing.assert_allclose(x, [10, 10, 20, 30, 40])
    np.testing.assert_allclose(y, [0, 25, 50, 75, 100])
    assert nominal.get_xdata()[0] == pytest.approx(5)
    assert middle.get_xdata()[0] == pytest.approx(25)
    assert most.get_label() == "95 %: 38.50 %"
