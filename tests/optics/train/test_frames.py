"""Trains of tilted and shifted elements: the compiled loops against the walk in torch."""

import numpy as np
import pytest
import torch

from tests.optics.train.test_behind_glass import Light, from_far
from tests.optics.train.test_elements import landed
from tests.optics.train.tilted import (
    ASIDE,
    LIGHTS,
    asphere,
    folded,
    in_frame,
    mirror,
    own_faces,
    own_second,
    second,
    train,
)
from workbench.geometry.outlines import Ellipse, Rectangle
from workbench.geometry.surface import ControlNet
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.surfaces import BSplineSurface, Plane
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import Scene


def freeform_mirror(dtype):
    """A freeform mirror that light meets from behind, and a lens in the light that comes back."""
    net = ControlNet((6, 5), (2, 3), (1.0, 1.0))
    surface = BSplineSurface("second", net, 0.0, dtype, outline=Ellipse((0.9, 0.8)), level=0.7)
    (step,) = mirror(surface, (0.05, 0.0, 2.5), (160.0, 10.0, 5.0))
    lens = in_frame(asphere(), (0.0, -0.85, 1.1), (140.0, 0.0, 0.0))
    return [step.facing(step.frame.position), *lens]


TRAINS = {
    "tilted and shifted": lambda dtype: in_frame(
        second(dtype), (0.1, -0.2, 1.2), (12.0, -8.0, 30.0)
    ),
    "fold": folded,
    "asphere": lambda dtype: in_frame(asphere(), (0.0, 0.1, 0.9), (0.0, 5.0, 0.0)),
    "asphere on the axis": lambda dtype: in_frame(asphere(), (0.0, 0.0, 0.9)),
    "outlines": lambda dtype: [
        *in_frame(asphere(Ellipse((0.9, 0.6))), (0.1, 0.0, 0.9)),
        *in_frame(second(dtype, Rectangle((0.5, 0.8))), (0.0, 0.1, 1.6), (0.0, 0.0, 20.0)),
    ],
    "mirror from behind": freeform_mirror,
}
# Where their light goes.
SCREENS = {
    "fold": ((0, 6, 1.5), ASIDE),
    "mirror from behind": ((0, -3.2, -1.7), (140.0, 0.0, 0.0)),
}


def cotangent_of(path):
    corners, count = path.emitter.samples, len(path.emitter.origins.flux)
    shape = 4, count * (corners.y + 1), corners.x + 1
    return torch.tensor(np.random.default_rng(0).normal(size=shape))


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
@pytest.mark.parametrize("behind", TRAINS)
def test_twins_agree(make_scene, behind, light, outline):
    scene = make_scene(
        {"lens.outline": outline, "lens.reflection": "fresnel", "lens.absorption": 0.2}
        | {"screen.half_width": [3, 3], "version": 2}
    )
    elements = TRAINS[behind](torch.float64)
    path, heights = train(scene, light, (30, 24), elements, SCREENS.get(behind)), own_faces(scene)
    agree(path, heights)


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
@pytest.mark.parametrize("onwards", [1, -1])
def test_twins_agree_on_directions_behind_tilted_elements(make_scene, light, onwards):
    scene = make_scene(
        {"lens.absorption": 0.2, "version": 2, "screen": None}
        | {"far_field": {"half_angle": [60, 50], "center": [5, 10], "pixels": [40, 30]}}
    )
    # One mirror sends light to −z and aside; the second one, if there is one, to +z again.
    flat = Plane("mirror", 0.0, Rectangle((1.5, 1.5)))
    behind = mirror(flat, (0, 0, 1.6), (10.0, -5.0, 0.0))
    if onwards > 0:
        behind += mirror(flat, (0.2, 0.4, 0.2), (190.0, 10.0, 0.0))
    path = train(scene, light, (20, 16), [*behind])
    path.receiver._onwards = onwards
    agree(path, own_faces(scene) | {"second": torch.zeros(1)})


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
def test_the_first_face_may_be_a_mirror_before_tilted_lenses(light):
    scene = Scene.from_data(
        {
            "format": "freeform-scene",
            "version": 2,
            "mirror": {"half_width": [1.0, 0.8], "control_points": [9, 7], "reflectance": 0.9},
            "source": {"kind": "collimated"},
            "screen": {"z": -6.0, "half_width": [3.0, 3.0], "pixels": [32, 32]},
            "target": {"builtin": "tophat"},
        }
    )
    optic = scene.optic
    plain = Path.of(scene, ControlNet.of(optic), torch.float64)
    lens = in_frame(second(torch.float64), (0.1, 0.2, -1.5), (175.0, 5.0, 20.0))
    emitter = Light(light, Corners(20, 16))
    path = Path(
        emitter, [*plain.steps, *lens], plain.receiver, plain.datum, plain.outline, 0, torch.float64
    )
    noise = np.random.default_rng(3).normal(size=optic.net_shape)
    heights = {optic.designed_face: torch.tensor(optic.base.height + 0.01 * noise)}
    agree(path, heights | {"second": own_second(3)})


def agree(path, heights):
    """Nodes, accounts and gradients of the compiled loops are those of the walk in torch."""
    assert CompiledTrain.matches(path)
    cotangent = cotangent_of(path)
    (nodes, account, gradients), (fused, fused_account, fused_gradients) = (
        landed(tracer, heights, cotangent) for tracer in (Reference(path), CompiledTrain(path))
    )
    assert ((nodes[2] > 0) == (fused[2] > 0)).all()
    assert (nodes[2] > 0).double().mean() > 0.15
    assert (fused - nodes).abs().max() < 1e-10 * (1 + nodes.abs().max())
    assert fused_account == pytest.approx(account, abs=1e-11)
    for found in (account, fused_account):
        assert sum(found.values()) == pytest.approx(2, abs=1e-12)  # and once as emitted
    for one, other in zip(fused_gradients, gradients, strict=True):
        assert (one - other).norm() <= 1e-10 * other.norm()


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
@pytest.mark.parametrize("behind", TRAINS)
def test_gradients_are_those_of_central_differences(scene, behind, light):
    path = train(scene, light, (20, 16), TRAINS[behind](torch.float64), SCREENS.get(behind))
    tracer, heights, cotangent = CompiledTrain(path), own_faces(scene, 3), cotangent_of(path)
    _, _, gradients = landed(tracer, heights, cotangent)
    generator, step = np.random.default_rng(0), 1e-6
    for (name, face), gradient in zip(heights.items(), gradients, strict=True):
        way = torch.tensor(generator.normal(size=face.shape))
        ahead, behind_it = (
            landed(tracer, heights | {name: face + sign * step * way}, cotangent)[0] * cotangent
            for sign in (1, -1)
        )
        same = (ahead[2] != 0) == (behind_it[2] != 0)
        assert same.all()
        expected = ((ahead - behind_it).sum() / (2 * step)).item()
        assert (gradient * way).sum().item() == pytest.approx(expected, rel=5e-6, abs=1e-9)


@pytest.mark.parametrize("light", LIGHTS.values(), ids=LIGHTS)
@pytest.mark.parametrize("behind", TRAINS)
def test_single_precision_is_enough(scene, behind, light):
    """To 3e-5 of a pixel; accounts to 1e-6 of all light, gradients to 5e-6."""
    found, heights = [], own_faces(scene)
    for dtype in (torch.float64, torch.float32):
        path = train(scene, light, (30, 24), TRAINS[behind](dtype), SCREENS.get(behind), dtype)
        found.append(landed(CompiledTrain(path), heights, cotangent_of(path)))
    (nodes, account, gradients), (single, rounded, single_gradients) = found
    same = (nodes[2] > 0) == (single[2] > 0)
    assert same.double().mean() > 0.999
    assert ((single - nodes).abs() * same).max() < 3e-5
    assert rounded == pytest.approx(account, abs=1e-6)
    if same.all():
        for one, other in zip(single_gradients, gradients, strict=True):
            assert (one - other).norm() <= 5e-6 * other.norm()


@pytest.mark.parametrize(
    ("position", "tilt", "kept"),
    [
        ((0, 0, 1.0), (0.0, 0.0, 0.0), (True, True)),
        ((0, 0.1, 1.0), (5.0, 0.0, 0.0), (True, False)),
        ((0.1, 0, 1.0), (0.0, 0.0, 0.0), (False, True)),
    ],
)
def test_only_symmetric_trains_are_traced_by_halves(scene, position, tilt, kept):
    behind = in_frame(asphere(), position, tilt)
    path = train(scene, from_far(1, 0.0), (20, 16), behind)
    assert CompiledTrain(path, (True, True)).mirrored == kept
