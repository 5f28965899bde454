"""How many beams of light make the images by which lenses are compared."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.images import AnyImage, SeveralImages, WideImage, directions_at_receiver
from workbench.design.lens_blur import BlurChange, BlurredPlan, LensBlur
from workbench.design.near_sources import Density, fitting_source_cells
from workbench.extended.blur import Blur, one_over_the_lens
from workbench.extended.scattering import Scattering, film_scene
from workbench.measured.lamps import of_known_size
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners
from workbench.scene import Scene, WantedImage


@dataclass(frozen=True)
class Level(Density):
    """How many cells of light make an image, along each axis for light of one origin."""

    # With which power of the number of origins of the light cells along an axis get fewer. In
    # proportion would be 0.5; but all see the same face, and a descent has to see all of it.
    thinning: float
    origins: int = 1  # times as many origins of the light of a source of some size


# Cells for each control point along an axis, at least: no cell sees waves of the face between them.
# A lens of 65 control points, seen by 50 cells, was 5.4 % off where the run saw 0.4 %.
_SEEN = 1.5
COARSE = Level(per_pixel=1.5, per_control_point=1.2, enough=math.inf, seen=_SEEN, thinning=0.5)
"""Tells which of two first lenses is the better one."""

FINE = Level(per_pixel=3.0, per_control_point=1.9, enough=3.6, seen=_SEEN, thinning=0.25)
"""All lenses of a run are judged by it, so that their losses can be compared.

A flame is 1.55 % off after 8.3 s with 1.9 cells for each control point, 1.51 % after 10.5 s with
2.1. 2.0 cells would often meet the spans of a net at the same places.
"""

JUDGED = replace(FINE, per_control_point=2.6, enough=math.inf, origins=4)
"""The best lens of a run is judged by it at last, by beams that the descent has not corrected.

By `FINE` a run sees 1.48 % of the 1.56 % of a flame, by this 1.55 %; by 64 origins an LED's lens is
5.81 % off, by 128 to 512 of them 6.22 to 6.27 %, as 16 random images verify.
"""

# More of them take over 4 GB: with 8192 of them, a lens of 4096 × 4096 pixels takes 8.8 GB.
_MOST_CELLS = 4096
# Times as many cells along an axis where a lens makes several images: the light of one runs
# together where that of the other is spread. Of 0.82 % of error, 2.6 cells for each control point
# see 0.68 % and 5.2 see 0.81 %.
_SEVERAL = 2.0
# What symmetry saves goes in part into cells, by this factor along each axis for each mirror: the
# smaller the error, the more of it is that of too few cells.
_MIRRORED = 1.3
# Cells of each of many points, at least.
_FEWEST_CELLS = 24
# A blur of fewer pixels is not seen.
_UNSEEN = 0.2
# Origins for each pixel under the blur; and how many at least and at most. A descent corrects the
# images of few origins alone: a letter by an LED is 7.7 % off with 16 of them, of which the run
# sees 3.9 %, and 6.3 % with 64; *LED to a rectangle* 6.26 % with 64, 5.8 to 6.1 % with 96.
_PER_PIXEL, _FEWEST_ORIGINS, _MOST_ORIGINS = 1.5, 96, 128
# Cells of all origins together, at most.
_MOST_BEAMS = 1 << 22
# Cells that tell how far the light of a lens reaches.
_FEW_CELLS = (128, 128)
# Two faces close to a source are asked for so much more light than the first design sends: 67.1 %
# of an LED 10 mm before a lens of 120 mm arrive with an error of 4.3 %, not 61.9 % with 3.3 %.
_MORE_LIGHT = 1.05
# Cells of each of many origins, and of the middle of the source, that tell how it is blurred and
# whether that is the same all over a lens: as many, for light is spread over them too. And the
# greatest part of the image by which it may differ.
_MANY_CELLS, _MANY_ORIGINS, _EVEN = (192, 192), 96, 0.03
# Its widths over those behind a plate: steep faces and long ways to the rim of the receiver make it
# wider. Images change as their difference over a step does, not farther than some steps.
_MIDDLE, _STEP, _FARTHEST = 1.01, 0.03, 3.0


def image_of(
    level: Level,
    scene: Scene,
    target: Array,
    light_extent: tuple[float, float],
    mirrored: tuple[bool, bool] = (False, False),
    blur: LensBlur | None = None,
    asked_light: float | None = None,
    cells: Corners | None = None,
    scattering: Scattering | None = None,
) -> WideImage:
    """The image by which a level compares lenses.

    `level`: says how many cells make it; `target` (n_y, n_x): the wanted image in any scale, row 0
    at +y; `cells`: in place of those of the level; see `fitting_source_cells`.
    """
    cells = cells or cells_of(level, scene, mirrored, sharp=blur is not None)
    how = mirrored, blur, asked_light, scattering
    return WideImage(scene, target, cells, light_extent, *how)


def cells_of(
    level: Level, scene: Scene, mirrored: tuple[bool, bool] = (False, False), sharp: bool = False
) -> Corners:
    """Cells of the image by which a level compares lenses.

    `sharp`: whether light of the middle of the source stands for all of it, as with a blur.
    """
    origins = 1 if sharp else _origins(scene)
    if origins > 1:
        origins *= level.origins
    count = scene.source.point_count * origins
    finer = _MIRRORED ** sum(mirrored) / count**level.thinning
    least = level.seen if count > 1 else 0.0
    cells = [
        max(level.along(pixels, points) * finer, least * points)
        for pixels, points in zip(scene.receiver.pixels, scene.optic.net_shape, strict=True)
    ]
    finest = max(1.0, math.sqrt(math.prod(cells) * count / _MOST_BEAMS)) if count > 1 else 1.0
    cells = [number / finest for number in cells]
    # An even number makes a mirrored lens a mirrored image, of which half need be traced.
    m_x, m_y = (min(max(2 * math.ceil(count / 2), _FEWEST_CELLS), _MOST_CELLS) for count in cells)
    return Corners(m_x, m_y, origins)


def finest_image(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Tensor],
    mirrored: tuple[bool, bool] = (False, False),
) -> AnyImage:
    """The image by which a run compares lenses like one that is there.

    `heights` (n_u, n_v): control heights of that lens; they say how far its light falls and how it
    is blurred.
    """
    return _images(FINE, scene, target, heights, mirrored)


def judging_image(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Tensor],
    mirrored: tuple[bool, bool] = (False, False),
) -> AnyImage | None:
    """The image by which the best lens of a run is judged at last; see `finest_image`.

    None where it has no more beams than that one.
    """
    several = _SEVERAL if len(scene.images) > 1 else 1.0
    level = replace(JUDGED, per_control_point=several * JUDGED.per_control_point)
    if all(cells_of(level, each) == cells_of(FINE, each) for each in scene.single):
        return None
    return _images(level, scene, target, heights, mirrored)


def _images(
    level: Level,
    scene: Scene,
    target: Array,
    heights: Mapping[str, Tensor],
    mirrored: tuple[bool, bool],
) -> AnyImage:
    images = scene.wanted(target)
    made = [_image_of(level, image, heights, mirrored) for image in images]
    return made[0] if len(made) == 1 else SeveralImages(made, images)


def _image_of(
    level: Level,
    image: WantedImage,
    heights: Mapping[str, Tensor],
    mirrored: tuple[bool, bool],
) -> WideImage:
    """One of the images of a scene, for lenses like one that is there."""
    scene, cells = film_scene(image.scene), None
    blur = lens_blur_of(scene, heights)
    scattering = Scattering.of(image.scene, directions_at_receiver(image.scene, heights))
    if blur is None and _origins(scene) > 1:
        cells = fitting_source_cells(scene, heights, mirrored)
    return image_of(
        level,
        scene,
        image.target,
        light_extent_of(scene, heights),
        mirrored,
        blur,
        asked_light_of(scene, heights),
        cells,
        scattering,
    )


def _origins(scene: Scene) -> int:
    """Origins that stand for a source of some size, as many as its blur on the receiver needs."""
    scene = scene.alone
    source, receiver = of_known_size(scene.source, scene.optic), scene.receiver
    if not source.continuous:
        return 1
    across, up = (
        width * pixels / (2 * half)
        for width, pixels, half in zip(
            source.blur(scene.optic, receiver),
            receiver.pixels,
            receiver.half_extent,
            strict=True,
        )
    )
    if max(across, up) < _UNSEEN:
        return 1
    wanted = _PER_PIXEL * max(across, 1.0) * max(up, 1.0)
    return int(min(max(4 * math.ceil(wanted / 4), _FEWEST_ORIGINS), _MOST_ORIGINS))


def light_extent_of(scene: Scene, heights: Mapping[str, Tensor]) -> tuple[float, float]:
    """How far from the receiver's middle the light of a lens falls, in its coordinates."""
    return BeamPlan(scene, _FEW_CELLS).light_extent(heights)


def asked_light_of(scene: Scene, heights: Mapping[str, Tensor]) -> float | None:
    """What two faces close to a source shall send to the receiver; None for other lenses.

    There the faces decide how much light comes through, and two of them have a choice: an image
    that is compared with as much light as arrives gets better by losing what is hard to place.
    """
    optic = scene.optic
    near = optic.front_z - scene.alone.source.nearest_z < max(optic.half_width)
    if len(heights) == 1 or not near:
        return None
    with torch.no_grad():
        arrived = BeamPlan(scene, _FEW_CELLS).trace(heights).account.arrived
    return _MORE_LIGHT * arrived or None


def lens_blur_of(scene: Scene, heights: Mapping[str, Tensor]) -> LensBlur | None:
    """What the parts of a lens make of a source of some size; None where they differ too much.

    All origins are traced once, and compared with the light of the middle of the source, blurred by
    different widths. The width behind a plate is short of that behind steep faces: by 2 % for a
    photograph in the sun, of which a run then saw 1.9 % in place of 2.2 % as its error. How the
    blur differs from place to place of the image comes from single rays.

    `heights` (n_u, n_v): control heights of a lens like those to come.
    """
    if _origins(scene) == 1 or not one_over_the_lens(scene):
        return None
    blur = Blur.of(scene, heights[scene.optic.designed_face].mean().item())
    if blur.seen_in(scene.receiver.pixels) != blur:
        return None
    change = BlurChange.of(scene, heights)
    margin = blur.scaled(_MIDDLE + _STEP).margin

    def wider(x: float, y: float) -> Blur:
        return replace(blur, widths=(x * blur.widths[0], y * blur.widths[1]))

    def blurred(x: float, y: float) -> Array:
        """The light of the middle with a blur so many times as wide along x and y."""
        plan = BlurredPlan(scene, _MANY_CELLS, LensBlur(wider(x, y), change))
        return _image(plan, heights, margin)

    with torch.no_grad():
        traced = _image(BeamPlan(scene, Corners(*_MANY_CELLS, _MANY_ORIGINS)), heights, margin)
        middle = blurred(_MIDDLE, _MIDDLE)
        steps = [
            (blurred(_MIDDLE + x, _MIDDLE + y) - blurred(_MIDDLE - x, _MIDDLE - y)) / 2
            for x, y in ((_STEP, 0), (0, _STEP))
        ]
    best = np.linalg.lstsq(np.column_stack([*map(np.ravel, steps)]), (traced - middle).ravel())[0]
    x, y = (_MIDDLE + _STEP * part for part in best.clip(-_FARTHEST, _FARTHEST).tolist())
    from scipy.signal import fftconvolve  # late: it takes long to import

    # Origins make dots of narrow light, which are no difference of the lens.
    even = [fftconvolve(image, blur.spread()[0], mode="same") for image in (traced, middle)]
    unlike = np.linalg.norm(even[1] - even[0])
    if unlike >= _EVEN * np.linalg.norm(even[0]):
        return None
    return LensBlur(wider(x, y), change)


def _image(
    plan: BeamPlan | BlurredPlan, heights: Mapping[str, Tensor], margin: tuple[int, int]
) -> Array:
    """The image that a plan makes of a lens."""
    return np.asarray(plan.trace(heights, margin).flux.double().cpu().numpy())
