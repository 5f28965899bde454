"""Sources of a scene."""

import math

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.scene import GridSource

SUN = {"kind": "collimated", "angular_diameter": 0.533}


def source(make_scene, **fields):
    return make_scene({"source": {"kind": "collimated"} | fields}).source


@pytest.mark.parametrize(
    ("fields", "sentence"),
    [
        ({"direction": [60.0, 70.0]}, r"source.direction\[1\]: 70 brings light .* less than 90"),
        ({"direction": [0.0, 89.0], "angular_diameter": 3.0}, r"source.direction\[1\]: 89 brings"),
        ({"angular_diameter": 180.0}, "source.angular_diameter: 180"),
        ({"angular_diameter": -0.5}, "source.angular_diameter: -0.5"),
        ({"profile": {"kind": "gaussian", "radius": -1.0}}, "source.profile.radius: -1"),
        ({"profile": {"kind": "gaussian", "radius": 1e-3}}, "radius: 0.001 is too narrow"),
        ({"profile": {"kind": "gaussian", "radius": 1e15}}, "radius: 1e.15 is too long"),
        ({"profile": {"kind": "lorentzian"}}, "source.profile.kind"),
    ],
)
def test_impossible_light_is_refused(make_scene, fields, sentence):
    with pytest.raises(Refused, match=sentence):
        source(make_scene, **fields)


def test_the_sun_is_as_wide_on_the_screen_as_its_angle_says(make_scene):
    scene = make_scene({"source": SUN})
    width = math.radians(0.533) * (5 - 0.8)
    assert scene.source.blur(scene.optic, scene.receiver) == pytest.approx((width, width))


LAMP = {"kind": "photometric", "file": "lamp.ies", "position": [0.0, 0.0, -3.0]}


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ({"file": "lamp.txt"}, "source.file: 'lamp.txt' is none of these: .ies, .ldt"),
        ({"file": ""}, "source.file: '' is empty"),
        ({"position": [0, 0, 1]}, r"source.position\[2\]: 1 is not before the entrance face"),
        ({"position": [0, 0, -1e15]}, r"source.position\[2\]: 1e\+15 before the entrance face is"),
        ({"rotation": [0, 0]}, "source.rotation"),
        ({"rotation": [0, 0, 1000]}, r"source.rotation\[2\]: 1000 is too large"),
        ({"rays": 0}, "source.rays: 0 is too small"),
    ],
)
def test_impossible_measured_source_is_refused(make_scene, source, said):
    with pytest.raises(Refused, match=f"^{said}"):
        make_scene({"source": LAMP | source})


def test_another_unit_keeps_the_lamp_and_moves_it(make_scene):
    scene = make_scene({"source": LAMP | {"rotation": [5.0, 0.0, 0.0]}})

    source = scene.in_unit("mm").source

    assert source.position == (0, 0, -30)
    assert source.rotation == (5, 0, 0)
    assert source.unit == "mm" and scene.source.unit == "cm"


def test_files_are_named_by_their_fields_and_can_be_renamed(make_scene):
    stage = {"iterations": 2, "source": LAMP | {"file": "other.ldt"}}
    scene = make_scene({"source": LAMP, "run.stages": [stage], "target": {"image": "a.png"}})

    names = dict(scene.files())
    assert names == {
        "source.file": "lamp.ies",
        "target.image": "a.png",
        "run.stages[0].source.file": "other.ldt",
    }
    moved = scene.with_files({field: f"/there/{name}" for field, name in names.items()})
    assert dict(moved.files())["run.stages[0].source.file"] == "/there/other.ldt"
    assert moved.source.file == "/there/lamp.ies"
    assert scene.with_files({}) == scene


def grid(points, half_width=(2.0, 1.0)):
    return GridSource(kind="grid", center=(1.0, 0.0, -3.0), half_width=half_width, points=points)


def test_grid_points_reach_the_rim_of_the_source():
    found = grid((3, 2)).seen((25, 25))
    expected = [[x, y, -3] for x in (-1, 1, 3) for y in (-1, 1)]
    np.testing.assert_allclose(found, expected)


@pytest.mark.parametrize(
    ("source", "rays"),
    [
        ({"kind": "collimated", "rays": [5, 7]}, 35),
        ({"kind": "point", "position": [0, 0, -5], "rays": 4000}, 4000),
        (
            {"kind": "grid", "center": [0, 0, -5], "half_width": [1, 1], "points": [2, 3]}
            | {"rays": 500},
            3000,
        ),
    ],
)
def test_all_rays_of_a_source_are_counted(make_scene, source, rays):
    assert make_scene({"source": source}).source.ray_count == rays
