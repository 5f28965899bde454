import numpy as np
import pytest

from workbench.analysis import focus
from workbench.analysis.focus import focus_series, screen_at
from workbench.analysis.through_focus import with_screen_at
from workbench.analysis.validation import validate
from workbench.errors import Refused


@pytest.fixture
def lens(make_scene, rng):
    scene = make_scene({"screen.pixels": [16, 12], "screen.half_width": [0.8, 0.9]})
    return scene, np.ones((12, 16)), {"exit": 0.5 + 0.05 * rng.random((12, 10))}


def test_each_distance_as_if_the_screen_stood_there(lens):
    found = list(focus_series(*lens, (3.0, 5.0, 7.5), 20_000))
    assert [each.z for each in found] == [3.0, 5.0, 7.5]
    for each in found:
        alone = validate(*lens, 20_000, screen_z=each.z)
        assert each.relative_l2 == pytest.approx(alone.relative_l2, rel=1e-9)
        assert each.efficiency == pytest.approx(alone.efficiency, rel=1e-9)
        assert each.irradiance == pytest.approx(alone.irradiance, rel=1e-9)


def test_a_net_that_the_program_has_chosen_stays(lens, make_scene):
    scene, target, heights = lens
    asked = make_scene({"version": 2, "lens.control_points": "auto", "screen.pixels": [16, 12]})
    chosen = asked.with_optic(asked.optic.with_net(scene.optic.net_shape))
    (found,) = focus_series(chosen, target, heights, (6.0,), 5_000)
    assert found.efficiency == pytest.approx(0.9, abs=0.1)
    assert with_screen_at(chosen, 6.0).optic.net_shape == scene.optic.net_shape


def test_some_at_a_time_is_the_same(lens, monkeypatch):
    at_once = [each.to_data() for each in focus_series(*lens, (3, 4, 5, 6, 7), 5_000)]
    monkeypatch.setattr(focus, "_LARGEST_IMAGES", 2 * 16 * 12 * 8)
    assert [each.to_data() for each in focus_series(*lens, (3, 4, 5, 6, 7), 5_000)] == at_once


def test_large_images_are_kept_small(lens, monkeypatch):
    monkeypatch.setattr(focus, "_MOST_PIXELS", 5)
    scene, target, heights = lens
    (found,) = focus_series(scene, target, heights, (5.0,), 5_000)
    full = validate(scene, target, heights, 5_000).irradiance
    assert found.irradiance.shape == (4, 4)
    assert found.irradiance == pytest.approx(full.reshape(4, 3, 4, 4).mean(axis=(1, 3)))
    monkeypatch.setattr(focus, "_MOST_PIXELS", 7)  # the last of each side stands for fewer
    (found,) = focus_series(scene, target, heights, (5.0,), 5_000)
    assert found.irradiance.shape == (6, 6)
    assert found.irradiance[0, -1] == pytest.approx(full[:2, 15].mean())


def test_no_light_is_all_wrong(make_scene):
    scene = make_scene({"screen.half_width": [1e-3, 1e-3]})
    x = np.linspace(-1, 1, 12)[:, None] + np.zeros(10)
    (found,) = focus_series(scene, np.ones((32, 32)), {"exit": 0.5 + 0.2 * x}, (50.0,), 1000)
    assert (found.relative_l2, found.efficiency) == (1.0, 0.0)


def test_within_the_lens(lens):
    with pytest.raises(Refused, match=r"screen\.z: 0\.7 may touch the lens"):
        list(focus_series(*lens, (5.0, 0.7), 100))


def test_parts_of_the_way_to_the_screen_clear_the_lens(make_scene):
    scene, flat = make_scene(), np.full((12, 10), 0.5)
    top = scene.optic.highest
    assert screen_at(scene, {"exit": flat}, 1) == scene.receiver.z
    assert screen_at(scene, {"exit": flat}, 0.5) - top == pytest.approx(
        (scene.receiver.z - top) / 2
    )
    with_screen_at(scene, screen_at(scene, {"exit": flat}, 1e-6))
    with pytest.raises(Refused, match="may touch the lens"):
        with_screen_at(scene, screen_at(scene, {"exit": flat}, 0))


def test_parts_of_the_way_begin_at_the_top_of_a_lens_whose_range_is_automatic(make_scene):
    scene = make_scene({"lens.height_range": None})
    assert screen_at(scene, {"exit": np.linspace(0.1, 2.0, 120).reshape(12, 10)}, 0) == 2.0
