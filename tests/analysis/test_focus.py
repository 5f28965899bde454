import numpy as np
import pytest

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
