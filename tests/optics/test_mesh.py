"""The triangle mesh: watertight, exact in its triangles, close to the B-spline as it is refined."""

import itertools

import numpy as np
import pytest
import torch

from workbench.geometry.patches import Patches
from workbench.geometry.surface import ControlNet
from workbench.optics.surfaces.intersection import Bundle, ExactIntersection
from workbench.optics.surfaces.mesh import MeshIntersection, TriangleMesh

DTYPES = [torch.float32, torch.float64]
NET = ControlNet((7, 6), (3, 2), (1.0, 0.75))


def wavy(net=NET, height=0.125, dtype=torch.float64):
    """Control heights that make every triangle another plane."""
    x, y = net.positions
    z = 0.625 + height * np.cos(3 * x)[:, None] * np.sin(2 * y + 0.25)[None]
    return torch.as_tensor(z, dtype=dtype)


def bundle(x, y, slope_x, slope_y, dtype=torch.float64):
    parts = np.broadcast_arrays(x, y, slope_x, slope_y, 1.0)
    return Bundle(*(torch.as_tensor(np.array(part), dtype=dtype) for part in parts))


def meet(rays, heights, subdivisions=(2, 2), net=NET):
    heights = heights.to(rays.x.dtype)
    mesh = TriangleMesh(net, subdivisions, rays.x.dtype)
    return MeshIntersection(rays, mesh).meet(heights, heights)


def exact(rays, heights, net=NET):
    patches = Patches(net, rays.x.dtype)
    return ExactIntersection(rays, net.half_width, patches).meet(heights, patches.table(heights))


def random_rays(rng, count, steepness=0.5, net=NET, dtype=torch.float64):
    x, y = (rng.uniform(-r, r, count) for r in net.half_width)
    slope_x, slope_y = steepness * rng.uniform(-1, 1, (2, count))
    return bundle(x, y, slope_x, slope_y, dtype)


def vertices(heights, subdivisions, net=NET):
    """Coordinates of the mesh's lines, and heights of its vertices."""
    mesh = TriangleMesh(net, subdivisions, torch.float64)
    lines = [
        np.linspace(-r, r, count + 1) for r, count in zip(net.half_width, mesh.cells, strict=True)
    ]
    z = mesh.vertices(heights).reshape(mesh.cells[0] + 1, mesh.cells[1] + 1)
    return *lines, z.numpy()


def by_brute_force(rays, heights, subdivisions, net=NET, slack=1e-11):
    """First hit among all triangles, each taken with its whole boundary; infinite without any."""
    x, y, z = vertices(heights, subdivisions, net)
    first = np.full(len(rays.x), np.inf)
    o_x, o_y, d_x, d_y = (part.numpy() for part in rays[:4])
    for i in range(len(x) - 1):
        for j in range(len(y) - 1):
            for a, b, c in (
                ((i, j), (i + 1, j), (i, j + 1)),
                ((i + 1, j + 1), (i, j + 1), (i + 1, j)),
            ):
                slope_x = (z[b] - z[a]) / (x[b[0]] - x[a[0]])
                slope_y = (z[c] - z[a]) / (y[c[1]] - y[a[1]])
                rise = z[a] + slope_x * (o_x - x[a[0]]) + slope_y * (o_y - y[a[1]])
                with np.errstate(divide="ignore", invalid="ignore"):
                    t = rise / (1 - slope_x * d_x - slope_y * d_y)
                    e_x = (o_x + d_x * t - x[a[0]]) / (x[b[0]] - x[a[0]])
                    e_y = (o_y + d_y * t - y[a[1]]) / (y[c[1]] - y[a[1]])
                    inside = (e_x >= -slack) & (e_y >= -slack) & (e_x + e_y <= 1 + slack)
                first = np.where(inside & (t > 0), np.minimum(first, t), first)
    return first


@pytest.mark.parametrize("subdivisions", [(1, 1), (2, 3)])
@pytest.mark.parametrize("rugged", [False, True])
def test_the_first_of_all_triangles_is_hit(rng, subdivisions, rugged):
    # Rugged heights and flat rays: many hits of one ray, and walks through the whole mesh.
    rays = random_rays(rng, 40_000, 5.0 if rugged else 0.9)
    heights = torch.as_tensor(rng.uniform(0.2, 1.4, NET.shape)) if rugged else wavy()
    met = meet(rays, heights, subdivisions)
    first = by_brute_force(rays, heights, subdivisions)
    assert (met.found.numpy() == np.isfinite(first)).all()
    found = np.isfinite(first)
    assert 0.05 < found.mean() < 1
    assert np.abs(met.depth.numpy() - first)[found].max() < 1e-9


def places_on_edges(rng, subdivisions, count):
    """Points of the mesh on vertices, on edges along x and y, and on diagonals; none on the rim."""
    x, y, z = vertices(wavy(), subdivisions)
    i = rng.integers(1, len(x) - 2, count)
    j = rng.integers(1, len(y) - 2, count)
    f = rng.uniform(0, 1, count)
    ends = {
        "vertex": ((i, j), (i, j)),
        "along x": ((i, j), (i + 1, j)),
        "along y": ((i, j), (i, j + 1)),
        "diagonal": ((i + 1, j), (i, j + 1)),
    }
    return {
        name: (
            (1 - f) * x[a[0]] + f * x[b[0]],
            (1 - f) * y[a[1]] + f * y[b[1]],
            (1 - f) * z[a] + f * z[b],
        )
        for name, (a, b) in ends.items()
    }


@pytest.mark.parametrize("dtype", DTYPES)
def test_no_ray_is_lost_on_vertices_edges_and_diagonals(rng, dtype):
    subdivisions = (3, 2)
    tolerance = 40 * torch.finfo(dtype).eps
    aimed = 0
    for place in places_on_edges(rng, subdivisions, 30_000).values():
        p_x, p_y, p_z = place
        steep = 0.3 * rng.uniform(-1, 1, (2, len(p_x)))
        steep[:, ::5] = 0  # along the axis
        steep[0, 1::5] = 0  # within planes of the grid
        steep[1, 2::5] = 0
        steep[1, 3::5] = -steep[0, 3::5] * 0.75  # along the diagonals
        x, y = p_x - steep[0] * p_z, p_y - steep[1] * p_z
        starts = (np.abs(x) <= NET.half_width[0]) & (np.abs(y) <= NET.half_width[1])
        rays = bundle(x[starts], y[starts], steep[0][starts], steep[1][starts], dtype)
        met = meet(rays, wavy(), subdivisions)
        assert met.found.all()
        assert np.abs(met.depth.numpy() - p_z[starts]).max() < tolerance
        aimed += starts.sum()
    assert aimed > 100_000


def test_the_error_falls_with_the_square_of_the_subdivision(rng):
    rays = random_rays(rng, 40_000)
    truth = exact(rays, wavy())
    errors = []
    for n in (4, 8, 16, 32):
        met = meet(rays, wavy(), (n, n))
        both = met.found & truth.found
        assert (met.found != truth.found).sum() < 20  # near the rim
        errors.append((met.depth - truth.depth)[both].abs().max().item())
    assert errors[-1] < 1e-4
    for coarse, fine in itertools.pairwise(errors):
        assert 3.6 < coarse / fine < 4.4


def test_the_gradient_is_that_of_central_differences(rng):
    rays = random_rays(rng, 2_000)
    weight = torch.as_tensor(rng.uniform(-1, 1, 2_000))
    heights = wavy().requires_grad_()

    def total(z):
        met = meet(rays, z)
        return (weight * met.depth * met.found).sum()

    (gradient,) = torch.autograd.grad(total(heights), heights)
    direction = torch.as_tensor(rng.standard_normal(NET.shape))
    # The depth is continuous, its derivative jumps between triangles: short steps, few rays there.
    h = 1e-7
    with torch.no_grad():
        difference = (total(heights + h * direction) - total(heights - h * direction)) / (2 * h)
    assert (gradient * direction).sum().item() == pytest.approx(difference.item(), rel=1e-5)
