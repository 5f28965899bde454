"""Faces from slopes, refitted faces, and rays that meet them."""

from pathlib import Path

import numpy as np
import pytest

from workbench.design.transport import refitted, transport_start
from workbench.design.transport.cells import met
from workbench.design.transport.faces import FaceLight, SlopeFit
from workbench.design.transport.one_face import cells_for
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene
from workbench.targets import load_target


@pytest.mark.parametrize(
    ("shape", "degree"), [((9, 14), (3, 3)), ((2, 5), (1, 2)), ((40, 30), (2, 5))]
)
def test_a_face_comes_back_from_its_slopes(rng, shape, degree):
    net = ControlNet(shape, degree, (1.5, 0.4))
    places = (np.arange(64) + 0.5) / 64
    fit = SlopeFit(net, 64)
    heights = rng.normal(size=shape)
    surface, slope_x, slope_y = net.grid(places, places).evaluate(heights)
    assert fit.surface(heights) == pytest.approx(surface, abs=1e-12)
    found = fit.heights(slope_x, slope_y)
    assert np.ptp(found - heights) < 1e-6


def test_rotational_slopes_are_fitted_by_least_squares():
    net = ControlNet((12, 12), (3, 3), (1.0, 1.0))
    places = (np.arange(48) + 0.5) / 48
    x = 2 * places - 1
    slope_x, slope_y = np.broadcast_arrays(-x[None, :], x[:, None])
    found = SlopeFit(net, 48).heights(slope_x, slope_y)
    _, made_x, made_y = net.grid(places, places).evaluate(found)
    # The best face is not zero on a square, but it is perpendicular to the residual.
    left = ((slope_x - made_x) * made_x + (slope_y - made_y) * made_y).mean()
    assert left == pytest.approx(0.0, abs=1e-9)
    assert np.mean((slope_x - made_x) ** 2 + (slope_y - made_y) ** 2) > 0.05


CELL = 0.1, 0.05


@pytest.fixture
def middles():
    """Middles of 20 × 40 cells."""
    x, y = np.indices((20, 40), np.float64)
    return (x - 9.5) * CELL[0], (y - 19.5) * CELL[1]


def test_rays_meet_a_plane_that_leans_where_lines_do(middles, rng):
    x, y = middles
    face = 0.3 + 0.4 * x - 0.2 * y, np.full_like(x, 0.4), np.full_like(x, -0.2)
    place, rise = rng.uniform(-0.3, 0.3, (2, 30, 50)), rng.uniform(-0.5, 0.5, (2, 30, 50))
    height, slope_x, slope_y = met(face, CELL, place, rise)
    z = (0.3 + 0.4 * place[0] - 0.2 * place[1]) / (1 - 0.4 * rise[0] + 0.2 * rise[1])
    assert height == pytest.approx(z, abs=1e-12)
    assert slope_x == pytest.approx(0.4) and slope_y == pytest.approx(-0.2)


def test_rays_meet_a_bowl_within_a_hundredth_of_a_cell(middles, rng):
    x, y = middles
    face = 0.2 * x**2 + 0.3 * y**2, 0.4 * x, 0.6 * y
    place, rise = rng.uniform(-0.6, 0.6, (2, 40, 40)), rng.uniform(-0.8, 0.8, (2, 40, 40))
    height, slope_x, slope_y = met(face, CELL, place, rise)
    at_x, at_y = (p + r * height for p, r in zip(place, rise, strict=True))
    assert height == pytest.approx(0.2 * at_x**2 + 0.3 * at_y**2, abs=1e-3)
    assert slope_x == pytest.approx(0.4 * at_x, abs=1e-2)
    assert slope_y == pytest.approx(0.6 * at_y, abs=1e-2)


SOURCES = {
    "collimated": {"kind": "collimated"},
    "slanted": {"kind": "collimated", "direction": [2.0, -3.0]},
    "point": {"kind": "point", "position": [0.1, 0.0, -5.0]},
    "sun": {"kind": "collimated", "angular_diameter": 0.533},
}


EDITS = {
    "index": {"lens": {"refractive_index": 1.55}},
    "distance": {"screen": {"z": 5.5}},
    "size of the image": {"screen": {"half_width": [1.1, 1.1]}},
    "place of the image": {"screen": {"center": [0.2, -0.1]}},
    "pixels": {"screen": {"pixels": [48, 24]}},
}


DATA = {
    "version": 2,
    "unit": "cm",
    "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [24, 24]},
    "source": SOURCES["collimated"],
    "screen": {"z": 5, "half_width": [1, 1], "pixels": [32, 32]},
    "target": {"builtin": "flame"},
}


def scene_of(light="collimated", **changes):
    data = DATA | {"source": SOURCES[light]}
    return Scene.from_data(data | {part: data[part] | new for part, new in changes.items()})


def designed(scene):
    heights = transport_start(scene, load_target(scene, Path()))
    assert heights is not None
    return heights


@pytest.fixture(scope="module", params=SOURCES)
def before(request):
    """A source, its scene before an edit, and the lens of that."""
    scene = scene_of(request.param)
    return request.param, scene, designed(scene)


def lands(scene, heights):
    """Where light lands, in parts of the receiver."""
    net = ControlNet.of(scene.optic)
    cells = cells_for(net)
    places = FaceLight(scene, net, SlopeFit(net, cells), cells).goes_to(heights)
    column, row = scene.receiver.to_pixels(*places)
    return np.stack([column / scene.receiver.pixels[0], row / scene.receiver.pixels[1]])


@pytest.mark.parametrize("edit", EDITS)
def test_light_goes_to_the_same_parts_of_the_image_after_an_edit(before, edit):
    source, earlier, heights = before
    scene = scene_of(source, **EDITS[edit])
    wanted = lands(earlier, heights)
    off = lands(scene, refitted(earlier, heights, scene)) - wanted
    stale = lands(scene, heights) - wanted
    assert np.sqrt(np.square(off).mean()) < 1e-3
    assert edit == "pixels" or np.sqrt(np.square(stale).mean()) > 1e-2


def test_light_of_a_mirror_goes_where_it_went():
    def mirror(z):
        optic = {"half_width": [1, 1], "control_points": [24, 24]}
        screen = DATA["screen"] | {"z": z, "center": [3.0, 0.0]}
        return Scene.from_data(DATA | {"lens": None, "mirror": optic, "screen": screen})

    before, scene = mirror(-5.0), mirror(-5.3)
    heights = designed(before)
    off = lands(scene, refitted(before, heights, scene)) - lands(before, heights)
    assert np.sqrt(np.square(off).mean()) < 2e-3


def test_slanted_light_leaves_a_strip_of_the_exit_face_dark():
    """It enters a plate 0.5 thick through its aperture, and goes towards +x in it."""
    source = {"kind": "collimated", "direction": [0.0, 20.0]}
    scene = Scene.from_data(DATA | {"source": source})
    net, cells = ControlNet.of(scene.optic), 128
    flux = FaceLight(scene, net, SlopeFit(net, cells), cells).flux(np.full(net.shape, 0.5))
    (way,) = scene.source.directions(np.zeros(1), np.zeros(1))
    aside = 0.5 * np.tan(np.arcsin(way[:2] / scene.optic.index))
    dark = np.flatnonzero(flux.sum(axis=1) == 0)
    assert aside[0] > 0.1 and aside[1] == pytest.approx(0)
    assert len(dark) == pytest.approx(aside[0] / 2 * cells, abs=2)
    assert dark[0] == 0 and np.ptp(dark) == len(dark) - 1
