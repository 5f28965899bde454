"""The net that the program chooses: what it follows from, and that nothing else moves it."""

import numpy as np
import pytest

from workbench.design.net import definite
from workbench.design.run import run
from workbench.design.session import Session
from workbench.geometry.faces import FaceArrays


@pytest.fixture
def chosen(make_scene, rng):
    """The net for a screen of 200 × 120 pixels, with some fields changed and a target."""

    def choose(changes=None, target=None):
        scene = make_scene(
            {"lens.control_points": "auto", "screen.pixels": [200, 120], **(changes or {})}
        )
        sharp = 3 + rng.random((120, 200))
        return definite(scene, sharp if target is None else target).optic.net_shape

    return choose


def test_a_sharp_target_gets_1_875_control_points_per_pixel(chosen):
    assert chosen() == (375, 225)


def test_detail_in_dark_places_gets_more_control_points(chosen):
    x = np.arange(200)
    stripes = 1 + 0.2 * (x % 2)
    part_dark = np.where(x < 150, 0.2, 3.0) + 0.2 * (x % 2)
    assert chosen(target=np.tile(part_dark, (120, 1)))[0] == 488
    assert chosen(target=np.tile(3 * stripes, (120, 1)))[0] == 375


def test_no_more_control_points_are_chosen_than_a_lens_may_have(chosen, rng):
    assert chosen({"screen.pixels": [700, 40]}, 3 + rng.random((40, 700))) == (1024, 75)


def test_a_high_degree_has_the_control_points_that_it_needs(chosen, rng):
    changes = {"screen.pixels": [4, 4], "lens.degree": [7, 3]}
    assert chosen(changes, 3 + rng.random((4, 4))) == (8, 8)


def test_an_axis_without_detail_needs_few(chosen, rng):
    columns = np.broadcast_to(3 + rng.random(200), (120, 200))
    assert chosen(target=columns) == (375, 113)
    rows = np.broadcast_to(3 + rng.random(120)[:, None], (120, 200))
    assert chosen(target=rows) == (141, 225)


def test_more_detail_never_gets_fewer_control_points(chosen):
    x = (np.arange(200) + 0.5) / 200
    nets = [
        chosen(target=np.tile(1 + 0.5 * np.cos(np.pi * waves * x), (120, 1)))[0]
        for waves in (0, 4, 16, 20, 30, 60)
    ]
    assert nets == sorted(nets)
    assert nets[0] == 141 and nets[-1] == 375


def test_the_brightness_of_a_target_does_not_matter(chosen, rng):
    target = 3 + rng.random((120, 200))
    assert chosen(target=target) == chosen(target=1e-30 * target) == chosen(target=1e30 * target)


def test_a_wide_source_is_worth_no_more_than_its_blur(chosen):
    def grid(half_width):
        place = {"kind": "grid", "center": [0, 0, -5], "points": [3, 3]}
        return chosen({"source": {**place, "half_width": half_width}})

    assert grid([0.0, 0.0]) == (375, 225)
    assert grid([1.0, 0.0]) == (141, 225)
    assert grid([1.0, 1.0]) == (141, 113)


def test_a_source_infinitely_far_is_worth_more_than_a_near_one_that_blurs_as_much(chosen):
    """Its blur is even, and narrow lines come nearest to the target."""
    sun = {"kind": "collimated", "angular_diameter": 1.5}
    assert chosen({"source": sun})[0] > 141


@pytest.mark.parametrize(
    ("parametrisation", "net"), [("none", (64, 64)), ("sparse", (64, 64)), ("dense", (32, 32))]
)
def test_the_papers_method_has_a_net_like_the_papers(chosen, parametrisation, net):
    assert chosen({"run": {"method": "paper", "parametrisation": parametrisation}}) == net


def test_numbers_of_control_points_in_the_scene_are_kept(make_scene):
    scene = make_scene()
    assert definite(scene, np.ones((32, 32))) is scene


def _session(make_scene, rng, **fields):
    return Session(make_scene({"lens.control_points": "auto"}), 3 + rng.random((32, 32)), **fields)


def test_a_session_has_a_net_and_keeps_that_it_was_left_to_the_program(make_scene, rng):
    session = _session(make_scene, rng)
    assert session.scene.optic.net_shape == (60, 60)
    assert session.scene.to_data()["lens"]["control_points"] == "auto"


def test_a_session_with_a_lens_has_the_net_of_that_lens(make_scene, rng):
    lens = FaceArrays({"exit": np.full((20, 22), 0.5)})
    assert _session(make_scene, rng, start=lens).scene.optic.net_shape == (20, 22)


def test_more_pixels_get_a_finer_net_and_the_lens_is_carried(make_scene, rng):
    lens = FaceArrays({"exit": np.full((48, 48), 0.45)})
    session = _session(make_scene, rng, start=lens)
    finer = make_scene({"lens.control_points": "auto", "screen.pixels": [64, 64]})
    after = session.with_scene(finer, 3 + rng.random((64, 64)))
    assert after.scene.optic.net_shape == after.start["exit"].shape == (120, 120)
    np.testing.assert_allclose(after.start["exit"], 0.45, atol=1e-9)


def test_locked_control_points_keep_the_net(make_scene, rng):
    lens = FaceArrays({"exit": np.full((48, 48), 0.45)})
    locked = FaceArrays({"exit": np.eye(48, dtype=bool)})
    session = _session(make_scene, rng, start=lens, locked=locked)
    finer = make_scene({"lens.control_points": "auto", "screen.pixels": [64, 64]})
    after = session.with_scene(finer, 3 + rng.random((64, 64)))
    assert after.scene.optic.net_shape == (48, 48)
    assert after.locked is locked


def test_the_same_task_has_the_same_net_again(make_scene, rng):
    session = _session(make_scene, rng)
    again = session.with_scene(make_scene({"lens.control_points": "auto"}), session.target)
    assert again.scene == session.scene


def test_a_run_says_what_was_chosen(make_scene, rng):
    scene = make_scene({"lens.control_points": "auto", "screen.pixels": [8, 8]})
    snapshot = next(run(scene, 3 + rng.random((8, 8))))
    assert snapshot.state.heights["exit"].shape == (15, 15)
    assert "control points: 15 × 15, chosen for this task" in snapshot.notes
    numbers = next(run(make_scene({"screen.pixels": [8, 8]}), 3 + rng.random((8, 8))))
    assert not any("control points" in note for note in numbers.notes)
