"""Presets of processes: their values, and where these come from."""

import pytest

from workbench.errors import Refused
from workbench.scene import Scene
from workbench.scene.making.presets import PRESETS, preset_processes


def test_titles_state_the_values():
    milling, fine, turning = (PRESETS[name].process for name in ("mill-3mm", "mill-1mm", "turn"))
    assert 2 * milling.ball_radius == 3 and milling.scallop == pytest.approx(5e-3, rel=1e-3)
    assert 2 * fine.ball_radius == 1 and fine.scallop == pytest.approx(1e-3, rel=2e-3)
    assert (turning.nose_radius, turning.feed) == (0.5, 5e-3)
    assert all(each.source for each in PRESETS.values())


def test_they_come_in_the_unit_of_the_scene(make_scene):
    scene = make_scene()  # in cm
    processes = preset_processes(["mill-3mm", "polish"], scene.unit)
    made = Scene.from_data(scene.to_data() | {"processes": processes}).processes
    assert [each.kind for each in made] == ["milling", "polishing"]
    assert (made[0].ball_radius, made[1].width) == (0.15, 0.01)


def test_an_unknown_one_is_refused_with_those_there_are():
    with pytest.raises(Refused, match="preset: 'foo'; one of mill-3mm, mill-1mm, turn, "):
        preset_processes(["polish", "foo"], "mm")
