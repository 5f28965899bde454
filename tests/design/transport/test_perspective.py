"""Images on planes on which they are seen in perspective."""

import numpy as np
import pytest

from workbench.design.transport.cells import in_perspective


def test_an_image_that_is_seen_shifted_and_half_as_wide_keeps_its_light(rng):
    image = rng.random((8, 8))
    onto = np.array([[2.0, 0.0, -4.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    light = in_perspective(image, onto, 8, 2)
    assert light[2:6] == pytest.approx(image[::2] + image[1::2])
    assert not light[:2].any() and not light[6:].any()


def test_light_of_a_plane_that_leans_is_denser_where_it_is_far():
    onto = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -0.02, 1.0]])
    light = in_perspective(np.ones((64, 64)), onto, 32, 4)
    far = 1 - 0.02 * (np.arange(32) + 0.5)
    inside = light[0] > 0
    assert inside[:20].all()
    assert light[0][:20] == pytest.approx(far[:20] ** -3, rel=1e-3)
