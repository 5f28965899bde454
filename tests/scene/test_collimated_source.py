"""What collimated light says of itself, and what it refuses."""

import math

import pytest

from workbench.errors import Refused

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
