"""The error of a sweep's lenses over the values of its fields."""

import numpy as np
from matplotlib.figure import Figure

from workbench.design.session import VerifiedError
from workbench.pictures.error_curves import Curve, draw_sweep


def found(percent, beside=0.1):
    low, high = percent - beside, percent + beside
    return VerifiedError(percent / 100, (max(low, 0) / 100, high / 100))


def drawn(*curves):
    axes = Figure().subplots()
    draw_sweep(axes, "Lens · Index", curves)
    return axes


def test_lenses_stand_at_their_numbers_in_order():
    axes = drawn(Curve("", ("1.6", "1.4", "1.5"), (found(3), found(1), found(2))))
    (container,) = axes.containers
    line, _, (bars,) = container
    assert np.allclose(line.get_xydata(), [(1.4, 1), (1.5, 2), (1.6, 3)])
    assert np.allclose(bars.get_segments()[0][:, 1], [0.9, 1.1])
    assert axes.get_ylim()[0] == 0
    assert axes.get_legend() is None
    assert axes.get_xlabel() == "Lens · Index"


def test_each_value_of_a_second_field_has_a_curve():
    one, other = (Curve(f"Seed {n}", ("1", "2"), (found(n + 1), found(n + 2))) for n in (0, 1))
    axes = drawn(one, other)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["Seed 0", "Seed 1"]
    assert len(axes.containers) == 2
