"""Fixed faces before the first freeform one: against the walk in torch, and closed forms."""

import math

import numpy as np
import pytest
import torch

from tests.optics.kernels.twins import lens
from tests.optics.train.test_behind_glass import Light, from_far, from_near
from tests.optics.train.test_elements import landed
from workbench.geometry.outlines import Ellipse, Rectangle
from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account
from workbench.optics.interfaces import Refraction, TransmittanceLaw
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.sources import Origins
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import Conic, Plane
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import GaussianFilter, Scene

INDEX = 1.6
LIGHTS = {
    "directions": from_far(3, 0.03, (0.1, -0.05)),
    "points": from_near(3, (0.1, 0, -5), 0.3, lambertian=True),
}


def element(front, back, index=INDEX, absorption=0.1):
    """A fixed lens of two faces."""
    entering = Refraction(TransmittanceLaw.fresnel(1 / index), "fresnel_entrance")
    leaving = Refraction(TransmittanceLaw.fresnel(index), "fresnel_exit", absorption)
    return [FaceStep(front, entering, "missed_lens"), FaceStep(back, leaving, "left_side")]


def plate(front_z, thickness, outline, **options):
    faces = (Plane("plane", z, outline) for z in (front_z, front_z + thickness))
    return element(*faces, **options)


def biconvex(outline, datum):
    faces = (
        Conic("front", -2.0 - datum, 0.2, -0.5, outline),
        Conic("back", -1.2 - datum, -0.25, 0.3, outline),
    )
    return element(*faces)


BEFORE = {
    "plate": lambda outline, datum: plate(-2.0 - datum, 0.4, outline),
    "biconvex": biconvex,
    "biconvex and plate": lambda outline, datum: [
        *biconvex(outline, datum),
        *plate(-0.8 - datum, 0.3, outline),
    ],
}


def path_of(scene, emitter, before, outline, front_z, dtype=torch.float64):
    """The path of a scene with fixed faces before its lens."""
    flat = Path.of(scene, ControlNet.of(scene.optic), dtype)
    steps = [*before, *flat.steps]
    return Path(emitter, steps, flat.receiver, flat.datum, outline, 0, dtype, front_z=front_z)


def datum_of(scene):
    return Path.of(scene, ControlNet.of(scene.optic)).datum


@pytest.fixture
def scene(make_scene):
    return make_scene(
        {"lens.reflection": "fresnel", "screen.half_width": [3, 3], "lens.absorption": 0.2}
    )


def twins(scene, light, before, outline, cells=(30, 24), dtype=torch.float64):
    faces = before(outline, datum_of(scene))
    path = path_of(scene, Light(light, Corners(*cells)), faces, outline, -2.0, dtype)
    assert CompiledTrain.matches(path)
    return Reference(path), CompiledTrain(path)


@pytest.mark.parametrize(
    "outline", [Rectangle((0.9, 0.8)), Ellipse((0.9, 0.8)), Ellipse((1.5, 1.4))], ids=str
)
@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
@pytest.mark.parametrize("before", BEFORE.values(), ids=BEFORE)
def test_twins_agree(scene, before, light, outline):
    tracers, heights = twins(scene, light, before, outline), {"lens.back": lens(scene, 1, 0.01)}
    cotangent = torch.tensor(np.random.default_rng(0).normal(size=(4, len(light.flux) * 25, 31)))
    (nodes, account, gradients), (fused, fused_account, fused_gradients) = (
        landed(tracer, heights, cotangent) for tracer in tracers
    )
    assert ((nodes[2] > 0) == (fused[2] > 0)).all()
    assert (nodes[2] > 0).double().mean() > 0.1
    assert (fused - nodes).abs().max() < 1e-9 * (1 + nodes.abs().max())
    assert fused_account == pytest.approx(account, abs=1e-12)
    assert sum(fused_account.values()) == pytest.approx(2, abs=1e-12)  # and once as emitted
    assert (fused_gradients[0] - gradients[0]).norm() < 1e-8 * gradients[0].norm()


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
def test_gradients_are_those_of_central_differences(scene, light):
    _, tracer = twins(scene, light, biconvex, Rectangle((0.9, 0.8)), (20, 16))
    generator, heights, step = np.random.default_rng(0), lens(scene, 3, 0.01), 1e-6
    cotangent = torch.tensor(generator.normal(size=(4, len(light.flux) * 17, 21)))
    _, _, (gradient,) = landed(tracer, {"lens.back": heights}, cotangent)
    way = torch.tensor(generator.normal(size=heights.shape))
    ahead, behind = (
        landed(tracer, {"lens.back": heights + sign * step * way}, cotangent)[0] * cotangent
        for sign in (1, -1)
    )
    assert ((ahead[2] != 0) == (behind[2] != 0)).all()
    expected = ((ahead - behind).sum() / (2 * step)).item()
    assert (gradient * way).sum().item() == pytest.approx(expected, rel=5e-6)


@pytest.mark.parametrize("outline", [Rectangle((0.9, 0.9)), Ellipse((0.9, 0.9))], ids=str)
@pytest.mark.parametrize(
    "places",
    [[[0.0, 0, -5]], [[x, y, -5] for x in (-0.1, 0, 0.1) for y in (-0.2, 0.2)]],
    ids=["one", "six"],
)
def test_mirror_images_are_left_out(scene, places, outline):
    """Heights that are mirror images of themselves: a quarter of the rays give the whole image."""
    places = np.array(places)
    light = Origins(places, False, np.full(len(places), 1 / (2 * math.pi * len(places))))
    faces = biconvex(outline, datum_of(scene))
    path = path_of(scene, Light(light, Corners(24, 20)), faces, outline, -2.0)
    heights = lens(scene, 2, 0.01)
    heights = (heights + heights.flip(0)) / 2
    heights = (heights + heights.flip(1)) / 2
    cotangent = torch.tensor(np.random.default_rng(0).normal(size=scene.receiver.pixels[::-1]))
    cotangent = cotangent + cotangent.flip(0)
    cotangent = cotangent + cotangent.flip(1)
    found = []
    for promised in (False, True):
        tracer, leaf = CompiledTrain(path, (promised, promised)), heights.clone().requires_grad_()
        assert tracer.mirrored == (promised, promised)
        light_there = tracer.image({"lens.back": leaf}, GaussianFilter(size=(3, 3)))
        (gradient,) = torch.autograd.grad((light_there.flux * cotangent).sum(), leaf)
        found.append((light_there.flux.detach(), light_there.account, gradient))
    (whole, account, gradient), (some, some_account, some_gradient) = found
    assert torch.allclose(some, whole, rtol=0, atol=1e-13)
    assert isinstance(account, Account)
    assert some_account.to_data() == pytest.approx(account.to_data(), abs=1e-12)
    # Light on edges of pixels has another slope on each side.
    gradient = (gradient + gradient.flip(0)) / 2
    gradient = (gradient + gradient.flip(1)) / 2
    assert (some_gradient - gradient).norm() < 1e-10 * gradient.norm()


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


FLAT = {"screen.half_width": [10, 10], "screen.pixels": [20, 20], "lens.reflection": "fresnel"}


@pytest.mark.parametrize(("dtype", "accuracy"), [(torch.float64, 1e-9), (torch.float32, 1e-4)])
def test_light_of_the_centre_of_a_concentric_dome_passes_straight(make_scene, dtype, accuracy):
    """Each face takes ((n − 1) / (n + 1))² at any angle, and nothing else changes."""
    scene, cells, thickness = make_scene(FLAT), (20, 16), 0.5
    inner, outer, source = 1.0, 1.5, -3.0
    outline = Rectangle((0.2, 0.25))
    wide = Rectangle((0.4, 0.4))
    datum = datum_of(scene)
    dome = element(
        Conic("inner", source + inner - datum, -1 / inner, 0.0, wide),
        Conic("outer", source + outer - datum, -1 / outer, 0.0, wide),
        absorption=0.3,
    )
    light = Origins(np.array([[0.0, 0, source]]), False, np.array([1 / (2 * math.pi)]))
    emitter = Light(light, Corners(*cells))
    path = path_of(scene, emitter, dome, outline, source + inner, dtype)
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
    there = path_of(scene, emitter, [], outline, source + inner).emitter.origins.light(
        a * inner, b * inner, source + inner, np.array(0)
    )
    cell = 4 * np.prod(outline.half_width) / np.prod(cells)
    middle = there.density[1:-1, 1:-1] * cell * passed
    behind = nodes.hits[2].numpy()[1:-1, 1:-1]
    glass = Refraction(TransmittanceLaw.of(scene.optic)[0], "").law
    cos = 1 / np.sqrt(1 + slope**2)[1:-1, 1:-1]
    inside = np.sqrt(1 - (1 - cos**2) / scene.optic.index**2)
    assert behind == pytest.approx(middle * glass.at(cos, inside) ** 2, rel=10 * accuracy)


@pytest.mark.parametrize("tilt", [0.0, 0.15])
def test_a_plate_before_the_lens_shifts_light_towards_the_axis(make_scene, tilt):
    """By t (tan θ − tan θ'); the same place behind a lens that is a plate itself."""
    scene, cells, thick = make_scene(FLAT), (16, 12), 0.7
    outline, datum = Rectangle((0.15, 0.1)), datum_of(scene)
    wide = Rectangle((0.9, 0.9))
    place = np.array([[tilt, 0.0, -3.0]])
    light = Origins(place, False, np.array([1 / (2 * math.pi)]))
    before = plate(-2.0 - datum, thick, wide)
    path = path_of(scene, Light(light, Corners(*cells)), before, outline, -2.0)
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
    outline, datum = Ellipse((0.6, 0.6)), datum_of(scene)
    collimator = element(
        Conic("front", front - datum, 1 / radius, -(INDEX**2), Rectangle((1, 1))),
        Plane("back", -0.5 - datum, Rectangle((1, 1))),
    )
    light = Origins(np.array([[0.0, 0, focus]]), False, np.array([1 / (2 * math.pi)]))
    path = path_of(scene, Light(light, Corners(20, 20)), collimator, outline, front)
    heights = {"lens.back": torch.full((9, 8), 0.3, dtype=torch.float64)}
    for tracer in (CompiledTrain(path), Reference(path)):
        nodes = tracer.nodes(heights)
        columns, rows, flux = nodes.hits
        lit = flux > 0
        assert lit.double().mean() > 0.7
        assert (columns[lit] - 10).abs().max() < 1e-9
        assert (rows[lit] - 10).abs().max() < 1e-9
        assert sum(nodes.account.to_data().values()) == pytest.approx(2, abs=1e-12)
