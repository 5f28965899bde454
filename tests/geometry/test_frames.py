"""Frames of elements: the order of rotations, and coordinates of one element in another's."""

import numpy as np
import pytest

from workbench.geometry.frames import Frame
from workbench.scene.turning import tilted


def about(axis, degrees):
    """A rotation about one axis, right-handed, written out."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return {
        "x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]),
        "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
        "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]),
    }[axis]


def test_a_tilt_turns_about_x_then_the_new_y_then_the_new_z():
    """An asymmetric case: three angles of which no order but one gives the matrix."""
    expected = about("x", 20.0) @ about("y", -35.0) @ about("z", 70.0)
    assert tilted((20.0, -35.0, 70.0)) == pytest.approx(expected, abs=1e-15)
    # In steps: the element's own y after the first turn is the axis of the second one.
    first = about("x", 20.0)
    new_y = first @ [0, 1, 0]
    second = rodrigues(new_y, -35.0) @ first
    new_z = second @ [0, 0, 1]
    assert tilted((20.0, -35.0, 70.0)) == pytest.approx(rodrigues(new_z, 70.0) @ second, abs=1e-14)


def rodrigues(axis, degrees):
    """Rodrigues' formula."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.radians(degrees)
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def test_a_quarter_turn_about_x_takes_y_to_z():
    frame = Frame.at((1.0, 2.0, 3.0), (90.0, 0.0, 0.0))
    point = frame.position + frame.rotation @ [0.1, 0.2, 0.3]
    assert point == pytest.approx([1.1, 2.0 - 0.3, 3.0 + 0.2], abs=1e-15)


def test_no_tilt_is_the_identity_exactly():
    assert not Frame.at((1.0, 2.0, 3.0)).is_along_axis
    assert Frame.at((0.0, 0.0, 3.0)).is_along_axis
    assert Frame.at((0.0, 0.0, 0.0)).is_identity


def test_a_frame_seen_from_another_takes_points_there(rng):
    one = Frame.at(rng.normal(size=3), rng.uniform(-90, 90, 3))
    other = Frame.at(rng.normal(size=3), rng.uniform(-90, 90, 3))
    point = rng.normal(size=3)
    change = one.seen_from(other)
    there = change.position + change.rotation @ point
    assert other.position + other.rotation @ there == pytest.approx(
        one.position + one.rotation @ point, abs=1e-14
    )
    assert one.seen_from(one).is_identity
    raised = change.counting_from(0.5, -2.0)
    level = np.array([0, 0, 0.5])
    assert raised.position + raised.rotation @ (point - level) == pytest.approx(
        np.add(there, [0, 0, 2.0]), abs=1e-14
    )


def test_elements_in_one_line_differ_along_the_axis_alone():
    tilt = (30.0, -20.0, 10.0)
    one = Frame.at((1.0, 2.0, 3.0), tilt)
    other = Frame(one.position + 7.0 * one.rotation[:, 2], one.rotation)
    assert other.seen_from(one).is_along_axis
    assert not other.seen_from(one).is_identity
    assert other.seen_from(one).position[2] == pytest.approx(7.0, abs=1e-14)


def test_a_turned_frame_is_turned_about_its_own_x(rng):
    frame = Frame.at(rng.normal(size=3), rng.uniform(-90, 90, 3))
    assert frame.turned().seen_from(frame).rotation == pytest.approx(
        np.diag([1.0, -1.0, -1.0]), abs=1e-15
    )


@pytest.mark.parametrize(
    ("frame", "keeps"),
    [
        (Frame.at((0.0, 0.5, 2.0)), (True, False)),
        (Frame.at((0.0, 0.0, 2.0), (45.0, 0.0, 0.0)), (True, False)),
        (Frame.at((0.0, 0.0, 2.0), (0.0, 45.0, 0.0)), (False, True)),
        (Frame.at((0.0, 0.0, 2.0), (180.0, 0.0, 0.0)), (True, True)),
        (Frame.at((0.0, 0.0, 2.0), (10.0, 5.0, 0.0)), (False, False)),
    ],
)
def test_mirror_images_stay_so_where_the_frame_is_symmetric(frame, keeps):
    assert tuple(frame.keeps_mirror_images(axis) for axis in (0, 1)) == keeps
