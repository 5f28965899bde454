"""Trains of elements in all places against closed forms and against themselves."""

import numpy as np
import pytest
import torch

from tests.optics.train.trains import (
    ASIDE,
    FOLD,
    INDEX,
    LIGHTS,
    SQUARE,
    asphere,
    before,
    from_far,
    from_near,
    heights_of,
    in_frame,
    level_faces,
    mirror,
    plate,
    second,
    train,
    window,
)
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Ellipse, Rectangle
from workbench.optics.interfaces import Reflection, Refraction, laws_of
from workbench.optics.reference import Reference
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Conic, Plane
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import Scene

FLAT = {"screen.half_width": [10, 10], "screen.pixels": [20, 20], "lens.reflection": "fresnel"}


def test_an_afocal_pair_of_hyperboloids_gives_parallel_light(make_scene):
    """Conics of −n² share their focus: light is parallel again, and −f₂ / f₁ times as wide."""
    scene = make_scene({"screen.half_width": [4, 4], "screen.pixels": [40, 40]})
    index, focal = 1.6, (2.0, 5.0)
    outline = Rectangle((3.0, 3.0))
    first, second_radius = ((index - 1) * f for f in focal)
    back = Conic("back", 0.5, -1 / first, -(index**2), outline)
    telescope = plate(outline, Plane("front", 0.0, outline), back, index)
    front = Conic("front", 0.0, 1 / second_radius, -(index**2), outline)
    widens = plate(outline, front, Plane("back", 0.5, outline), index)
    # The second lens is in a train of mirrors, so that its frame is not along the axis.
    fold = Frame.at((0, 0, 2.0), FOLD)
    flat = Plane("fold", 0.0, outline)
    way = 1.0 + 0.5 + sum(focal) - 2.0  # from the mirror to the second lens
    found = []
    for beyond in (1.0, 7.0):
        behind = [
            *in_frame(telescope, (0, 0, 1.0)),
            FaceStep(flat, Reflection(1.0, "absorbed"), "missed_mirror", fold),
            *in_frame(widens, (0, way, 2.0), ASIDE),
        ]
        screen = (0, way + 0.5 + beyond, 2.0), ASIDE
        path = train(scene, from_far(1, 0.0), (20, 16), behind, screen)
        hits = CompiledTrain(path).nodes(level_faces(scene)).hits
        assert (hits[2] > 0).all()
        found.append(hits)
    assert (found[0][:2] - found[1][:2]).abs().max() < 1e-9
    x = np.linspace(-1, 1, 21)
    expected = 20 - focal[1] / focal[0] * x / 4 * 20
    assert found[0][0].numpy() == pytest.approx(np.tile(expected, (17, 1)), abs=1e-9)


@pytest.mark.parametrize("tilt", [(25.0, 0.0, 0.0), (0.0, -25.0, 0.0)])
def test_a_tilted_plate_shifts_light(make_scene, tilt):
    """By t sin θ (1 − cos θ / (n cos θ')), across the light, to where the plate leans."""
    scene = make_scene({"screen.half_width": [2, 2], "screen.pixels": [40, 40]})
    index, thick, outline = 1.6, 0.4, Rectangle((4.0, 4.0))
    faces_of_plate = Plane("front", 0.0, outline), Plane("back", thick, outline)
    behind = in_frame(plate(outline, *faces_of_plate, index), (0.3, -0.2, 2.0), tilt)
    path = train(scene, from_far(1, 0.0), (10, 10), behind)
    columns, rows, _ = CompiledTrain(path).nodes(level_faces(scene)).hits
    angle = np.radians(25)
    inside = np.arcsin(np.sin(angle) / index)
    shift = thick * np.sin(angle) * (1 - np.cos(angle) / (index * np.cos(inside)))
    # Its normal leans to −y for a turn about +x, and to −x for one about −y; light follows it.
    moved = (0.0, -shift) if tilt[0] else (-shift, 0.0)
    x = np.linspace(-1, 1, 11)
    assert columns.numpy() == pytest.approx(np.tile(20 + 10 * (x + moved[0]), (11, 1)), abs=1e-9)
    y = x[:, None] + moved[1]
    assert rows.numpy() == pytest.approx(np.tile(20 - 10 * y, (1, 11)), abs=1e-9)


def test_a_shifted_lens_shifts_its_focus(make_scene):
    index, radius, shift = 1.6, 3.0, (0.3, -0.2)
    focus = 1.5 + radius / (index - 1)
    scene = make_scene({"screen.z": focus, "screen.half_width": [1, 1], "screen.pixels": [20, 20]})
    outline = Rectangle((2.0, 2.0))
    back = Conic("back", 0.5, -1 / radius, -(index**2), outline)
    lens = plate(outline, Plane("front", 0.0, outline), back, index)
    path = train(scene, from_far(1, 0.0), (20, 20), in_frame(lens, (*shift, 1.0)))
    columns, rows, flux = CompiledTrain(path).nodes(level_faces(scene)).hits
    assert (flux > 0).all()
    assert (columns - (10 + 10 * shift[0])).abs().max() < 1e-9
    assert (rows - (10 - 10 * shift[1])).abs().max() < 1e-9


@pytest.mark.parametrize("surface", ["freeform", "asphere"])
def test_a_lens_met_from_behind_is_its_mirror_image(scene, surface):
    """Behind a plane mirror, light to −z meets the back of a lens first."""
    lens = second(torch.float64) if surface == "freeform" else asphere()
    # A lens whose media are exchanged: light comes to its back face first.
    front, back = in_frame(lens, (0.1, 0.2, 0.8))
    indices = front._replace(surface=back.surface), back._replace(surface=front.surface)
    (flat,) = mirror(Plane("mirror", 0.0, Rectangle((4.0, 4.0))), (0, 0, 3.0), (0.0, 0.0, 0.0), 1.0)
    returning = [flat, *(step.facing(np.array([0.0, 0.0, -1.0])) for step in indices)]
    assert all((step.frame.rotation[:, 2] == [0, 0, -1]).all() for step in returning[1:])
    screen = (0.0, 0.0, -4.0), (180.0, 0.0, 0.0)
    path = train(scene, LIGHTS["points"], (20, 16), returning, screen)
    # Unfolded: mirrored in the plane z = 3, which negates heights and curvatures.
    image = [step._replace(surface=mirrored(step.surface)) for step in indices]
    unfolded = in_frame(image, (0.1, 0.2, 6.0 - 0.8))
    straight = train(
        scene, LIGHTS["points"], (20, 16), unfolded, ((0.0, 0.0, 10.0), (0.0, 0.0, 0.0))
    )
    heights = heights_of(path)
    negated = {name: -z if name == "second" else z for name, z in heights.items()}
    hits, _, _ = CompiledTrain(path).nodes(heights)
    expected, _, _ = CompiledTrain(straight).nodes(negated)
    both = hits[2] > 0
    assert both.double().mean() > 0.15
    assert (both == (expected[2] > 0)).all()
    assert (hits[2] - expected[2]).abs().max() < 1e-14
    assert (hits[0] - expected[0])[both].abs().max() < 1e-10
    # The screen is turned about x: its rows count the other way.
    assert (hits[1] + expected[1] - scene.receiver.pixels[1])[both].abs().max() < 1e-10


def mirrored(surface):
    """The mirror image of a surface in its plane z = 0."""
    if isinstance(surface, Conic):
        terms = [-each for each in surface.coefficients]
        given = -surface.z, -surface.curvature, surface.conic, surface.outline
        return Conic(surface.name, *given, terms)
    return BSplineSurface(
        surface.name, surface.net, 0.0, torch.float64, outline=surface.outline, level=-surface.level
    )


def test_an_outline_cuts_where_its_element_stands(make_scene):
    """An ellipse of its own, shifted and turned, in parallel light."""
    scene = make_scene({"screen.half_width": [2, 2]})
    outline, shift, angle = Ellipse((0.8, 0.4)), np.array([0.2, -0.1]), 30.0
    faces_of_plate = Plane("front", 0.0, outline), Plane("back", 0.1, outline)
    behind = in_frame(plate(outline, *faces_of_plate), (*shift, 2.0), (0.0, 0.0, angle))
    path = train(scene, from_far(1, 0.0), (60, 50), behind)
    nodes, account, rim = CompiledTrain(path).nodes(level_faces(scene))
    x, y = np.meshgrid(np.linspace(-1, 1, 61), np.linspace(-1, 1, 51))
    u, v = x - shift[0], y - shift[1]
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    radius = np.hypot((c * u + s * v) / 0.8, (c * v - s * u) / 0.4)
    clear = abs(radius - 1) > 1e-5
    assert ((nodes[2].numpy() > 0) == (radius < 1))[clear].all()
    inside = radius < 1
    assert rim.numpy()[inside] == pytest.approx((1 - radius)[inside], abs=2e-6)
    part = np.pi * 0.8 * 0.4 / 4  # of the light in the square, which two faces have reflected
    assert account.lost["missed_lens"] == pytest.approx((1 - part) * 0.96**2, rel=0.01)


def slab(slope, thickness, index):
    """How far light of a slope moves aside in a slab."""
    sine = slope / np.sqrt(1 + slope**2) / index
    return thickness * sine / np.sqrt(1 - sine**2)


def slopes_at(cells, outline, distance):
    """Slopes of light of a point on the axis at corners of an aperture, shape (m_y, m_x)."""
    x, y = (
        (2 * np.arange(n + 1) / n - 1) * r / distance
        for n, r in zip(cells, outline.half_width, strict=True)
    )
    return x[None, :], y[:, None]


@pytest.mark.parametrize(("dtype", "accuracy"), [(torch.float64, 1e-9), (torch.float32, 1e-4)])
def test_light_of_the_centre_of_a_concentric_dome_passes_straight(make_scene, dtype, accuracy):
    """Each face takes ((n − 1) / (n + 1))² at any angle, and nothing else changes."""
    scene, cells, thickness = make_scene(FLAT), (20, 16), 0.5
    inner, outer, source = 1.0, 1.5, -3.0
    outline, wide = Rectangle((0.2, 0.25)), Rectangle((0.4, 0.4))

    def dome(datum):
        faces = (
            Conic("", source + radius - datum, -1 / radius, 0.0, wide) for radius in (inner, outer)
        )
        return plate(wide, *faces, absorption=0.3)

    light = from_near(1, (0, 0, source), 0.0)
    path = before(scene, light, cells, dome, outline, source + inner, dtype)
    heights = {"lens.back": torch.full(scene.optic.net_shape, thickness, dtype=torch.float64)}
    nodes = CompiledTrain(path).nodes(heights)
    a, b = slopes_at(cells, outline, inner)
    slope = np.hypot(a, b)
    aside = slope * (scene.receiver.z - source - thickness) + slab(
        slope, thickness, scene.optic.index
    )
    columns, rows = (10 + part * aside / np.where(slope > 0, slope, 1) for part in (a, -b))
    assert nodes.hits[0].numpy() == pytest.approx(columns, abs=accuracy)
    assert nodes.hits[1].numpy() == pytest.approx(rows, abs=accuracy)
    passed = (1 - ((INDEX - 1) / (INDEX + 1)) ** 2) ** 2 * np.exp(-0.3 * (outer - inner))
    there = light.light(a * inner, b * inner, source + inner, np.array(0))
    cell = 4 * np.prod(outline.half_width) / np.prod(cells)
    middle = there.density[1:-1, 1:-1] * cell * passed
    behind = nodes.hits[2].numpy()[1:-1, 1:-1]
    glass = Refraction(laws_of(scene.optic)[0], "").law
    cos = 1 / np.sqrt(1 + slope**2)[1:-1, 1:-1]
    inside = np.sqrt(1 - (1 - cos**2) / scene.optic.index**2)
    assert behind == pytest.approx(middle * glass.at(cos, inside) ** 2, rel=10 * accuracy)


@pytest.mark.parametrize("tilt", [0.0, 0.15])
def test_a_plate_before_the_lens_shifts_light_towards_the_axis(make_scene, tilt):
    """By t (tan θ − tan θ'); the same place behind a lens that is a plate itself."""
    scene, cells, thick = make_scene(FLAT), (16, 12), 0.7
    outline, wide = Rectangle((0.15, 0.1)), Rectangle((0.9, 0.9))
    path = before(
        scene,
        from_near(1, (tilt, 0, -3), 0.0),
        cells,
        lambda datum: window(-2.0 - datum, -2.0 + thick - datum, wide),
        outline,
    )
    heights = {"lens.back": torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64)}
    nodes = CompiledTrain(path).nodes(heights)
    a, b = slopes_at(cells, outline, 1.0)
    a = a - tilt
    slope = np.hypot(a, b)
    aside = slope * (scene.receiver.z + 3 - thick - 0.5)
    aside = aside + slab(slope, thick, INDEX) + slab(slope, 0.5, scene.optic.index)
    by_slope = aside / np.where(slope > 0, slope, 1)
    assert nodes.hits[0].numpy() == pytest.approx(10 + tilt + a * by_slope, abs=1e-9)
    assert nodes.hits[1].numpy() == pytest.approx(10 - b * by_slope, abs=1e-9)


def test_a_fixed_collimator_before_a_plate():
    """A hyperbolic front, then a plane: light of its focus is parallel behind, and so it stays."""
    scene = Scene.from_data(
        {
            "format": "freeform-scene",
            "version": 2,
            "lens": {"half_width": [1, 1], "control_points": [9, 8], "refractive_index": 1.5},
            "source": {"kind": "collimated"},
            "far_field": {"half_angle": [10, 10], "pixels": [20, 20]},
            "target": {"builtin": "tophat"},
        }
    )
    radius, front = 0.9, -1.5
    focus = front - radius / (INDEX - 1)

    def collimator(datum):
        faces = (
            Conic("front", front - datum, 1 / radius, -(INDEX**2), SQUARE),
            Plane("back", -0.5 - datum, SQUARE),
        )
        return plate(SQUARE, *faces)

    light, outline = from_near(1, (0, 0, focus), 0.0), Ellipse((0.6, 0.6))
    path = before(scene, light, (20, 20), collimator, outline, front)
    heights = {"lens.back": torch.full((9, 8), 0.3, dtype=torch.float64)}
    for tracer in (CompiledTrain(path), Reference(path)):
        nodes = tracer.nodes(heights)
        columns, rows, flux = nodes.hits
        lit = flux > 0
        assert lit.double().mean() > 0.7
        assert (columns[lit] - 10).abs().max() < 1e-9
        assert (rows[lit] - 10).abs().max() < 1e-9
        assert sum(nodes.account.to_data().values()) == pytest.approx(2, abs=1e-12)
