"""The control net that a task needs, and whether a coarse one is the reason of an error."""

import numpy as np
import pytest

from workbench.design.checks import coarse_net
from workbench.design.net import definite
from workbench.design.run import run
from workbench.design.session import Session
from workbench.design.snapshot import History
from workbench.geometry.faces import FaceArrays
from workbench.scene.paths import value_at


@pytest.fixture
def stripes():
    """Detail that a few control points do not show."""
    across = np.arange(32) // 2 % 2
    return 0.2 + np.outer(np.ones(32), across)


def designed(scene, target):
    history = History()
    for _ in history.follow(run(scene, target)):
        pass
    return history.result()


@pytest.fixture
def scene(make_scene):
    return make_scene({"lens.control_points": [6, 6], "run.iterations": 300})


def test_a_coarse_net_is_named_with_what_can_show_the_target(scene, stripes):
    result = designed(scene, stripes)
    found = coarse_net(scene, stripes, result)
    assert found.shape == (6, 6) and min(found.finer) > 12 and found.error > 0.05
    assert "6 × 6 control points are too few" in found.sentence


@pytest.fixture
def chosen(make_scene, rng):
    """The net for a screen of 200 × 120 pixels, with some fields changed and a target."""

    def choose(changes=None, target=None):
        scene = make_scene(
            {"lens.control_points": "auto", "screen.pixels": [200, 120], **(changes or {})}
        )
        sharp = 5 + rng.random((120, 200))
        return definite(scene, sharp if target is None else target).optic.net_shape

    return choose


def test_a_sharp_target_gets_1_875_control_points_per_pixel(chosen):
    assert chosen() == (375, 225)


def test_sharper_edges_and_darker_places_get_more_control_points(chosen):
    x = np.arange(200)

    def along_x(dark, step):
        lit = np.where(x % 40 < 20, 1.0, dark) + step * (x % 2)
        return chosen(target=np.tile(lit, (120, 1)))[0]

    counts = [along_x(*each) for each in ((0.9, 0.02), (0.6, 0.02), (0.0, 0.02))]
    assert counts == sorted(counts) and counts[0] == 375 < counts[-1] == 900
    assert along_x(0.7, 0.3) > along_x(0.7, 0.02)


def _session(make_scene, rng, **fields):
    return Session(make_scene({"lens.control_points": "auto"}), 5 + rng.random((32, 32)), **fields)


def test_a_session_has_a_net_and_keeps_that_it_was_left_to_the_program(make_scene, rng):
    session = _session(make_scene, rng)
    assert session.scene.optic.net_shape == (60, 60)
    assert value_at(session.scene.to_data(), "elements[0].faces[1].control_points") == "auto"


def test_more_pixels_get_a_finer_net_and_the_lens_is_carried(make_scene, rng):
    lens = FaceArrays({"lens.back": np.full((48, 48), 0.45)})
    session = _session(make_scene, rng, start=lens)
    finer = make_scene({"lens.control_points": "auto", "screen.pixels": [64, 64]})
    after = session.with_scene(finer, 5 + rng.random((64, 64)))
    assert after.scene.optic.net_shape == after.start["lens.back"].shape == (120, 120)
    np.testing.assert_allclose(after.start["lens.back"], 0.45, atol=1e-9)
