"""The smallest cone of directions that covers the entrance face."""

import math

import numpy as np
import pytest
from scipy.optimize import minimize

from workbench.optics.cap import covering_cap


def corners(position, half_width, z):
    r_x, r_y = half_width
    directions = np.array([[x, y, z] for x in (-r_x, r_x) for y in (-r_y, r_y)]) - position
    return directions / np.linalg.norm(directions, axis=1, keepdims=True)


@pytest.mark.parametrize("half_width", [(1.0, 1.0), (0.5, 2.0), (100.0, 1.0)])
@pytest.mark.parametrize("distance", [1e-3, 1.0, 5.0, 1e4, 1e7, 1e9])
def test_on_the_axis_it_is_that_of_the_paper(half_width, distance):
    cap = covering_cap(np.array([0.0, 0.0, 2 - distance]), half_width, 2.0)
    assert cap.axis == pytest.approx([0, 0, 1], abs=1e-9)
    angle = math.atan(math.hypot(*half_width) / distance)
    assert cap.cos_max == pytest.approx(math.cos(angle), abs=1e-11)
    assert cap.solid_angle == pytest.approx(4 * math.pi * math.sin(angle / 2) ** 2, rel=1e-7)


def test_off_the_axis_it_holds_all_corners_and_none_is_smaller(rng):
    for _ in range(60):
        position = np.append(rng.uniform(-3, 3, 2), -(10 ** rng.uniform(-2, 1)))
        half_width = tuple(10 ** rng.uniform(-1, 0.5, 2))
        directions = corners(position, half_width, 0.0)
        cap = covering_cap(position, half_width, 0.0)
        assert np.linalg.norm(cap.axis) == pytest.approx(1)
        assert (directions @ cap.axis >= cap.cos_max).all()

        others = rng.normal(size=(2000, 3)) * 10 ** rng.uniform(-6, 0, (2000, 1)) + cap.axis
        others /= np.linalg.norm(others, axis=1, keepdims=True)
        assert (others @ directions.T).min(axis=1).max() <= cap.cos_max + 2e-12

        def worst(axis, directions=directions):
            return -(directions @ (axis / np.linalg.norm(axis))).min()

        found = minimize(worst, directions.mean(axis=0), method="Nelder-Mead")
        assert -found.fun <= cap.cos_max + 1e-9


def test_it_covers_the_whole_face(rng):
    position = np.array([2.0, -1.5, -0.4])
    cap = covering_cap(position, (1.0, 0.7), 0.0)
    places = np.column_stack(
        [rng.uniform(-1, 1, 9999), rng.uniform(-0.7, 0.7, 9999), np.zeros(9999)]
    )
    directions = places - position
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    assert (directions @ cap.axis >= cap.cos_max).all()
