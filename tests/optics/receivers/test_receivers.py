"""Light on planes anywhere and in the far field: closed forms, gradients, and both tracers."""

import math

import numpy as np
import pytest
import torch
from scipy.interpolate import make_interp_spline

from tests.optics.gradients import check_against_differences
from tests.optics.points import interpolating, smooth
from workbench.analysis.cells.image import imaging
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.path import Path
from workbench.progress import finished, no_progress
from workbench.scene import Screen

RECEIVERS = {
    "aside": {"screen.center": [0.8, -0.3]},
    "tilted": {"screen.center": [1.0, 0.4], "screen.tilt": [15.0, 40.0]},
    "wall": {
        "screen.center": [3.0, 0.0],
        "screen.tilt": [0.0, 90.0],
        "screen.z": 9.0,
        "screen.half_width": [3.0, 1.5],
    },
    "far field": {
        "screen": None,
        "far_field": {"half_angle": [9.0, 7.0], "center": [2.0, 1.0], "pixels": [32, 32]},
    },
}
each_receiver = pytest.mark.parametrize("receiver", RECEIVERS.values(), ids=RECEIVERS)


def lens_for(scene):
    """A lens of soft waves that sends light to the side where its receiver is."""
    x, _ = ControlNet.of(scene.optic).positions
    aside = 0.2 * scene.receiver.center[0] if isinstance(scene.receiver, Screen) else 0.0
    return smooth(scene) + aside * (1 + torch.as_tensor(x)[:, None])


def walked(scene, heights):
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    return path.walk({"lens.back": torch.as_tensor(heights)})


def test_a_plate_casts_its_shadow_on_a_tilted_plane_at_an_angle(make_scene):
    """What is x on a plane across the axis is x / cos of the tilt on one turned about y."""
    scene = make_scene({"screen.tilt": [0.0, 40.0], "screen.half_width": [2.0, 1.5]})
    arrival = walked(scene, np.full((12, 10), 0.5))
    x = (np.arange(64) + 0.5) / 32 - 1
    column, row = scene.receiver.to_pixels(x / math.cos(math.radians(40)), x)
    assert (arrival.column - torch.as_tensor(column)[:, None]).abs().max() < 1e-10
    assert (arrival.row - torch.as_tensor(row)[None, :]).abs().max() < 1e-10


@pytest.mark.parametrize(("slope", "across"), [(0.2, 0.0), (0.1, -0.25)])
def test_a_prism_sends_all_light_in_one_direction(make_scene, slope, across):
    far_field = {"half_angle": [20.0, 20.0], "pixels": [40, 40]}
    scene = make_scene({"screen": None, "far_field": far_field, "lens.height_range": [-0.4, 0.4]})
    x, y = ControlNet.of(scene.optic).positions
    arrival = walked(scene, 0.5 + slope * x[:, None] + across * y)
    # Snell's law at one face: the light turns towards the thick side by refracted less incident.
    steep = math.hypot(slope, across)
    incident = math.atan(steep)
    turn = math.asin(1.5 * math.sin(incident)) - incident
    out = math.sin(turn) * slope / steep, math.sin(turn) * across / steep, math.cos(turn)
    h, v = math.degrees(math.atan2(out[0], out[2])), math.degrees(math.asin(out[1]))
    column, row = scene.receiver.to_pixels(h, v)
    assert (arrival.column - column).abs().max() < 1e-9
    assert (arrival.row - row).abs().max() < 1e-9


def test_a_collimating_oval_sends_the_light_of_a_point_straight_on(make_scene):
    """Equal optical paths from a point to a plane: d/cos + n t + (height − z) is the same."""
    distance, n, thickness = 3.0, 1.5, 0.6
    far_field = {"half_angle": [1.0, 1.0], "pixels": [2, 2]}
    scene = make_scene(
        {
            "screen": None,
            "far_field": far_field,
            "source": {"kind": "point", "position": [0, 0, -distance], "rays": 4096},
            "lens.control_points": [60, 60],
            "lens.degree": [5, 5],
        }
    )
    outer = np.linspace(-0.5, 0.5, 801)
    inner = np.arcsin(np.sin(outer) / n)
    way = (distance + (n - 1) * thickness - distance / np.cos(outer)) / (n - np.cos(inner))
    profile = make_interp_spline(
        distance * np.tan(outer) + way * np.sin(inner), way * np.cos(inner), k=7
    )
    heights = interpolating(ControlNet.of(scene.optic), lambda x, y: profile(np.hypot(x, y)))
    arrival = walked(scene, heights)
    lands = arrival.rays.flux > 0
    assert lands.double().mean() > 0.7
    pixels_per_radian = math.degrees(1.0)
    for place in (arrival.column, arrival.row):
        assert (place[lands] - 1).abs().max() / pixels_per_radian < 2e-6


@each_receiver
def test_gradients_are_those_of_central_differences(make_scene, receiver, rng):
    scene = make_scene(receiver)
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)

    def landing(heights):
        column, row, rays, *_ = path.walk({"lens.back": heights})
        return ((0.3 * column).sin() + (0.2 * row).cos() * rays.flux).sum()

    directions = torch.as_tensor(rng.normal(size=(3, 12, 10)))
    check_against_differences(landing, lens_for(scene).requires_grad_(), directions)


@each_receiver
@pytest.mark.parametrize("fused", [True, False])
def test_all_light_is_accounted_for_and_both_tracers_agree(make_scene, receiver, fused):
    scene = make_scene(receiver)
    heights = lens_for(scene)
    light = BeamPlan(scene, (200, 200), dtype=torch.float64, fused=fused).trace(
        {"lens.back": heights}
    )
    account = light.account
    assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-9)
    image = finished(imaging(scene, {"lens.back": heights.numpy()}, 2e-3), no_progress)
    flux = image.irradiance * scene.receiver.pixel_measure
    assert flux.sum() > 0.1
    assert flux.sum() == pytest.approx(account.on_screen, abs=2e-3)
    difference = np.linalg.norm(light.flux.numpy() - flux) / np.linalg.norm(flux)
    assert difference < 0.03


@each_receiver
def test_places_of_image_coordinates_undo_those_of_places(receiver, make_scene, rng):
    receiver = make_scene(receiver).receiver
    u, v = rng.uniform(-1, 1, (2, 20))
    back = receiver.from_pixels(*receiver.to_pixels(u, v))
    assert np.allclose(back, (u, v), rtol=0, atol=1e-12)
