"""Trains of tilted and shifted elements against closed forms and against themselves."""

import numpy as np
import pytest
import torch

from tests.optics.rays import Given, bundle
from tests.optics.train.test_behind_glass import from_far
from tests.optics.train.test_elements import into, plate
from tests.optics.train.tilted import (
    ASIDE,
    FOLD,
    LIGHTS,
    SQUARE,
    TurnedTo,
    asphere,
    folded,
    in_frame,
    level_faces,
    mirror,
    own_faces,
    second,
    train,
)
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Ellipse, Rectangle
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Reflection
from workbench.optics.path import Path
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Conic, Plane
from workbench.optics.train.compiled import CompiledTrain


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


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
def test_a_folded_train_is_the_unfolded_one_upside_down(scene, light):
    """The mirror exchanges y and z: what light meets behind it is a mirror image in y."""
    path = train(scene, light, (20, 16), folded(torch.float64), ((0, 6, 1.5), ASIDE))
    straight = in_frame(second(torch.float64), (0, 0, 1.5 + 1.6))
    unfolded = train(scene, light, (20, 16), straight, ((0, 0, 1.5 + 6), (0.0, 0.0, 0.0)))
    heights = own_faces(scene)
    upside_down = heights | {"second": heights["second"].flip(1)}
    hits, _, _ = CompiledTrain(path).nodes(heights)
    expected, _, _ = CompiledTrain(unfolded).nodes(upside_down)
    both = (hits[2] > 0) & (expected[2] > 0)
    assert both.double().mean() > 0.2
    # The mirror takes what misses it, and a tenth of the rest.
    assert (hits[2] - 0.9 * expected[2])[both].abs().max() < 1e-14
    assert ((hits[2] > 0) == (expected[2] > 0)).double().mean() > 0.9
    assert (hits[0] - expected[0])[both].abs().max() < 1e-10
    assert (hits[1] + expected[1] - scene.receiver.pixels[1])[both].abs().max() < 1e-10


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
    heights = own_faces(scene)
    negated = heights | {"second": -heights["second"]}
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


def test_a_path_turned_and_shifted_as_a_whole_is_the_same(scene, rng):
    """Source, faces, the freeform ones too, and receiver: coordinates make no difference."""
    turn = Frame.at((0.4, -0.7, 2.0), (50.0, 20.0, -70.0))

    def whole(step_frame):
        frame = step_frame or Frame.at((0, 0, 0))
        return Frame(turn.position + turn.rotation @ frame.position, turn.rotation @ frame.rotation)

    net = ControlNet.of(scene.optic)
    freeform = BSplineSurface("lens.back", net, 0.0, torch.float64, level=0.5)
    steps = [
        FaceStep(Plane("entrance", 0.0, SQUARE), into(1 / 1.5, "entrance"), "missed_lens"),
        FaceStep(freeform, into(1.5, "lens.back"), "left_side"),
        *folded(torch.float64),
    ]
    screen = Frame.at((0, 6, 1.5), ASIDE)
    x, y = rng.uniform(-0.8, 0.8, (2, 200))
    place = np.column_stack([x, y, np.full(200, -1.0)])
    way = np.column_stack([*rng.uniform(-0.1, 0.1, (2, 200)), np.ones(200)])
    way /= np.linalg.norm(way, axis=1)[:, None]
    found, heights = [], own_faces(scene)
    for turned in (False, True):
        rays = bundle(
            turn.position + place @ turn.rotation.T if turned else place,
            way @ turn.rotation.T if turned else way,
            np.full(200, 1 / 200),
        )
        own = [step._replace(frame=whole(step.frame)) if turned else step for step in steps]
        receiver = TurnedTo(scene.receiver, whole(screen) if turned else screen)
        path = Path(Given(rays), own, receiver, 0.0, Rectangle((99.0, 99.0)), 0, torch.float64)
        leaves = {name: each.clone().requires_grad_() for name, each in heights.items()}
        arrival = path.walk(leaves)
        landing = arrival.rays.flux > 0
        total = (arrival.column[landing] * arrival.rays.flux[landing]).sum()
        gradients = torch.autograd.grad(total, list(leaves.values()))
        (_, *places), _ = path.follow(path.emitter.rays(0), heights)
        on_faces = np.array([[part.numpy() for part in each] for each in places])
        if turned:
            on_faces = np.einsum("ij,fin->fjn", turn.rotation, on_faces - turn.position[:, None])
        found.append((arrival, landing, gradients, on_faces))
    (one, landing, gradients, on_faces), (other, lands, others, same_places) = found
    assert landing.double().mean() > 0.3
    assert (landing == lands).all()
    assert (one.column - other.column)[landing].abs().max() < 1e-10
    assert (one.row - other.row)[landing].abs().max() < 1e-10
    for name, flux in one.lost.items():
        assert other.lost[name].item() == pytest.approx(flux.item(), abs=1e-12)
    for here, there in zip(gradients, others, strict=True):
        assert (here - there).norm() < 1e-9 * here.norm()
    assert same_places[:, :, landing] == pytest.approx(on_faces[:, :, landing], abs=1e-12)
