"""Cells that are closer together where the light is near."""

import math

import numpy as np
import pytest

from workbench.analysis.cells.drawing import Grading


@pytest.mark.parametrize(("away", "foot"), [(0.1, 0.0), (0.5, -0.3), (8.0, 2.0)])
def test_grading_maps_the_axis_onto_itself_with_its_derivative_as_stretch(away, foot):
    grade = Grading(away, foot)
    even = np.linspace(-1, 1, 2001)
    place, stretch = grade(even)
    assert place[[0, -1]] == pytest.approx([-1, 1], abs=1e-12)
    assert np.gradient(place, even)[1:-1] == pytest.approx(stretch[1:-1], rel=1e-4)
    assert stretch == pytest.approx(
        stretch[0] * np.hypot(away, place - foot) / math.hypot(away, 1 + foot)
    )


def test_places_of_light_from_afar_are_even():
    even = np.linspace(-1, 1, 5)
    for grade in Grading.of(np.array([0.5, 0.0, -1000.0]), (1.0, 2.0)):
        place, stretch = grade(even)
        assert np.array_equal(place, even)
        assert np.array_equal(stretch, np.ones(5))
