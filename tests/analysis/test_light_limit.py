"""Upper limits of the light: closed forms, and lenses that are traced."""

import json
import math

import numpy as np
import pytest

from resources import path
from tests.scenes import changed
from workbench.analysis.light_limit import light_limits
from workbench.analysis.tracing.trace import Trace, added
from workbench.design.run import run
from workbench.geometry.faces import FaceArrays
from workbench.scene import Scene

R = 0.04  # of a face of index 1.5 at normal incidence
LED = {"kind": "area", "half_width": [0.1, 0.1], "center": [0, 0, -1.0]}


def scene_of(**changes):
    return Scene.from_data(changed({"version": 2, "lens.reflection": "fresnel"} | changes))


def limit_of(scene):
    (found,) = light_limits(scene)
    assert 0 <= found.most <= found.turned <= found.passes <= found.meets <= 1
    return found


def transmittance(turn, n=1.5):
    """Of an exit face that deflects by an angle: Fresnel's equations, unpolarised."""
    inside = math.atan2(math.sin(turn), n - math.cos(turn))
    a, b = math.cos(inside), math.cos(inside + turn)
    s, p = (n * a - b) / (n * a + b), (a - n * b) / (a + n * b)
    return 1 - (s**2 + p**2) / 2


def test_two_faces_pass_collimated_light_as_at_normal_incidence():
    assert limit_of(scene_of()).most == pytest.approx((1 - R) ** 2, rel=1e-9)
    coated = limit_of(scene_of(**{"lens.coating": [0.01, 0.02], "lens.absorption": 0.5}))
    assert coated.most == pytest.approx(0.99 * 0.98 * math.exp(-0.5 * 0.2), rel=1e-9)  # 0.5 - 0.3
    both = limit_of(scene_of(**{"lens.entrance": {"shape": "freeform", "control_points": [9, 9]}}))
    assert both.most == pytest.approx((1 - R) ** 2, rel=1e-9)


@pytest.mark.parametrize(
    ("middle", "both"), [(20.0, False), (40.0, False), (50.0, False), (50.0, True)]
)
def test_light_that_has_to_turn_is_limited_by_fresnel_and_the_critical_angle(middle, both):
    far = {"half_angle": [1.0, 1.0], "center": [middle, 0.0], "pixels": [8, 8]}
    data = changed({"version": 2, "lens.reflection": "fresnel"}) | {"far_field": far}
    del data["screen"]
    if both:
        data["lens"]["entrance"] = {"shape": "freeform", "control_points": [9, 9]}
    found, turn = limit_of(Scene.from_data(data)).most, math.radians(middle - 1)
    wanted = (1 - R) * transmittance(turn) if middle < 48 else 0.0
    if both:
        wanted = transmittance(turn / 2) ** 2
    assert wanted <= found + 1e-12
    assert found == pytest.approx(wanted, rel=0.01, abs=1e-12)


def test_a_plate_before_a_point_is_near_its_limit():
    point = {"kind": "point", "position": [0.2, 0.0, -2.0], "emission": "lambertian"}
    screen = {"screen.half_width": [9.0, 9.0], "lens.height_range": [-1e-3, 1e-3]}
    scene = scene_of(source=point, **screen)
    plate = FaceArrays({"lens.back": np.full(scene.optic.net_shape, 0.5)})
    light = reached(scene, plate)
    assert light <= limit_of(scene).most * 1.001 < 1.03 * light


def test_etendue_limits_a_lambertian_emitter_before_a_small_receiver():
    """The étendue of two parallel squares: π times area and view factor (Howell, C-11)."""
    changes = {"lens.half_width": [0.5, 0.5], "lens.base.height": 0.1, "lens.min_thickness": 0.05}
    changes |= {"lens.height_range": [-0.01, 0.0], "screen.half_width": [0.5, 0.5], "screen.z": 1.1}
    emitter = LED | {"half_width": [2.0, 2.0], "center": [0, 0, -0.2]}
    found = limit_of(scene_of(source=emitter, **changes))
    x = 1.0  # side over distance
    view = (
        2
        / (math.pi * x**2)
        * (
            math.log(math.sqrt((1 + x**2) ** 2 / (1 + 2 * x**2)))
            + 2 * x * math.sqrt(1 + x**2) * math.atan(x / math.sqrt(1 + x**2))
            - 2 * x * math.atan(x)
        )
    )
    share = view * 1.0 / 16.0  # of the area of the emitter
    assert found.turned > 1.2 * found.most  # étendue binds
    assert found.most == pytest.approx((1 - R) ** 2 * share, rel=5e-3)


def test_etendue_limits_a_wide_sun_before_a_narrow_far_field():
    far = {"half_angle": [2.0, 2.0], "pixels": [8, 8]}
    data = changed({"version": 2, "source": {"kind": "collimated", "angular_diameter": 20.0}})
    data = data | {"far_field": far}
    del data["screen"]
    found = limit_of(Scene.from_data(data)).most
    half = math.radians(2.0)
    receiver = 2 * half * (half + math.sin(2 * half) / 2)  # of the cosine over H and V, about
    share = receiver / (math.pi * math.sin(math.radians(10)) ** 2)
    assert (1 - R) ** 2 * share <= found * 1.001
    assert found < 1.05 * share  # sides of the box that holds the face see a little more


def test_a_lambertian_diffuser_sends_little_to_a_receiver():
    """Gebhart's view factor of a rectangle opposite a point."""
    data = json.loads(path("examples", "diffuser-lens.json").read_text())
    data["elements"][-1]["scatter"] = {"kind": "lambertian"}
    scene = Scene.from_data(data)
    (a, b), h = scene.receiver.half_width, scene.receiver.z - scene.diffuser.position[2]
    share = sum(
        2 / math.pi * x / math.hypot(x, h) * math.atan(y / math.hypot(x, h))
        for x, y in ((a, b), (b, a))
    )
    found = limit_of(scene)
    assert found.most == pytest.approx(share * found.passes, rel=1e-9)


SCENES = {
    "sun": {"source": {"kind": "collimated", "angular_diameter": 20.0}},
    "led": {"source": LED | {"half_width": [0.6, 0.6]}, "screen.half_width": [0.4, 0.4]},
    "led to the side": {"source": LED, "screen.center": [6.0, 0.0], "screen.tilt": [0.0, 30.0]},
    "ellipse": {"source": LED, "lens.outline": "ellipse", "lens.absorption": 0.3},
    "points": {
        "source": {"kind": "grid", "center": [0, 0, -2], "half_width": [1, 1], "points": [5, 5]}
    },
    "both faces": {"source": LED, "lens.entrance": {"shape": "freeform", "control_points": [9, 9]}},
}


@pytest.mark.parametrize("changes", SCENES.values(), ids=SCENES)
def test_no_lens_brings_more_light_than_the_limit(changes):
    """Flat, curved and leaning ones, and the first design, by the independent check."""
    scene = scene_of(**changes)
    limit, first = limit_of(scene).most, next(iter(run(scene, np.ones((32, 32))))).state.heights
    n_u, n_v = scene.optic.net_shape
    u, v = np.linspace(-1, 1, n_u)[:, None], np.linspace(-1, 1, n_v)
    shapes = (0 * u * v, -0.1 * (u**2 + v**2), -0.2 * (u**2 + v**2), -0.2 + 0.15 * u + 0 * v)
    lenses = [FaceArrays(dict(first) | {"lens.back": 0.79 + shape}) for shape in shapes]
    for heights in (first, *lenses):
        assert reached(scene, heights) <= limit * (1 + 2e-3)


def reached(scene, heights):
    """Part of the light that lands on the receiver, by random rays."""
    tally = None
    for batch in Trace(scene, heights, 20_000, seed=1).batches():
        tally = added(tally, batch) if batch is not None else tally
    return tally.flux.sum() / tally.emitted
