"""The receiver as an element sees it."""

import numpy as np
import pytest

from workbench.design.transport.view import ReceiverView

LEANING = {
    "version": 2,
    "screen.z": 3.0,
    "screen.center": [0.0, 1.2],
    "screen.half_width": [1.4, 1.4],
    "screen.tilt": [50.0, 0.0],
}


@pytest.fixture
def leaning(make_scene):
    """A screen whose upper edge leans away, before a small lens."""
    changes = {"lens.control_points": [32, 32], "lens.height_range": None}
    return make_scene(LEANING | {"lens.half_width": [0.3, 0.3], "lens.base": BASE} | changes)


BASE = {"shape": "flat", "height": 0.1}


def test_the_light_of_a_leaning_screen_lies_where_lines_of_sight_meet_it(leaning):
    view, n = ReceiverView.of(leaning), 64
    image = np.zeros((n, n))
    image[8:12, 40:44] = 1.0  # up, where it is far, and to the right
    seen = view.wanted(image, n)
    place = np.array([(42 / n - 0.5) * 2.8, (0.5 - 10 / n) * 2.8])
    (at,) = leaning.receiver.drawn(leaning.optic, *place[:, None])
    x, y = at[:2] / (at[2] - leaning.optic.leaving_z)
    middle = [(np.arange(n) @ seen.sum(axis)) / seen.sum() for axis in (1, 0)]
    cells = [
        ((c - m) / r + 1) * n / 2 - 0.5
        for c, m, r in zip((x, y), view.middle, view.half_extent, strict=True)
    ]
    # Its middle is a little higher than that of the patch as it is seen.
    assert middle == pytest.approx(cells, abs=0.15)
