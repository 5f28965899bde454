"""What is refused before a run begins."""

import numpy as np
import pytest

from tests.lamps import PLATE, downlight
from workbench.design.needs import check_stages, grazed, reversed_on_lit_side
from workbench.errors import Refused


def test_a_lamp_that_shines_away_from_the_lens_is_refused(make_scene, tmp_path):
    away = downlight(tmp_path) | {"rotation": [180.0, 0.0, 0.0]}
    scene = make_scene(PLATE | {"source": away})
    with pytest.raises(Refused, match=r"^source: none of its light goes to the lens"):
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


def test_a_picture_that_is_mirror_inverted_on_a_wall_is_said_with_what_helps(make_scene):
    uneven, even = np.ones((32, 32)), np.ones((32, 32))
    uneven[:, :10] = 0.0
    said = reversed_on_lit_side(make_scene(), uneven)
    assert "mirror-inverted for viewers on the side of the light" in said
    assert 'target.viewed_from "front"' in said
    assert reversed_on_lit_side(make_scene(), even) is None
    for side in ("front", "back"):
        scene = make_scene({"target": {"builtin": "tophat", "viewed_from": side}})
        assert reversed_on_lit_side(scene, uneven) is None
    back = {"lens": None, "mirror": {"half_width": [1.0, 1.0], "control_points": [8, 8]}}
    mirror = make_scene({**back, "screen.z": -5.0, "version": 2})
    assert reversed_on_lit_side(mirror, uneven) is None
