"""The image of boxes of light: exact cases, and lenses near an emitter."""

import numpy as np
import pytest
import torch

from tests.optics.cells_of_light import nodes_of, splits
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.images.beams import beam_image, box_image
from workbench.optics.samples import Corners

BOTH = pytest.mark.parametrize("fused", [True, False], ids=["kernel", "reference"])


def image_of(nodes, pixels, fused=True):
    return box_image(nodes, pixels, splits(nodes.shape[1:]), fused)


@BOTH
@pytest.mark.parametrize("pixels", [64, 256])
def test_a_box_has_the_middle_and_the_spread_of_its_cell(fused, pixels):
    a, b, middle = np.array([0.21, 0.08]), np.array([-0.05, 0.13]), np.array([0.48, 0.53])
    corners = [[middle + s * a / 2 + t * b / 2 for s in (-1, 1)] for t in (-1, 1)]
    column, row = np.moveaxis(np.array(corners), -1, 0) * pixels
    image = image_of(nodes_of(column, row), (pixels, pixels), fused)[0].numpy()
    place = (np.arange(pixels) + 0.5) / pixels
    for axis, light in enumerate((image.sum(0), image.sum(1))):
        mean = light @ place  # as if all light of a pixel were in its middle
        assert mean == pytest.approx(middle[axis], abs=1 / pixels**2)
        spread = (a[axis] ** 2 + b[axis] ** 2) / 12
        assert light @ (place - mean) ** 2 == pytest.approx(spread, abs=1 / pixels**2)


def test_a_bent_map_is_that_of_beams_but_for_few_parts():
    t = np.linspace(0, 1, 129)
    u, v = np.meshgrid(t, t)
    column = 32 * (u + 0.1 * np.sin(2 * np.pi * u) * np.cos(2 * np.pi * v) / 2)
    row = 32 * (v + 0.1 * np.cos(2 * np.pi * u) * np.sin(2 * np.pi * v) / 2)
    nodes = nodes_of(column, row)
    boxes, beams = (
        draw(nodes, (32, 32), splits((129, 129)))[0] for draw in (box_image, beam_image)
    )
    assert (boxes - beams).norm() < 3e-3 * beams.norm()


LED = {"kind": "area", "center": [0, 0, -1.5], "half_width": [0.3, 0.2], "emission": "lambertian"}


@pytest.fixture
def lit(make_scene):
    """A lens near an emitter, and heights that bend it."""
    changes = {"version": 2, "lens.control_points": [7, 6], "source": LED}
    screen = {"screen.z": 8.0, "screen.half_width": [8.0, 8.0], "screen.pixels": [16, 14]}
    scene = make_scene({**changes, **screen})
    along = (np.linspace(-1, 1, count) ** 2 for count in ControlNet.of(scene.optic).shape)
    return scene, torch.as_tensor(scene.optic.base.height - 0.1 * np.add.outer(*along))


def test_the_gradient_of_heights_is_that_of_the_image(lit, rng):
    scene, curved = lit
    plan = BeamPlan(scene, Corners(20, 24, 8), dtype=torch.float64)
    cotangent = torch.tensor(rng.standard_normal((14, 16)))
    heights = curved.clone().requires_grad_()
    image = plan.trace({"lens.back": heights}).flux
    (gradient,) = torch.autograd.grad((image * cotangent).sum(), [heights])
    way, step = torch.tensor(rng.standard_normal(curved.shape)), 1e-6
    ahead, back = (plan.trace({"lens.back": curved + s * way}).flux for s in (step, -step))
    rise = ((ahead - back) * cotangent).sum().item() / (2 * step)
    assert (gradient * way).sum().item() == pytest.approx(rise, rel=1e-5)


@pytest.mark.parametrize("width", [0.02, 0.3, 4.0])
def test_narrow_boxes_far_out_in_an_image_are_exact_in_float32(width, rng):
    column, row = np.meshgrid(4000 + width * np.arange(9), 3 + width * np.arange(7))
    bent = [each + 0.2 * width * rng.standard_normal(each.shape) for each in (column, row)]
    nodes = nodes_of(*bent, rng.random(column.shape)).float()
    cotangent = torch.tensor(rng.standard_normal((40, 4096)))
    found = []
    for hits in (nodes.requires_grad_(), nodes.detach().double().requires_grad_()):
        image, landed = box_image(hits, (4096, 40), splits(column.shape))
        (gradient,) = torch.autograd.grad((image * cotangent).sum(), [hits])
        found.append((image.detach().double(), gradient.double(), landed))
    (image, gradient, landed), (exact, truth, lands) = found
    assert landed == pytest.approx(lands, rel=1e-6)
    # Shifted hits are rounded to 2⁻¹² pixels out there, which is 1.2 % of the narrowest box.
    assert (image - exact).abs().sum() < 1e-3 * lands
    assert image.sum().item() == pytest.approx(exact.sum().item(), rel=1e-5)
    assert (gradient - truth).norm() < 1e-2 * truth.norm()
