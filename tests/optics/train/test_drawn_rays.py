"""Drawn rays through the compiled train, against the torch reference."""

import numpy as np
import pytest
import torch

from tests.optics.kernels.twins import account
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.path import Path
from workbench.optics.plan import Plan
from workbench.optics.reference import Reference
from workbench.optics.train.compiled import CompiledTrain
from workbench.optics.train.entries import in_numbers
from workbench.scene import Scene

POINT = {"kind": "point", "position": [0, 0, -5.0], "rays": 6000}
ASIDE = POINT | {"position": [0.6, -0.4, -2.0], "emission": "lambertian"}
GRID = {"kind": "grid", "center": [0, 0.1, -5], "half_width": [1, 1], "points": [5, 4], "rays": 300}
# A filter without kinks: hits that differ by rounding have gradients that do.
SMOOTH = {"kind": "gaussian", "size": [5, 5], "alpha": 4.0}
DTYPES = [torch.float64, torch.float32]
VALUE = {torch.float64: 1e-11, torch.float32: 5e-5}
GRADIENT = {torch.float64: 1e-10, torch.float32: 1e-3}


def twins(scene, dtype=torch.float64):
    path = Path.of(scene, ControlNet.of(scene.optic), dtype)
    return Reference(path), CompiledTrain(path)


def differences(scene, tracers, heights, rng):
    """How far image, gradient (both relative) and lost light of the twins are apart."""
    lights, gradients = [], []
    cotangent = torch.as_tensor(rng.normal(size=scene.receiver.pixels[::-1]))
    for tracer in tracers:
        variable = heights.clone().requires_grad_()
        light = tracer.image({"lens.back": variable}, scene.filter)
        (gradient,) = torch.autograd.grad((light.flux * cotangent).sum(), variable)
        assert torch.isfinite(light.flux).all()
        assert torch.isfinite(gradient).all()
        lights.append(light)
        gradients.append(gradient)
    image, gradient = (
        ((other - one).norm() / one.norm().clamp_min(1e-9)).item()
        for one, other in ([light.flux.detach() for light in lights], gradients)
    )
    one, other = map(account, lights)
    assert one.keys() == other.keys()
    return image, gradient, max(abs(one[name] - other[name]) for name in one)


def same(scene, tracers, heights, rng, dtype):
    image, gradient, lost = differences(scene, tracers, heights, rng)
    assert image < VALUE[dtype]
    assert gradient < GRADIENT[dtype]
    assert lost < VALUE[dtype] / 10


def face(scene, kind, rng):
    """Control heights of some face."""
    net = ControlNet.of(scene.optic)
    x, y = (torch.as_tensor(c / r) for c, r in zip(net.positions, net.half_width, strict=True))
    x, y, small = x[:, None], y[None, :], min(net.half_width)
    if kind == "flat":
        return torch.full(net.shape, 0.5 * small, dtype=torch.float64)
    if kind == "spherical":
        return small * (0.8 - 0.2 * (x**2 + y**2))
    if kind == "wavy":
        return small * (0.5 + 0.05 * torch.sin(7 * x + 3 * y) * torch.cos(5 * y))
    # Rays meet a face this steep several times, and many are totally reflected there.
    return small * (0.5 + 0.3 * torch.as_tensor(rng.uniform(-1, 1, size=net.shape)))


# In float32 a ray that all but grazes a steep face may come to meet it elsewhere.
@pytest.mark.parametrize(
    ("kind", "dtype"),
    [(kind, dtype) for kind in ("flat", "spherical", "wavy") for dtype in DTYPES]
    + [("steep", torch.float64)],
)
@pytest.mark.parametrize("source", [POINT, ASIDE, GRID], ids=["point", "aside", "grid"])
def test_image_account_and_gradient_are_the_references(make_scene, rng, source, kind, dtype):
    scene = make_scene({"source": source, "filter": SMOOTH})
    same(scene, twins(scene, dtype), face(scene, kind, rng), rng, dtype)


@pytest.mark.parametrize("dtype", DTYPES)
def test_warm_starts_while_rays_move_from_patch_to_patch(make_scene, rng, dtype):
    scene = make_scene({"source": ASIDE, "filter": SMOOTH, "lens.control_points": [40, 32]})
    tracers = twins(scene, dtype)
    start, end = face(scene, "wavy", rng), face(scene, "spherical", rng)
    shares = [0, 1, 0, *np.linspace(0, 1, 10), -0.5]
    for share in shares:
        same(scene, tracers, torch.lerp(start, end, float(share)), rng, dtype)


def test_rays_are_sorted_again_and_none_is_lost_or_doubled(make_scene):
    scene = make_scene({"source": ASIDE, "lens.control_points": [40, 32]})
    _, fused = twins(scene)
    rays = fused._path.begin()
    orders = []
    for share in np.linspace(0, 1, 12):
        height = (0.3 + 0.5 * share) * torch.ones(40, 32, dtype=torch.float64)
        fused.image({"lens.back": height}, scene.filter)
        orders.append(fused._entry._values)
    assert len({id(order) for order in orders}) > 1
    expected = in_numbers(rays, scene.optic.base.height - fused._path.datum)
    for order in (orders[0], orders[-1]):
        assert np.array_equal(order[:, np.lexsort(order)], expected[:, np.lexsort(expected)])


LENS = {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [12, 10]}
MIRROR = {"half_width": [1, 1], "control_points": [12, 10], "reflectance": 0.9}
FACING = {"shape": "freeform", "control_points": [9, 8]}
SCREEN = {"z": 5, "half_width": [2, 2], "pixels": [16, 12]}
BACK = SCREEN | {"z": -4, "tilt": [15, -35], "center": [1.5, -0.5]}
FAR = {"half_angle": [40, 30], "pixels": [16, 12]}
SUN = {"kind": "collimated", "direction": [5, -3], "angular_diameter": 1, "rays": [40, 40]}
SUN |= {"profile": {"kind": "gaussian", "radius": 0.6}}
LED = {"kind": "area", "center": [0.1, 0, -2], "half_width": [0.2, 0.1], "rays": 4000}
TRAINS = {
    "tilted receiver": {"lens": LENS, "screen": SCREEN | {"tilt": [20, -10], "center": [0.3, 0]}},
    "far field": {"lens": LENS, "far_field": FAR},
    "elliptic lens": {"lens": LENS | {"outline": "ellipse"}, "screen": SCREEN},
    "mirror": {"mirror": MIRROR, "screen": BACK},
    "elliptic mirror": {"mirror": MIRROR | {"outline": "ellipse"}, "far_field": FAR},
    "freeform entrance": {"lens": LENS | {"entrance": FACING, "absorption": 0.4}, "screen": SCREEN},
}


@pytest.mark.parametrize("source", [ASIDE, SUN, LED], ids=["point", "sun", "LED"])
@pytest.mark.parametrize("train", TRAINS.values(), ids=TRAINS)
def test_drawn_rays_through_any_train(train, source, rng):
    some = {"format": "freeform-scene", "version": 2, "filter": SMOOTH, "source": source}
    scene = Scene.from_data(some | train | {"target": {"builtin": "tophat"}})
    net = ControlNet.of(scene.optic)
    path = Path.of(scene, net, torch.float64)
    levels = {"lens.back": 0.5, "lens.front": 0.0, "mirror.face": 0.0}
    heights = {
        name: levels[name] + 0.02 * torch.as_tensor(rng.normal(size=each.shape))
        for name, each in freeform_nets(scene.optic).items()
    }
    assert CompiledTrain.matches(path)
    tracers = Reference(path), CompiledTrain(path)
    cotangent = torch.as_tensor(rng.normal(size=scene.receiver.pixels[::-1]))
    lights, gradients = [], []
    for tracer in tracers:
        leaves = [each.clone().requires_grad_() for each in heights.values()]
        light = tracer.image(dict(zip(heights, leaves, strict=True)), scene.filter)
        gradients.append(torch.autograd.grad((light.flux * cotangent).sum(), leaves))
        lights.append(light)
    one, other = (light.flux.detach() for light in lights)
    assert one.sum() > 0.01
    assert (other - one).norm() < 1e-9 * one.norm()
    assert account(lights[1]) == pytest.approx(account(lights[0]), abs=1e-12)
    assert sum(account(lights[1]).values()) == pytest.approx(2, abs=1e-12)  # and once as emitted
    for mine, theirs in zip(gradients[1], gradients[0], strict=True):
        assert (mine - theirs).norm() < 1e-8 * theirs.norm()


def test_fresh_rays(make_scene, rng):
    scene = make_scene({"source": POINT | {"fresh": True}, "filter": SMOOTH})
    fused, plain = Plan(scene, dtype=torch.float64), Plan(scene, dtype=torch.float64, fused=False)
    heights, images = face(scene, "wavy", rng), []
    for _ in range(3):
        images.append(fused.trace({"lens.back": heights}).flux)
        assert (images[-1] - plain.trace({"lens.back": heights}).flux).norm() < 1e-11 * images[
            -1
        ].norm()
        fused.next_iteration()
        plain.next_iteration()
    assert not torch.allclose(images[0], images[1])


def test_one_thread_gives_bit_for_bit_what_two_give(make_scene, rng):
    scene = make_scene({"source": POINT | {"rays": 40_000}})
    heights, threads = face(scene, "wavy", rng), torch.get_num_threads()
    gradients, images = [], []
    try:
        for number in (1, 2, 2):
            torch.set_num_threads(number)
            _, fused = twins(scene)
            variable = heights.clone().requires_grad_()
            flux = fused.image({"lens.back": variable}, scene.filter).flux
            gradients.append(torch.autograd.grad(flux.square().sum(), variable)[0])
            images.append(flux.detach())
    finally:
        torch.set_num_threads(threads)
    for many in (1, 2):
        assert torch.equal(images[0], images[many])
        assert torch.equal(gradients[0], gradients[many])


def test_the_gradient_belongs_to_the_lens_of_its_own_trace(make_scene, rng):
    """Another trace, of another lens, between a trace and its way back changes nothing."""
    scene = make_scene({"source": POINT, "filter": SMOOTH})
    _, fused = twins(scene)
    first, second = face(scene, "wavy", rng), face(scene, "spherical", rng)
    gradients = []
    for between in (False, True):
        variable = first.clone().requires_grad_()
        light = fused.image({"lens.back": variable}, scene.filter)
        if between:
            for _ in range(9):
                fused.image({"lens.back": second}, scene.filter)
        gradients.append(torch.autograd.grad(light.flux.square().sum(), variable)[0])
    assert (gradients[0] - gradients[1]).norm() < 1e-12 * gradients[0].norm()


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_heights_that_are_no_numbers_do_no_harm(make_scene, value):
    """Heights that are no numbers give a dark or senseless image, but neither crash nor hang."""
    scene = make_scene({"source": POINT})
    _, fused = twins(scene)
    good = torch.full((12, 10), 0.5, dtype=torch.float64)
    bad = good.clone()
    bad[3, 4] = value
    before = fused.image({"lens.back": good}, scene.filter).flux
    variable = bad.requires_grad_()
    fused.image({"lens.back": variable}, scene.filter).flux.sum().backward()
    after = fused.image({"lens.back": good}, scene.filter).flux
    assert (after - before).norm() < 1e-12 * before.norm()


def test_the_plan_says_which_light_of_points_it_fuses(make_scene):
    mesh = make_scene({"source": POINT | {"intersection": {"method": "mesh"}}})
    assert "fused kernels" in Plan(make_scene({"source": POINT})).notes[0]
    assert "reference" in Plan(mesh).notes[0]
    assert "triangle mesh" in " ".join(Plan(mesh).notes)
