"""The walk through two freeform faces: what is known of it, and its gradients."""

import numpy as np
import pytest
import torch

from tests.optics.gradients import check_against_differences
from tests.optics.landing import places_of
from tests.optics.points import interpolating
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.path import Path

INDEX = 1.5
LENS = {
    "lens.entrance": {"shape": "freeform", "control_points": [9, 7], "height_range": [-0.2, 0.2]},
    "lens.height_range": None,
}
SOURCES = {
    "collimated": {"kind": "collimated", "rays": [40, 30]},
    "tilted": {"kind": "collimated", "rays": [20, 20], "direction": [6, -3]},
    "sun": {"kind": "collimated", "rays": [20, 20], "angular_diameter": 2.0},
    "point": {"kind": "point", "position": [0.1, -0.2, -3], "rays": 900},
    "grid": {
        "kind": "grid",
        "center": [0, 0, -3],
        "half_width": [0.3, 0.3],
        "points": [2, 3],
        "rays": 150,
    },
    "area": {"kind": "area", "center": [0.1, 0, -2], "half_width": [0.2, 0.1], "rays": 1024},
}
EACH = pytest.mark.parametrize("source", SOURCES.values(), ids=SOURCES)


def wavy(scene, rng, size=0.03):
    """Both faces of a lens, bent a little at random."""
    levels = {"lens.front": 0.0, "lens.back": 0.6}
    return {
        face: torch.as_tensor(levels[face] + size * rng.uniform(-1, 1, net.shape))
        for face, net in freeform_nets(scene.optic).items()
    }


def round_face(net, rise):
    """Control heights of a face whose height depends on the distance from the axis alone."""
    return interpolating(net, lambda x, y: rise(np.hypot(x, y)))


def fine(make_scene, changes):
    """A lens whose faces hold smooth surfaces to the last digits."""
    net = {"degree": [7, 7], "control_points": [48, 48]}
    entrance = {"shape": "freeform", **net, "height_range": [-0.5, 0.5]}
    own = {f"lens.{name}": value for name, value in net.items()}
    return make_scene({**LENS, **own, "lens.entrance": entrance, **changes})


@EACH
@pytest.mark.parametrize("face", ["lens.front", "lens.back"])
def test_the_gradient_of_each_face_is_that_of_differences(make_scene, rng, source, face):
    scene = make_scene({**LENS, "version": 2, "source": source})
    heights = wavy(scene, rng, 0.01)
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    weights = None

    def loss(moved):
        nonlocal weights
        arrival = path.walk({**heights, face: moved})
        parts = torch.stack([arrival.column, arrival.row, 1e3 * arrival.rays.flux])
        lands = parts.isfinite().all(0) & (arrival.rays.flux > 0)
        if weights is None:
            weights = torch.as_tensor(rng.normal(size=tuple(parts.shape))) * lands
        return (weights * torch.where(weights != 0, parts, 0.0)).sum()

    at = heights[face].requires_grad_()
    directions = [torch.as_tensor(rng.normal(size=tuple(at.shape))) for _ in range(2)]
    check_against_differences(loss, at, directions)


def test_two_hyperboloids_image_a_point_into_a_point(make_scene):
    # Light from a point is parallel behind the first: √(r² + (f + z)²) = f + n z.
    def rise(r, f):
        b, square = f * (INDEX - 1), INDEX**2 - 1
        return (np.sqrt(b**2 + square * r**2) - b) / square

    before, behind, thickness = 5.0, 7.0, 1.5
    scene = fine(
        make_scene,
        {
            "source": {"kind": "point", "position": [0, 0, -before], "rays": 2000},
            "screen.z": thickness + behind,
        },
    )
    nets = freeform_nets(scene.optic)
    heights = {
        "lens.front": round_face(nets["lens.front"], lambda r: rise(r, before)),
        "lens.back": round_face(nets["lens.back"], lambda r: thickness - rise(r, behind)),
    }
    path = Path.of(scene, nets["lens.back"], torch.float64)
    arrival = path.walk(heights)
    assert arrival.rays.alive.sum() > 900
    at = torch.stack(places_of(arrival, scene.receiver))[:, arrival.rays.alive]
    assert at.abs().max() < 1e-10


def test_an_afocal_pair_makes_a_parallel_beam_narrower(make_scene):
    # Behind the first face light goes to a point of the glass: z + n √(r² + (F − z)²) = n F. The
    # second is the same face, seen from that point in perspective: light leaves as it came.
    distance, factor = 12.0, 0.9

    def rise(r):
        b, square = distance * (1 - 1 / INDEX), 1 - 1 / INDEX**2
        return (b - np.sqrt(b**2 - square * r**2)) / square

    source = {"kind": "collimated", "rays": [30, 30]}
    scene = fine(make_scene, {"source": source, "screen.z": 30.0})
    nets = freeform_nets(scene.optic)
    heights = {
        "lens.front": round_face(nets["lens.front"], rise),
        "lens.back": round_face(
            nets["lens.back"], lambda r: distance + factor * (rise(r / factor) - distance)
        ),
    }
    path = Path.of(scene, nets["lens.back"], torch.float64)
    arrival = path.walk(heights)
    assert arrival.rays.alive.all()
    d_x, d_y, _ = arrival.rays.direction
    assert max(d_x.abs().max(), d_y.abs().max()) < 1e-10
    came, _, _ = path.rays.position
    x, _ = places_of(arrival, scene.receiver)
    np.testing.assert_allclose(x.reshape(30, 30), factor * came.expand(30, 30), rtol=0, atol=1e-10)
