"""Of trains that are mirror images of themselves a part is traced, and it makes the whole image."""

import numpy as np
import pytest
import torch

from tests.optics.train.trains import (
    all_losses,
    asphere,
    before,
    biconvex,
    from_far,
    heights_of,
    in_frame,
    train,
    two_faces,
)
from workbench.geometry.outlines import Ellipse, Rectangle
from workbench.optics.images.beams import beam_image
from workbench.optics.sources import Origins
from workbench.optics.train.compiled import CompiledTrain
from workbench.optics.train.incident import halved
from workbench.scene import GaussianFilter


def points(x, y, z, each=0.1):
    """Points at all mirror images of some places."""
    places = np.array([[s * a, t * b] for a in x for b in y for s in (-1, 1) for t in (-1, 1)])
    places = np.unique(places + 0.0, axis=0)  # no −0
    return Origins(
        np.column_stack([places, np.full(len(places), z)]), False, np.full(len(places), each)
    )


def symmetric(values, mirrored):
    """Mean of values (along x first) and their mirror images."""
    for axis in (0, 1):
        if mirrored[axis]:
            values = (values + values.flip(axis)) / 2
    return values


def behind_biconvex(scene, light, outline):
    return before(scene, light, (24, 20), lambda datum: biconvex(datum, outline), outline)


NEAR, SIX, ONE = (
    points((0.3, 0.1), (0.2, 0.4), -4),
    points((0.1, 0), (0.2,), -5),
    points((0,), (0,), -5),
)
PATHS = {
    "lens": lambda scene: train(scene, NEAR, (80, 60)),
    "two faces": lambda scene: two_faces(scene, NEAR, (40, 30)),
    "biconvex before a lens": lambda scene: behind_biconvex(scene, ONE, Rectangle((0.9, 0.9))),
    "biconvex before an ellipse": lambda scene: behind_biconvex(scene, SIX, Ellipse((0.9, 0.9))),
}
EACH = pytest.mark.parametrize("path_of", PATHS.values(), ids=PATHS)


@EACH
@pytest.mark.parametrize("mirrored", [(True, False), (True, True)])
def test_nodes_of_a_part_make_the_image_of_all(path_of, mirrored):
    scene = all_losses(**{"screen.half_width": [1.5, 1.5]})
    path = path_of(scene)
    heights = {name: symmetric(z, mirrored) for name, z in heights_of(path, 3, 0.002).items()}
    cotangent = torch.tensor(np.random.default_rng(0).normal(size=(32, 32)))
    cotangent = symmetric(cotangent.T, mirrored).T
    found = []
    for promise in (mirrored, (False, False)):
        tracer = CompiledTrain(path, promise)
        leaves = [each.clone().requires_grad_() for each in heights.values()]
        hits, account, _ = tracer.nodes(dict(zip(heights, leaves, strict=True)))
        image, _ = beam_image(hits, scene.receiver.pixels, tracer.splits)
        for axis in (0, 1):
            if tracer.mirrored[axis]:
                image = image + image.flip(1 - axis)
        gradients = torch.autograd.grad((image * cotangent).sum(), leaves)
        found.append((image.detach(), account.to_data(), gradients, tracer.mirrored))
    (part, account, part_gradients, used), (whole, all_light, gradients, _) = found
    assert used == mirrored
    assert (part - whole).abs().max() < 1e-12
    assert account == pytest.approx(all_light, abs=1e-12)
    for one, other in zip(part_gradients, gradients, strict=True):
        assert (one - other).norm() < 1e-8 * other.norm()


@EACH
def test_a_quarter_of_the_rays_gives_the_whole_image(path_of):
    scene, both = all_losses(), (True, True)
    path = path_of(scene)
    heights = {name: symmetric(z, both) for name, z in heights_of(path, 2).items()}
    cotangent = symmetric(torch.tensor(np.random.default_rng(0).normal(size=(32, 32))), both)
    found = []
    for promise in (both, (False, False)):
        leaves = [each.clone().requires_grad_() for each in heights.values()]
        given = dict(zip(heights, leaves, strict=True))
        light = CompiledTrain(path, promise).image(given, GaussianFilter(size=(3, 3)))
        gradients = torch.autograd.grad((light.flux * cotangent).sum(), leaves)
        found.append((light.flux.detach(), light.account.to_data(), gradients))
    (part, account, part_gradients), (whole, all_light, gradients) = found
    assert torch.allclose(part, whole, rtol=0, atol=1e-13)
    assert account == pytest.approx(all_light, abs=1e-12)
    for one, other in zip(part_gradients, gradients, strict=True):
        # Light on edges of pixels has another slope on each side.
        other = symmetric(other, both)
        assert (one - other).norm() < 1e-10 * other.norm()


def test_one_of_two_mirrored_origins_is_traced():
    places = np.array([[-1.0, 0, -3], [1.0, 0, -3], [0.0, 2, -3], [0.0, -2, -3]])
    origins = Origins(places, False, np.array([1.0, 1.0, 2.0, 2.0]))
    kept, mirrored = halved(origins, (True, True))
    assert mirrored == (True, True)
    np.testing.assert_array_equal(kept.places[:, :2], [[1, 0], [0, 2]])
    np.testing.assert_array_equal(kept.flux, [0.5, 1.0])
    lopsided = origins._replace(flux=np.array([1.0, 3.0, 2.0, 2.0]))
    assert halved(lopsided, (True, True))[1] == (False, True)
    aside = origins._replace(places=places + np.array([0.1, 0, 0]))
    assert halved(aside, (True, False))[1] == (False, False)


@pytest.mark.parametrize(
    ("position", "tilt", "kept"),
    [
        ((0, 0, 1.0), (0.0, 0.0, 0.0), (True, True)),
        ((0, 0.1, 1.0), (5.0, 0.0, 0.0), (True, False)),
        ((0.1, 0, 1.0), (0.0, 0.0, 0.0), (False, True)),
    ],
)
def test_only_symmetric_trains_are_traced_by_halves(position, tilt, kept):
    behind = in_frame(asphere(), position, tilt)
    path = train(all_losses(), from_far(1, 0.0), (20, 16), behind)
    assert CompiledTrain(path, (True, True)).mirrored == kept
