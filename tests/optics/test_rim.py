"""Light of cells that the rim of the last face cuts."""

import numpy as np
import pytest
import torch

from workbench.optics.beam_plan import BeamPlan
from workbench.optics.images.beams import beam_image, box_image, drawn
from workbench.optics.images.rim import rim_light
from workbench.optics.kernels.polygons import compiled_drawn
from workbench.optics.samples import Corners, places, splits_side_by_side

PIXELS = (9, 8)
CELLS = (6, 5)


def lit(shear=0.0, grids=1):
    """Nodes of even light over [1, 7] × [1, 6] pixels before shear, one cell for each pixel."""
    along_u, along_v = places(Corners(*CELLS), 0), places(Corners(*CELLS), 1)
    u, v = torch.meshgrid(
        torch.arange(CELLS[0] + 1.0, dtype=torch.float64),
        torch.arange(CELLS[1] + 1.0, dtype=torch.float64),
        indexing="xy",
    )
    flux = torch.ones_like(u)
    for side in (0, -1):
        flux[side] /= 2
        flux[:, side] /= 2
    nodes = torch.stack([1 + u + shear * v, 1 + v, flux])
    return torch.cat([nodes] * grids, 1), splits_side_by_side(along_u, along_v, grids)


def cut(nodes, rim_distance):
    """The same with rays beside the rim lost."""
    beside = rim_distance < 0
    nodes = torch.where(beside, torch.tensor([torch.inf, torch.inf, 0.0])[:, None, None], nodes)
    return nodes, torch.where(beside, -1.0, rim_distance)


def whole(nodes, rim_distance, splits, draw=beam_image):
    """The image of all cells, cut or not, and all flux that lands."""
    image, landed = draw(nodes, PIXELS, splits)
    rim = rim_light(nodes, rim_distance, PIXELS, splits, triangles=draw is beam_image)
    return image + rim.flux, landed + rim.landed


EITHER = pytest.mark.parametrize("draw", [beam_image, box_image], ids=["beams", "boxes"])


@EITHER
@pytest.mark.parametrize("grids", [1, 2])
@pytest.mark.parametrize("at", [3.0, 3.25, 3.999])
def test_light_ends_at_a_straight_rim(at, grids, draw):
    nodes, splits = lit(grids=grids)
    image, landed = whole(*cut(nodes, at - (nodes[0] - 1)), splits, draw)
    wanted = torch.zeros(PIXELS[::-1], dtype=torch.float64)
    wanted[1:6, 1:7] = grids * (at - torch.arange(6, dtype=torch.float64)).clamp(0, 1)
    assert landed == pytest.approx(5 * at * grids)
    assert (image - wanted).abs().max() < 1e-12


@EITHER
@pytest.mark.parametrize("width", [2.2, 2.6, 3.5])
def test_as_much_light_comes_through_a_slit_as_fits_in(width, draw):
    # Distances grow towards the middle: from one side alone they would go on beyond the other.
    landed = []
    for right in np.linspace(width + 0.5, 5.5, 40):
        nodes, splits = lit()
        u = nodes[0] - 1
        within = torch.minimum(u - (right - width), right - u)
        landed.append(whole(*cut(nodes, within), splits, draw)[1])
    assert np.mean(landed) == pytest.approx(5 * width, rel=0.05)


def test_gradients_are_those_of_central_differences(rng):
    nodes, splits = lit(shear=0.3)
    rim_distance = 4.4 - (nodes[0] - 1) - 0.4 * nodes[1]
    beside = rim_distance < 0
    weights = torch.tensor(rng.normal(size=PIXELS[::-1]))
    offset = 0.05 * torch.tensor(rng.normal(size=(4, *rim_distance.shape)))
    way = torch.tensor(rng.normal(size=(4, *rim_distance.shape))) * ~beside

    def value(moved):
        given, within = cut(nodes + moved[:3], torch.where(beside, -1.0, rim_distance + moved[3]))
        return (rim_light(given, within, PIXELS, splits).flux * weights).sum()

    start = torch.where(beside, 0.0, offset.abs())
    leaf = start.clone().requires_grad_()
    (gradient,) = torch.autograd.grad(value(leaf), [leaf])
    step = 1e-6
    slope = (value(start + step * way) - value(start - step * way)) / (2 * step)
    assert gradient.isfinite().all()
    assert (gradient * way).sum().item() == pytest.approx(slope.item(), rel=1e-7)


def spreading(make_scene, outline):
    """A plate of two faces, both of which spread light: some leaves through the side."""
    nets = {"lens.control_points": [12, 12], "lens.height_range": None, "lens.outline": outline}
    entrance = {"shape": "freeform", "height_range": [-0.3, 0.3]}
    scene = make_scene({**nets, "lens.entrance": entrance, "screen.half_width": [3, 3]})
    (n_u, n_v) = scene.optic.net_shape
    u, v = np.linspace(-1, 1, n_u)[:, None], np.linspace(-1, 1, n_v)
    dome = -0.1 * (u**2 + v**2)  # a hollow, which spreads light
    return scene, {
        "lens.front": torch.tensor(dome),
        "lens.back": torch.tensor(scene.optic.base.height + 0 * dome),
    }


def test_all_light_is_accounted_for(make_scene):
    scene, heights = spreading(make_scene, "rectangle")
    account = BeamPlan(scene, (30, 30)).trace(heights).account
    assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-6)
    assert account.lost["total_reflection"] == pytest.approx(0, abs=1e-6)


def test_compiled_polygons_are_those_of_the_reference(rng):
    # Triangles with six corners, turned over or not, some of them beside the image.
    corners = torch.tensor(rng.uniform(-3, 12, (2, 40, 3)))
    x, y = corners - corners[:, :, :1]
    turned = (x[:, 1] * y[:, 2] - x[:, 2] * y[:, 1]).sign()
    density, weights = (torch.tensor(rng.random(size)) for size in (40, PIXELS[::-1]))
    density = density * turned
    images, gradients = [], []
    for draw in (drawn, compiled_drawn):
        given = [each.clone().requires_grad_() for each in (*corners, density)]
        x, y = (each.repeat_interleave(2, dim=1) for each in given[:2])
        images.append(draw(x, y, given[2], PIXELS, 0.0))
        gradients.append(torch.autograd.grad((images[-1] * weights).sum(), given))
    assert torch.allclose(*images, rtol=0, atol=1e-12) and images[0].max() > 1
    for mine, theirs in zip(*gradients, strict=True):
        assert torch.allclose(mine, theirs, rtol=0, atol=1e-11)
