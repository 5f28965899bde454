"""Light as there is against what is known of it in closed form."""

import math

import numpy as np
import pytest
import torch
from scipy.integrate import solve_ivp

from tests.optics.points import interpolating
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.path import Path
from workbench.optics.samples import Corners

INDEX = 1.5
THIN = 1e-4
WINDOW = {
    "lens.base": {"shape": "flat", "height": THIN},
    "lens.height_range": [-THIN / 2, THIN / 2],
    "lens.min_thickness": 0.0,
    "lens.half_width": [2.0, 2.0],
    "lens.control_points": [4, 4],
    "screen.z": 2.0,
    "screen.half_width": [1.0, 1.0],
    "screen.pixels": [21, 21],
}


def radii(scene):
    """Distances of the middles of pixels from the middle of the screen."""
    (r_x, r_y), (n_x, n_y) = scene.receiver.half_width, scene.receiver.pixels
    x, y = ((2 * (np.arange(n) + 0.5) / n - 1) * r for n, r in ((n_x, r_x), (n_y, r_y)))
    return np.hypot(x, y[:, None])


def irradiance(scene, heights, cells):
    light = BeamPlan(scene, cells, dtype=torch.float64).trace(
        {"lens.back": torch.as_tensor(heights)}
    )
    return light.flux.numpy() / scene.receiver.pixel_measure


def behind_disc(r, radius, distance):
    """Irradiance at places beside the axis of a Lambertian disc that emits 1 (Foote 1915)."""
    far2 = distance**2 + np.square(r)
    root = np.sqrt((far2 + radius**2) ** 2 - 4 * radius**2 * np.square(r))
    return (1 - (far2 - radius**2) / root) / (2 * math.pi * radius**2)


def unreflected(cos, ratio):
    """Part of unpolarised light that a face lets through, by the amplitudes of both kinds."""
    out = np.sqrt(1 - ratio**2 * (1 - cos**2))
    across, along = (
        4 * ratio * cos * out / np.square(a) for a in (ratio * cos + out, cos + ratio * out)
    )
    return (across + along) / 2


@pytest.mark.parametrize("radius", [0.05, 0.5, 1.0])
def test_a_lambertian_disc_lights_the_screen_by_the_form_factor(make_scene, radius):
    disc = {"kind": "area", "center": [0, 0, -1.0], "half_width": [radius, radius]}
    disc |= {"outline": "ellipse"}
    scene = make_scene(WINDOW | {"source": disc, "lens.reflection": "none"})
    found = irradiance(scene, np.full((4, 4), THIN), Corners(160, 160, 256))
    wanted = behind_disc(radii(scene), radius, 3.0)
    assert np.linalg.norm(found - wanted) < 1e-3 * np.linalg.norm(wanted)


def test_a_small_lambertian_disc_lights_the_screen_by_the_fourth_power_of_the_cosine(make_scene):
    disc = {"kind": "area", "center": [0, 0, -1.0], "half_width": [1e-3, 1e-3]}
    disc |= {"outline": "ellipse"}
    scene = make_scene(WINDOW | {"source": disc, "lens.reflection": "fresnel"})
    found = irradiance(scene, np.full((4, 4), THIN), Corners(320, 320, 1))
    cos = 3 / np.hypot(3, radii(scene))
    in_glass = np.sqrt(1 - (1 - cos**2) / INDEX**2)
    through = unreflected(cos, 1 / INDEX) * unreflected(in_glass, INDEX)
    wanted = cos**4 / (math.pi * 3.0**2) * through
    assert np.linalg.norm(found - wanted) < 1e-3 * np.linalg.norm(wanted)


def test_a_gaussian_beam_becomes_a_top_hat(make_scene):
    """A beam's light within r is that of a disc within R: 1 − exp(−2 r²/w²) = R²/R₀²."""
    waist, widest, distance, middle = 0.8, 0.6, 5.0, 0.5

    def slope(r, height):
        to = widest * math.sqrt(-math.expm1(-2 * r**2 / waist**2))
        way = math.atan2(to - r, distance - height[0])
        return [math.sin(way) / (INDEX - math.cos(way))]  # which refracts light of +z that way

    rim = 1.5
    profile = solve_ivp(slope, (0, rim), [middle], rtol=1e-11, atol=1e-12, dense_output=True).sol
    beam = {"kind": "collimated", "profile": {"kind": "gaussian", "radius": waist}}
    scene = make_scene(
        {
            "source": beam,
            "lens.reflection": "none",
            "lens.control_points": [60, 60],
            "lens.degree": [5, 5],
            "screen.half_width": [0.4, 0.4],
        }
    )

    def height(x, y):
        r = np.hypot(x, y)
        return profile(r.ravel())[0].reshape(r.shape)

    heights = interpolating(ControlNet.of(scene.optic), height)
    found = irradiance(scene, heights, (400, 400))
    even = 1 / (math.pi * widest**2)
    assert np.linalg.norm(found / even - 1) < 1e-3 * math.sqrt(found.size)


def test_a_hyperboloid_sends_parallel_light_through_one_point(make_scene):
    """In the far field light has the direction from its place on the face to the focus."""
    focal, middle = 4.0, 0.5
    far_field = {"half_angle": [20.0, 20.0], "center": [2.0, -1.0], "pixels": [40, 40]}
    scene = make_scene(
        {
            "screen": None,
            "far_field": far_field,
            "lens.control_points": [40, 40],
            "lens.degree": [5, 5],
            "source.rays": [50, 40],
        }
    )

    def height(x, y):
        """Equal optical paths: n z + the way to the focus is the same."""
        r2 = np.square(x) + np.square(y)
        half, index2_minus_1 = focal * (INDEX - 1), INDEX**2 - 1
        return middle - (np.sqrt(half**2 + index2_minus_1 * r2) - half) / index2_minus_1

    heights = interpolating(ControlNet.of(scene.optic), height)
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    arrival = path.walk({"lens.back": torch.as_tensor(heights)})
    x, y = ((2 * (np.arange(n) + 0.5) / n - 1) for n in (50, 40))
    ahead = middle + focal - height(x[:, None], y)
    h = np.degrees(np.arctan2(-x[:, None], ahead))
    v = np.degrees(np.arctan2(-y, np.hypot(x[:, None], ahead)))
    column, row = scene.receiver.to_pixels(h, v)
    for found, wanted in ((arrival.column, column), (arrival.row, row)):
        assert np.radians(np.abs(found.numpy() - wanted)).max() < 1e-6
