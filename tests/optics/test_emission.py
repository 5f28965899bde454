"""Light that enters the lens, and the cap of a source."""

import math

import numpy as np
import pytest
from scipy.optimize import minimize

from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import laws_of
from workbench.optics.path import Path
from workbench.optics.sources.emission import covering_caps, entering
from workbench.optics.sources.origins import spread

POINT = {"kind": "point", "position": [0.3, -0.2, -5.0], "rays": 1 << 16}


GRID = {"kind": "grid", "center": [0, 0.1, -1], "half_width": [1, 1], "points": [3, 4]}


@pytest.mark.parametrize("distance", [1e-6, 1e-3, 0.5, 5.0, 1e3])
def test_a_square_seen_from_its_axis(make_scene, distance):
    scene = make_scene({"source": POINT | {"position": [0, 0, -distance]}})
    light = entering(scene.source, scene.optic, laws_of(scene.optic)[0])
    square = 4 * np.arcsin(1 / (1 + distance**2))  # its solid angle
    rim = np.sqrt(distance**2 / (distance**2 + 2))
    cap = 2 * np.pi * (2 / (distance**2 + 2)) / (1 + rim)
    assert light.missed == pytest.approx(1 - square / cap, abs=1e-9)


@pytest.mark.parametrize("emission", ["uniform", "lambertian"])
@pytest.mark.parametrize(
    "source",
    [POINT, POINT | {"position": [3, 0, -1]}, POINT | {"position": [0.9, 1, -1e-3]}, GRID],
    ids=["far", "beside", "near", "grid"],
)
def test_the_account_is_that_of_many_rays(make_scene, source, emission):
    scene = make_scene({"source": source | {"rays": 1 << 15, "emission": emission}})
    light = entering(scene.source, scene.optic, laws_of(scene.optic)[0])
    lost = Path.of(scene, ControlNet.of(scene.optic)).lost
    assert light.missed == pytest.approx(lost["missed_lens"].item(), abs=5e-4)
    assert light.reflected == pytest.approx(lost["fresnel_entrance"].item(), abs=5e-4)


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
@pytest.mark.parametrize("aspect", [1e-6, 1.0, 1e6])
def test_places_of_slim_sources_are_finite_and_have_all_light(outline, aspect):
    found = spread(512, outline, aspect)
    assert np.abs([found.x, found.y]).max() < 1
    assert found.share.min() >= 0
    assert found.share.sum() == pytest.approx(1)


def corners(position, half_width, z):
    r_x, r_y = half_width
    directions = np.array([[x, y, z] for x in (-r_x, r_x) for y in (-r_y, r_y)]) - position
    return directions / np.linalg.norm(directions, axis=1, keepdims=True)


@pytest.mark.parametrize("half_width", [(1.0, 1.0), (0.5, 2.0), (100.0, 1.0)])
@pytest.mark.parametrize("distance", [1e-3, 1.0, 5.0, 1e4, 1e7, 1e9, 1e12])
def test_cap_of_a_source_on_the_axis_is_that_of_the_paper(half_width, distance):
    cap = covering_caps(np.array([[0.0, 0.0, 2 - distance]]), half_width, 2.0)
    distance = 2 - (2 - distance)  # as rounding leaves it
    assert cap.axis[0] == pytest.approx([0, 0, 1], abs=1e-12)
    assert cap.centre[0] == pytest.approx([0, 0], abs=1e-11)
    angle = math.atan(math.hypot(*half_width) / distance)
    assert cap.cos_max[0] == pytest.approx(math.cos(angle), abs=1e-11)
    assert cap.solid_angle[0] == pytest.approx(4 * math.pi * math.sin(angle / 2) ** 2, rel=1e-11)


@pytest.mark.parametrize("half_width", [(1.0, 1.0), (1.0, 0.01)])
def test_far_away_it_is_the_circle_around_the_face_as_seen(half_width):
    """Of a parallelogram the longer diagonal is the diameter of that circle."""
    directions = np.array([[0.3, -0.2, 0.9], [0.6, 0.6, 0.5], [0.0, 0.999, 0.04], [0.0, 0.0, 1.0]])
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    caps = covering_caps(-1e12 * directions, half_width, 0.0)
    diagonals = np.array([[2, 2, 0], [2, -2, 0]]) * [*half_width, 0.0]
    across = np.linalg.norm(np.cross(diagonals[:, None], directions), axis=2).max(axis=0)
    assert caps.versine == pytest.approx((across / 2 / 1e12) ** 2 / 2, rel=1e-10)
    assert np.abs(caps.centre).max() < 1e-9


def test_off_the_axis_it_holds_all_corners_and_none_is_smaller(rng):
    for _ in range(60):
        position = np.append(rng.uniform(-3, 3, 2), -(10 ** rng.uniform(-2, 1)))
        half_width = tuple(10 ** rng.uniform(-1, 0.5, 2))
        directions = corners(position, half_width, 0.0)
        caps = covering_caps(position[None], half_width, 0.0)
        (axis,), (cos_max,) = caps.axis, caps.cos_max
        assert np.linalg.norm(axis) == pytest.approx(1)
        assert (directions @ axis >= cos_max).all()
        there = position - position[2] / axis[2] * axis
        assert caps.centre[0] == pytest.approx(there[:2], abs=1e-9)

        others = rng.normal(size=(2000, 3)) * 10 ** rng.uniform(-6, 0, (2000, 1)) + axis
        others /= np.linalg.norm(others, axis=1, keepdims=True)
        assert (others @ directions.T).min(axis=1).max() <= cos_max + 2e-12

        def worst(other, directions=directions):
            return -(directions @ (other / np.linalg.norm(other))).min()

        found = minimize(worst, directions.mean(axis=0), method="Nelder-Mead")
        assert -found.fun <= cos_max + 1e-9
