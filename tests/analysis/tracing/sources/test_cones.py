"""The check's own cones, against closed forms and against those of the optimiser."""

import math

import numpy as np
import pytest

from workbench.analysis.tracing.sources.cones import covering_cones
from workbench.optics.cap import covering_caps


@pytest.mark.parametrize("half_width", [(1.0, 1.0), (1.0, 0.01), (1e-6, 2e-6)])
@pytest.mark.parametrize("distance", [1e-3, 1.0, 1e2, 1e6, 1e12])
def test_on_the_axis_the_rim_goes_through_the_corners(half_width, distance):
    height = distance * max(half_width)
    cones = covering_cones(np.array([[0.0, 0.0, -height]]), half_width, 0.0)
    angle = math.atan(math.hypot(*half_width) / height)
    assert cones.versine[0] == pytest.approx(2 * math.sin(angle / 2) ** 2, rel=1e-11)
    assert cones.centre[0] == pytest.approx([0, 0], abs=1e-12 * min(half_width))
    assert cones.distance[0] == pytest.approx(height)


@pytest.mark.parametrize("half_width", [(1.0, 1.0), (1.0, 0.01), (0.3, 4.0)])
@pytest.mark.parametrize("distance", [1e-2, 1.0, 1e2, 1e6, 1e12])
def test_cones_equal_those_of_the_optimiser(half_width, distance, rng):
    aside = rng.uniform(-2, 2, (50, 2)) * max(1.0, distance)
    points = np.column_stack([aside, np.full(50, 0.5 - distance)])
    cones, caps = covering_cones(points, half_width, 0.5), covering_caps(points, half_width, 0.5)
    assert cones.versine == pytest.approx(caps.versine, rel=1e-9)
    assert cones.axis == pytest.approx(caps.axis, abs=1e-9)
    assert cones.centre == pytest.approx(caps.centre, abs=1e-7 * min(half_width))
