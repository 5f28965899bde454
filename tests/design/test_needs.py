"""What is refused before a run begins."""

import pytest

from tests.lamps import PLATE, downlight
from workbench.design.needs import check_stages, grazed
from workbench.errors import Refused


def test_a_lamp_that_shines_away_from_the_lens_is_refused(make_scene, tmp_path):
    away = downlight(tmp_path) | {"rotation": [180.0, 0.0, 0.0]}
    scene = make_scene(PLATE | {"source": away})
    with pytest.raises(Refused, match=r"^source: none of its light goes to the lens"):
        check_stages(scene.stage_scenes(), 0, None, {})


def test_a_lamp_that_shines_at_the_rim_of_the_lens_alone_is_not_refused(make_scene, tmp_path):
    aside = downlight(tmp_path) | {"rotation": [130.0, 0.0, 0.0]}
    check_stages(make_scene(PLATE | {"source": aside}).stage_scenes(), 0, None, {})


def test_light_of_a_stage_is_refused_by_the_path_of_the_stage(make_scene, tmp_path):
    away = downlight(tmp_path) | {"rotation": [180.0, 0.0, 0.0]}
    run = {"iterations": 10, "stages": [{"iterations": 5, "source": away}]}
    scene = make_scene(PLATE | {"run": run})
    with pytest.raises(Refused, match=r"^run\.stages\[0\]\.source: none of its light"):
        check_stages(scene.stage_scenes(), 0, None, {})


def test_a_screen_that_light_grazes_is_said_with_what_helps(make_scene):
    wall = {
        "version": 2,
        "screen.z": 4.0,
        "screen.center": [0.0, 2.0],
        "lens.half_width": [0.1, 0.1],
    }
    assert grazed(make_scene(wall | {"screen.tilt": [20.0, 0.0]})) is None
    said = grazed(make_scene(wall | {"screen.tilt": [52.0, 0.0]}))
    assert "from across it" in said and "turn the screen towards the lens" in said
