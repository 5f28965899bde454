"""Least deflections to receivers, against all places of them."""

import math

import numpy as np
import pytest

from workbench.geometry.reach import incidence, largest_turn, least_turn
from workbench.scene import FarField, Screen

RECEIVERS = {
    "screen": Screen(position=(1.0, -2.0, 5.0), half_width=(2.0, 1.0), pixels=(8, 8)),
    "tilted": Screen(
        position=(4.0, 0.0, 5.0), tilt=(20.0, 50.0, 10.0), half_width=(2.0, 3.0), pixels=(8, 8)
    ),
    "far": FarField(half_angle=(20.0, 10.0), center=(30.0, -15.0), pixels=(8, 8)),
    "wide": FarField(half_angle=(80.0, 70.0), center=(0.0, 10.0), pixels=(8, 8)),
}


@pytest.mark.parametrize("receiver", RECEIVERS.values(), ids=RECEIVERS)
def test_least_turn_is_that_to_the_nearest_place(receiver, rng, make_scene):
    place = rng.uniform(-1, 1, (60, 3))
    way = rng.normal(size=(60, 3)) + np.array([0.0, 0.0, 1.5])
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    left, right, bottom, top = receiver.bounds
    u, v = np.meshgrid(np.linspace(left, right, 161), np.linspace(bottom, top, 161))
    optic = make_scene().optic
    found = least_turn(receiver, place, way)
    for at, along, turn in zip(place, way, found, strict=True):
        there = np.stack(receiver.towards(optic, tuple(at), u, v), axis=-1)
        cosines = np.clip(there @ along, -1, 1)
        assert turn == pytest.approx(np.arccos(cosines.max()), abs=0.02)
        assert turn <= np.arccos(cosines.max()) + 1e-7


def test_a_receiver_of_another_kind_needs_no_deflection(rng):
    assert least_turn(None, rng.normal(size=(5, 3)), rng.normal(size=(5, 3))).tolist() == [0.0] * 5


def test_light_turned_the_most_leaves_along_the_face():
    n = 1.49
    turn = np.array([0.0, 0.3, largest_turn(n)])
    inside = incidence(turn, n)
    np.testing.assert_allclose(n * np.sin(inside), np.sin(inside + turn), atol=1e-12)
    assert inside[-1] + turn[-1] == pytest.approx(math.pi / 2)
