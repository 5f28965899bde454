"""What a session keeps of its lens when the task changes."""

from dataclasses import replace

import numpy as np
import pytest

from tests.accounts import result_of
from workbench.design.limits import Shortfall
from workbench.design.session import Session
from workbench.geometry.approximation import deviation
from workbench.geometry.faces import NO_LOCKS, FaceArrays
from workbench.geometry.surface import ControlNet
from workbench.scene.paths import with_values


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene()
    n_x, n_y = scene.receiver.pixels
    result = result_of(
        0.5 + 0.01 * rng.normal(size=scene.optic.net_shape), losses=[2.0, 1.0], seconds=0.5
    )
    return Session(scene, np.ones((n_y, n_x)), result)


NET = "lens.back.control_points"


def edited(session, changes):
    """The session after some fields, by path, have got other values."""
    return session.with_scene(with_values(session.scene, changes), session.target)


def off(session, other):
    """How far apart the lenses of two sessions are."""
    nets = (ControlNet.of(each.scene.optic) for each in (session, other))
    one, two = nets
    return deviation(one, session.heights["lens.back"], two, other.heights["lens.back"])


def finer(lens, factor):
    return [factor * (n - p) + p for n, p in zip(lens.control_points, lens.degree, strict=True)]


def test_a_net_that_holds_the_surface_keeps_the_result(session):
    other = edited(session, {NET: finer(session.scene.optic, 3)})
    result = other.result
    assert result.state.heights["lens.back"].shape == other.scene.optic.control_points
    assert off(session, other) < 1e-15 * 10
    assert (result.state.loss, result.losses, result.state.irradiance) == (
        session.result.state.loss,
        session.result.losses,
        session.result.state.irradiance,
    )
    assert other.start is None


def test_another_net_makes_the_nearest_lens_a_start(session):
    other = edited(session, {NET: [20, 20]})
    assert other.result is None
    assert other.start["lens.back"].shape == (20, 20)
    assert 1e-6 < off(session, other) < 0.01
    again = edited(other, {NET: [9, 9]})
    assert again.start["lens.back"].shape == (9, 9)


@pytest.mark.parametrize(
    "values",
    [
        {"images[0].receiver.position[2]": 7.0},
        {"images[0].receiver.half_width": [2.0, 2.0]},
        {"source.rays": [40, 40]},
        {"filter.alpha": 2.0},
        {"lens.material": {"index": 1.6}},
    ],
)
def test_another_task_takes_the_lens_for_a_start(session, values):
    other = edited(session, values)
    assert other.result is None
    assert other.start is session.result.state.heights
    assert other.heights is other.start


@pytest.mark.parametrize(
    "values",
    [
        {"lens.min_thickness": 0.06},
        {"lens.max_thickness": 8.0},
        {"lens.back.height_range": [-0.2, 3.0]},
        {"lens.back.height_range": None},
    ],
)
def test_limits_that_the_lens_is_within_keep_the_result(session, values):
    short = Shortfall("height_range", None, (-0.3, 0.3), 0.5)
    short = replace(session, result=session.result.with_state(shortfall=short))
    other = edited(short, values)
    assert other.result.state.heights is session.result.state.heights
    assert other.result.losses is session.result.losses
    assert other.result.state.shortfall is None  # it was one of the limits before
    assert other.start is None


def test_a_lens_that_is_moved_along_z_takes_its_heights_along(session):
    optic = session.scene.optic
    x, y, z = optic.position
    scene = session.scene.with_optic(optic.model_copy(update={"position": (x, y, z + 0.25)}))
    moved = session.with_scene(scene, session.target)
    for face, heights in session.heights.items():
        assert moved.heights[face] == pytest.approx(heights + 0.25, abs=1e-12)


def test_locks_stay_with_their_control_points_wherever_these_are(session):
    locked = FaceArrays({"lens.back": np.zeros(session.scene.optic.net_shape, dtype=bool)})
    session = replace(session, locked=locked)
    assert edited(session, {"lens.half_width": [2.0, 2.0]}).locked is locked
    assert edited(session, {"images[0].receiver.position[2]": 7.0}).locked is locked
    finer_net = finer(session.scene.optic, 2)
    assert edited(session, {NET: finer_net}).locked == NO_LOCKS
    assert edited(session, {"lens.back.degree": [3, 2]}).locked == NO_LOCKS


def test_another_unit_keeps_the_lens_and_its_light(session):
    found = session.in_unit("mm")
    assert (found.scene.unit, found.scene.receiver.z) == ("mm", 50)
    before, after = session.result, found.result
    np.testing.assert_allclose(
        after.state.heights["lens.back"], 10 * before.state.heights["lens.back"], rtol=1e-15
    )
    pixels = [each.scene.receiver.pixel_measure for each in (session, found)]
    np.testing.assert_allclose(
        after.state.irradiance * pixels[1], before.state.irradiance * pixels[0], rtol=1e-14
    )
    assert (after.state.loss, after.state.account) == (before.state.loss, before.state.account)
    assert not after.state.heights["lens.back"].flags.writeable
    start = replace(session, result=None, start=before.state.heights).in_unit("inch").start
    np.testing.assert_allclose(
        start["lens.back"], before.state.heights["lens.back"] / 2.54, rtol=1e-15
    )
