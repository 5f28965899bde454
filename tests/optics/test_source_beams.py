"""Beams between the origins of a source, through each sample of a lens."""

import numpy as np
import pytest
import torch

from workbench.geometry.surface import freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners

# A source that is seen under a wide angle, and a far screen: its image is wide.
LED = {"kind": "area", "center": [0, 0, -1.5], "half_width": [0.3, 0.2], "emission": "lambertian"}
SCREEN = {"screen.z": 8.0, "screen.half_width": [8.0, 8.0], "screen.pixels": [16, 14]}
TWO_FACES = {"lens.entrance": {"shape": "freeform", "height_range": [-0.3, 0.3]}}
LENSES = {
    "one face": {},
    "one round face": {"lens.outline": "ellipse"},
    "two round faces": {**TWO_FACES, "lens.outline": "ellipse"},
}
OUTLINES = pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
EACH = pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)


def lit(make_scene, lens, outline="rectangle"):
    """A lens near an emitter, and heights that bend it."""
    source = LED | {"outline": outline}
    net = {"lens.control_points": [7, 6], "version": 2}
    scene = make_scene({**net, **SCREEN, **lens, "source": source})
    levels = {"lens.front": 0.0, "lens.back": scene.optic.base.height}
    heights = {}
    for face, net in freeform_nets(scene.optic).items():
        along = (np.linspace(-1, 1, count) ** 2 for count in net.shape)
        curved = levels[face] - 0.1 * np.add.outer(*along) * (1 if face == "lens.back" else -1)
        heights[face] = torch.as_tensor(curved)
    return scene, heights


@OUTLINES
@EACH
def test_the_image_is_that_of_many_origins(make_scene, lens, outline):
    scene, heights = lit(make_scene, lens, outline)
    few = BeamPlan(scene, Corners.and_of_source(56, 56, (6, 7))).trace(heights)
    many = BeamPlan(scene, Corners(40, 40, 256)).trace(heights)
    assert (few.flux - many.flux).norm().item() < 0.012 * many.flux.norm().item()
    assert few.account.on_screen == pytest.approx(many.account.on_screen, abs=2e-3)
    assert few.account.on_screen + sum(few.account.lost.values()) == pytest.approx(1, abs=1e-8)


@EACH
def test_kernels_do_what_the_reference_does(make_scene, rng, lens):
    scene, heights = lit(make_scene, lens)
    cotangent = torch.as_tensor(rng.standard_normal((14 + 2, 16 + 4)))
    found = []
    for fused in (True, False):
        given = {face: each.clone().requires_grad_() for face, each in heights.items()}
        cells = Corners.and_of_source(10, 12, (4, 3))
        plan = BeamPlan(scene, cells, dtype=torch.float64, fused=fused)
        image, account = plan.trace(given, (2, 1))
        gradients = torch.autograd.grad((image * cotangent).sum(), list(given.values()))
        found.append((image.detach(), torch.cat([each.flatten() for each in gradients]), account))
    (image, gradient, account), (twin, twins, other) = found
    assert image.sum() > 0.01
    torch.testing.assert_close(image, twin, rtol=0, atol=1e-9)
    assert (gradient - twins).norm() < 1e-6 * twins.norm()
    for name, flux in account.to_data().items():
        assert flux == pytest.approx(other.to_data()[name], abs=1e-8), name


@EACH
@pytest.mark.parametrize("mirrored", [(True, False), (False, True), (True, True)])
def test_a_part_of_the_source_makes_all_of_a_mirrored_image(make_scene, lens, mirrored):
    scene, heights = lit(make_scene, lens)
    cells = Corners.and_of_source(32, 32, (4, 6))
    part, whole = (
        BeamPlan(scene, cells, dtype=torch.float64, mirrored=promise).trace(heights).flux
        for promise in (mirrored, (False, False))
    )
    # The diagonals of cells turn other ways.
    assert (part - whole).norm().item() < 4e-3 * whole.norm().item()
    assert part.sum().item() == pytest.approx(whole.sum().item(), rel=3e-3)
