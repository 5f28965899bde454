"""The blur of a source over the image of a lens, as traces of that lens show it."""

from collections.abc import Mapping, Sequence
from functools import reduce

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.lens_blur import (
    DEGREE,
    BlurChange,
    BlurredPlan,
    LensBlur,
    LightBlurring,
    plan_of,
)
from workbench.extended.blur import Blur, one_over_the_lens
from workbench.extended.blurring import ImageBlur, convolved, convolved_in_place, powers
from workbench.extended.scattering import Directions
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.paths import ray_paths
from workbench.optics.plan import arrays_of
from workbench.optics.samples import Corners
from workbench.scene import Scene, Screen

# Rays that sample the directions of light at a receiver.
_RAYS = 48, 48
# Fewer rays are not enough. Those that come to the plane farther out, in half-widths of the screen,
# are left out; beyond nearly all of the others, directions are as at that border.
_FEWEST, _NEAR_SCREEN, _NEARLY_ALL_RAYS = 100, 2.0, (0.002, 0.998)
# Cells along an axis of each of many origins, and of the middle of the source, that show how it is
# blurred and whether that is the same all over a lens: as many, for light is spread over them too.
# Where it differs, as many cells as control points decide: a designed face of 384² seems 5.2 %
# uneven with 192 cells, and is 1.4 % with 384, of 24 to 96 origins. And the greatest part of the
# image by which it may differ.
_LOOKS, _EVEN = ((192, 96), (384, 32), (768, 8)), 0.03
# Its widths over those behind a plate: steep faces and long ways to the rim of the receiver make it
# wider. Images change as their difference over a step does, not farther than some steps.
_MIDDLE, _STEP, _FARTHEST = 1.01, 0.03, 3.0


def directions_at_receiver(scene: Scene, heights: Mapping[str, Tensor]) -> Directions | None:
    """Mean directions in which light of a lens comes to places of a plane.

    None where no polynomials are needed, or too few rays come to the plane.
    """
    diffuser, screen = scene.diffuser, scene.receiver
    about_ray = diffuser is not None and diffuser.scatter.about_ray
    if not about_ray or not isinstance(screen, Screen):
        return None
    paths = ray_paths(scene, arrays_of(heights), _RAYS)
    right, up, normal = screen.sides
    start, end = paths.points[:, -2], paths.points[:, -1]
    ahead = np.abs((end - start) @ normal)
    place = (end - np.array(screen.position)) @ np.stack([right, up], axis=1) / screen.half_width
    near = (paths.weight > 0) & (ahead > 0) & (np.abs(place) < _NEAR_SCREEN).all(axis=1)
    if np.count_nonzero(near) < _FEWEST:
        return None
    place, weight = place[near], np.sqrt(paths.weight[near])[:, None]
    slopes = (end - start)[near] / ahead[near, None]
    terms = weight * powers(place[:, 0], place[:, 1], DEGREE)
    factors = np.linalg.lstsq(terms, weight * slopes)[0]
    low, high = np.quantile(place, _NEARLY_ALL_RAYS, axis=0)

    def directions(u: Array, v: Array) -> Array:
        lit = np.clip(np.stack([u, v], axis=-1) / screen.half_width, low, high)
        found = powers(lit[:, 0], lit[:, 1], DEGREE) @ factors
        return np.asarray(found / np.linalg.norm(found, axis=-1, keepdims=True))

    return directions


def lens_blur_of(
    scene: Scene, heights: Mapping[str, Tensor], blurs: Sequence[ImageBlur] = ()
) -> LensBlur | None:
    """What the parts of a lens make of a source of some size; None where they differ too much.

    All origins are traced once, and compared with the light of the middle of the source, blurred by
    different widths. The width behind a plate is short of that behind steep faces: by 2 % for a
    photograph in the sun, of which a run then saw 1.9 % in place of 2.2 % as its error. How the
    blur differs from place to place of the image comes from single rays.

    `heights` (n_u, n_v): control heights of a lens like those to come; `blurs`: what else blurs the
    image; differences that it hides do not count.
    """
    if not one_over_the_lens(scene):
        return None
    blur = Blur.of(scene, heights[scene.optic.designed_face].mean().item())
    if blur.seen_in(scene.receiver.pixels) != blur:
        return None
    given = LensBlur(blur, BlurChange.of(scene, heights))
    seen = reduce(convolved, (each.of_pixels for each in blurs), blur.spread()[0])
    for cells, origins in _LOOKS:
        found = _fitted(scene, heights, given, seen, cells, origins)
        if found is not None or cells >= max(scene.optic.net_shape):
            return found
    return None


def _fitted(
    scene: Scene,
    heights: Mapping[str, Tensor],
    given: LensBlur,
    seen: Array,
    count: int,
    origins: int,
) -> LensBlur | None:
    """A blur with the widths that a lens makes, if it is even behind the kernel ``seen``."""
    cells, near = (count, count), given.wider(_MIDDLE, _MIDDLE)
    margin = given.wider(_MIDDLE + _STEP, _MIDDLE + _STEP).mean.margin
    plan = plan_of(scene, cells, blur=near)
    assert isinstance(plan, BlurredPlan)  # for there is a blur
    with torch.no_grad():
        traced = _array(BeamPlan(scene, Corners(*cells, origins)).trace(heights, margin).flux)
        light, pixels = plan.unblurred(heights, margin).flux.float(), scene.receiver.pixels

        def blurred(x: float, y: float) -> Array:
            """The light of the middle with a blur that is wider by the factors x and y."""
            blur = given.wider(x, y).image_blur_in(near.mean.parts)
            return _array(LightBlurring.of(blur, pixels, margin, light.device).image(light))

        middle = blurred(_MIDDLE, _MIDDLE)
        steps = [
            (blurred(_MIDDLE + x, _MIDDLE + y) - blurred(_MIDDLE - x, _MIDDLE - y)) / 2
            for x, y in ((_STEP, 0), (0, _STEP))
        ]
    best = np.linalg.lstsq(np.column_stack([*map(np.ravel, steps)]), (traced - middle).ravel())[0]
    x, y = (_MIDDLE + _STEP * part for part in best.clip(-_FARTHEST, _FARTHEST).tolist())
    # Origins make dots of narrow light, which are no difference of the lens.
    even = [convolved_in_place(image, seen) for image in (traced, middle)]
    unlike = np.linalg.norm(even[1] - even[0])
    return given.wider(x, y) if unlike < _EVEN * np.linalg.norm(even[0]) else None


def _array(image: Tensor) -> Array:
    return np.asarray(image.double().cpu().numpy())
