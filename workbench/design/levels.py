"""How many beams of light make the images by which lenses are compared."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import torch
from torch import Tensor
from torch.nn.functional import avg_pool2d, grid_sample, interpolate

from workbench.arrays import Array
from workbench.design.fitted_blur import directions_at_receiver, lens_blur_of
from workbench.design.images import AnyImage, ExpectedImage, SeveralImages, WideImage
from workbench.design.lens_state import LensState
from workbench.design.loss import asked_light_of
from workbench.extended.relief_blur import relief_blur_of
from workbench.extended.scattering import film_scene, scattering_of
from workbench.geometry.as_made import AsMade
from workbench.geometry.surface import freeform_nets
from workbench.measured.lamps import of_known_size
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.plan import arrays_of, tensors_of
from workbench.optics.samples import Corners
from workbench.scene import Scene, WantedImage


@dataclass(frozen=True, kw_only=True)
class Density:
    """Samples along an axis, or cells between them."""

    # For each pixel along it, and for each control point, at least.
    per_pixel: float
    per_control_point: float
    # So many for each pixel are enough also for the control points of a fine net, as long as there
    # are ``seen`` of them for each.
    enough: float = math.inf
    seen: float = 0.0

    def along(self, pixels: int, points: int) -> float:
        """Samples along an axis of so many pixels and control points."""
        wanted = max(self.per_pixel * pixels, self.per_control_point * points)
        return min(wanted, max(self.enough * pixels, self.seen * points))


@dataclass(frozen=True, kw_only=True)
class Level(Density):
    """How many cells of light make an image, along each axis for light of one origin."""

    # With which power of the number of origins of the light cells along an axis get fewer. In
    # proportion would be 0.5; but all see the same face, and a descent has to see all of it.
    thinning: float
    origins: int = 1  # times as many origins of the light of a source of some size
    # Times as many samples and cells of the source along each axis, where beams run between
    # origins, as far as beams are not too many.
    finer: float = 1.0
    # The rays that make an image under the blur of such a source; None where beams do.
    rays: Density | None = None
    errors: bool = False  # whether faces have the random errors of a part that has been made


COARSE = Level(per_pixel=1.5, per_control_point=1.2, thinning=0.5)
"""Whether one first design is better than another."""

# With 1.5 rays for each control point, a run sees 1.070 times the lower bound of a photograph in
# the sun where 1.086 times are there.
_RAYS = Density(per_pixel=3.0, per_control_point=2.5)
FINE = Level(per_pixel=3.0, per_control_point=1.9, thinning=0.25, rays=_RAYS)
"""All lenses of a run are judged by it, so that their losses can be compared.

A flame is 1.55 % off after 8.3 s with 1.9 cells for each control point, 1.51 % after 10.5 s with
2.1. 2.0 cells would often meet the spans of a net at the same places. With 1.5 cells, lenses for
nine pictures are 14 % worse than with 1.9, and take 0.86 of the time.
"""

JUDGED = replace(
    FINE,
    per_control_point=2.6,
    origins=4,
    finer=2.0,
    rays=replace(_RAYS, per_control_point=3.7),
    errors=True,
)
"""The best lens of a run is judged by it at last, by beams that the descent has not corrected.

Of the 3.32 % of an LED's dome, `FINE` sees 2.98 % and this 3.28 %. Of the 1.45 % of a lens in the
sun that a mirror before it shades, light of the middle of the source sees 1.13 %, and that of its
four parts 1.31 %.
By `FINE` a run sees 1.48 % of the 1.56 % of a flame, by this 1.55 %; by 64 origins an LED's lens is
5.81 % off, by 128 to 512 of them 6.22 to 6.27 %, as 16 random images verify.
"""

# More of them take over 4 GB: with 8192 of them, a lens of 4096 × 4096 pixels takes 8.8 GB.
_MOST_CELLS = 4096
# Times as many cells for each control point where a lens makes several images, of a run and of the
# last look: the light of one runs together where that of the other is spread. Two images end at
# 1.20 % with 1.0 times as many, at 0.69 % with 1.4 in the same time, at 0.62 % with 2.0. Of 0.82 %
# of error, 2.6 cells for each control point see 0.68 % and 5.2 see 0.81 %.
_SEVERAL, _SEVERAL_JUDGED = 1.4, 2.0
# What symmetry saves goes in part into cells, by this factor along each axis for each mirror: the
# smaller the error, the more of it is that of too few cells.
_MIRRORED = 1.3
# Cells along an axis, at least: of each of many points, and of all points together. With 24 × 48
# cells, a point 0.06 half-widths before a train had 2.7 % more light than there is.
_FEWEST_CELLS, _FEWEST_OF_ALL = 24, 64
# A blur of fewer pixels is not seen.
_UNSEEN = 0.2
# Origins for each pixel under the blur; and how many at least and at most. A descent corrects the
# images of few origins alone: a letter by an LED is 7.7 % off with 16 of them, of which the run
# sees 3.9 %, and 6.3 % with 64; *LED to a rectangle* 6.26 % with 64, 5.8 to 6.1 % with 96.
_PER_PIXEL, _FEWEST_ORIGINS, _MOST_ORIGINS = 1.5, 96, 128
# Cells for each control point along an axis, at least, of the light of each of many origins: no
# cell sees waves of the face between them. A lens of 65 control points, seen by 50 cells, was 5.4 %
# off where the run saw 0.4 %.
_SEEN = 1.5
# Cells of all origins together, at most.
_MOST_BEAMS = 1 << 22
# Cells that show how far the light of a lens reaches.
_FEW_CELLS = (128, 128)
# Irradiance below which places are equally dark, as part of that where light is on average, and at
# how many places of the lens along an axis it is looked at where its light goes. With 0.12 and 0.3
# a photograph is 0.83 and 0.87 % off after 20 steps, words 3.11 and 3.24 %, a dark shape on white
# 2.04 and 1.90 %; with 0.2 0.85, 3.14 and 1.91 %.
_DARK, _MOST_PLACES = 0.2, 480
# Beams between the origins of a near source, see `workbench.optics.images.source_beams`: by beams
# between the samples of the lens for each origin, a run of two faces 7 mm before an LED sees 3.9 %
# where 7.3 % are verified; by beams between origins 4.5 % where 4.7 % are. Behind a dome and before
# a plate, 128 origins see 7.0 % of 8.5 %, beams between origins 7.9 % of 7.9 %. Samples of the lens
# along an axis, by the control points of the finest net: of an LED close by, 112 samples through 32
# control points saw 5.1 % where 5.8 % were there. A torch whose image has 256 pixels is 3.61 % off
# after 12 steps with 922 samples through 360 control points, and 3.59 % verified; 4.5 for each of
# these are 3.1 times as many rays, and took 6 s a step in a window.
_SAMPLES = Density(per_pixel=1.0, per_control_point=4.5, enough=3.6, seen=1.9)
# Cells of the source along an axis for each radian that it is wide from the lens, by which its
# image bends; and the most. With 6 of them, that LED's lens was 4.1 % off where the run saw 3.6 %.
_PER_RADIAN, _MOST_OF_SOURCE = 14.0, 14
# Cells of the source that show how far apart samples are, and the part of the light that may be too
# far. It is 0 to 0.10 of a torch and of an LED close by, and 0.35 to 0.47 where rims see the LED at
# a slant. At 0.10 beams between origins see 2.9 and those between samples 7.6 % of an error of
# 3.2 %; at 0.40 they see 9.9 and 6.2 % of 6.2 %.
_FEW, _TOO_FAR = (2, 2), 0.2
# Beams between origins of the last look, at most: their gradients are not needed.
_MOST_FINER = 1 << 23


def cells_of(
    level: Level,
    scene: Scene,
    mirrored: tuple[bool, bool] = (False, False),
    sharp: bool = False,
    rays: bool = False,
) -> Corners:
    """Cells of the image by which a level compares lenses.

    `sharp`: whether light of the middle of the source stands for all of it, as with a blur; at a
    level of more origins, where beams are not too many, light of the middles of as many parts of
    it; `rays`: whether it is drawn as rays at the corners of cells, if the level has them.
    """
    density = level.rays if rays and level.rays is not None else level
    origins = _origins(scene)
    if origins > 1:
        origins = 1 if rays else level.origins * (1 if sharp else origins)
    count = scene.source.point_count * origins
    finer = _MIRRORED ** sum(mirrored) / count**level.thinning
    least = _SEEN if count > 1 else 0.0
    cells = [
        max(density.along(pixels, points) * finer, least * points)
        for pixels, points in zip(scene.receiver.pixels, scene.optic.net_shape, strict=True)
    ]
    if sharp and origins > 1 and math.prod(cells) * count > _MOST_BEAMS:
        return cells_of(replace(level, origins=1), scene, mirrored, sharp)
    finest = max(1.0, math.sqrt(math.prod(cells) * count / _MOST_BEAMS)) if count > 1 else 1.0
    cells = [number / finest for number in cells]
    # An even number makes a mirrored lens a mirrored image, of which half need be traced.
    fewest = max(_FEWEST_CELLS, 2 * math.ceil(_FEWEST_OF_ALL / math.sqrt(count) / 2))
    m_x, m_y = (min(max(2 * math.ceil(number / 2), fewest), _MOST_CELLS) for number in cells)
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
    return _expected(fine_level(scene), scene, target, heights, mirrored)


def as_compared(scene: Scene, target: Array, heights: Mapping[str, Array]) -> LensState:
    """A lens in the light by which a run of the scene compares lenses."""
    lens = tensors_of(heights, scene)
    return finest_image(scene, target, lens).step(lens).state


def finest_image_of(image: WantedImage, heights: Mapping[str, Tensor]) -> WideImage:
    """The same for one image of a task, without uncertainty."""
    return _image_of(fine_level(image.scene), image, heights, (False, False))


def judging_image(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Tensor],
    mirrored: tuple[bool, bool] = (False, False),
) -> AnyImage | None:
    """The image by which the best lens of a run is judged at last; see `finest_image`.

    None where it has no more beams than that one.
    """
    level, fine = _level(JUDGED, scene, _SEVERAL_JUDGED), fine_level(scene)
    alike = all(cells_of(level, each) == cells_of(fine, each) for each in scene.single)
    if alike and not scene.processes:
        return None
    return _images(level, scene, target, heights, mirrored)


def fine_level(scene: Scene) -> Level:
    """The level by which a run compares lenses, for the images of a scene together."""
    return _level(FINE, scene, _SEVERAL)


def _level(level: Level, scene: Scene, several: float) -> Level:
    """A level with ``several`` times as many cells for a scene of several images."""
    if len(scene.images) == 1:
        return level
    return replace(level, per_control_point=several * level.per_control_point)


def _images(
    level: Level,
    scene: Scene,
    target: Array,
    heights: Mapping[str, Tensor],
    mirrored: tuple[bool, bool],
) -> AnyImage:
    wanted = scene.wanted(target)
    images = [_image_of(level, image, heights, mirrored) for image in wanted]
    return images[0] if len(images) == 1 else SeveralImages(images, wanted)


def _expected(
    level: Level,
    scene: Scene,
    target: Array,
    heights: Mapping[str, Tensor],
    mirrored: tuple[bool, bool],
) -> AnyImage:
    """Images of all cases that the scene's uncertainty asks for."""
    (exact, _), *others = cases = scene.uncertainty.cases(scene)
    images = [_images(level, exact, target, heights, mirrored)]
    if not others:
        return images[0]
    images += [_images(level, case, target, heights, (False, False)) for case, _ in others]
    return ExpectedImage(images, [WantedImage(case, target, share) for case, share in cases])


def _image_of(
    level: Level,
    image: WantedImage,
    heights: Mapping[str, Tensor],
    mirrored: tuple[bool, bool],
) -> WideImage:
    made = AsMade.of(image.scene, level.errors)
    ideal, heights = made.scene, made.tensors(heights)
    scene, cells = film_scene(ideal), None
    extended = _origins(scene) > 1
    scattering = scattering_of(ideal, directions_at_receiver(ideal, heights))
    blurs = tuple(filter(None, (scattering, relief_blur_of(made, arrays_of(heights)))))
    blur = lens_blur_of(scene, heights, blurs) if extended else None
    rays = blur is not None and blur.suits_rays
    if extended and blur is None:
        cells = fitting_source_cells(level, scene, heights, mirrored)
    cells = cells or cells_of(level, scene, mirrored, sharp=blur is not None, rays=rays)
    return WideImage(
        scene,
        image.target,
        cells,
        light_extent_of(scene, heights),
        mirrored,
        blur,
        asked_light_of(scene, heights),
        blurs,
        made,
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


def source_cells(
    scene: Scene, mirrored: tuple[bool, bool] = (False, False), finer: float = 1.0
) -> Corners | None:
    """Samples of the lens, and cells of the source between whose corners beams run.

    `finer`: times as many of both along each axis. Returns None where the source is infinitely
    far, is made of points, or stands in a file.
    """
    scene = scene.alone
    source, optic, receiver = scene.source, scene.optic, scene.receiver
    if source.place is None or not source.continuous or source.light_files:
        return None
    finest = np.max([net.shape for net in freeform_nets(optic).values()], axis=0)
    m_x, m_y = (
        2 * math.ceil(finer * _SAMPLES.along(pixels, points) / 2)
        for pixels, points in zip(receiver.pixels, finest.tolist(), strict=True)
    )
    across, up = (
        math.ceil(finer * min(_PER_RADIAN * blur / per_radian, _MOST_OF_SOURCE))
        for blur, per_radian in zip(
            source.blur(optic, receiver), receiver.per_radian(optic.leaving_z), strict=True
        )
    )
    # The middle of the source is a corner where one half of it is traced; and small grids that have
    # an even number of rows are drawn all at once.
    even = max(2 * math.ceil(across / 2), 2)
    rows = 2 + 4 * math.ceil((up - 2) / 4) if mirrored[1] else 1 + 2 * math.ceil((up - 1) / 2)
    return Corners.and_of_source(m_x, m_y, (even, max(rows, 2 if mirrored[1] else 3)))


def fitting_source_cells(
    level: Level, scene: Scene, heights: Mapping[str, Tensor], mirrored: tuple[bool, bool]
) -> Corners | None:
    """See `source_cells`; None also where samples of a lens are too far apart.

    `heights` (n_u, n_v): control heights of a lens like those to come.
    """
    cells = source_cells(scene, mirrored)
    if cells is None:
        return None
    plan = BeamPlan(scene, Corners.and_of_source(cells.x, cells.y, _FEW))
    if plan.light_apart(heights) >= _TOO_FAR:
        return None
    beams = cells.x * cells.y * cells.origins / 2 ** sum(mirrored)
    finer = min(level.finer, (_MOST_FINER / beams) ** 0.25)
    return source_cells(scene, mirrored, finer) if finer > 1 else cells


def light_extent_of(scene: Scene, heights: Mapping[str, Tensor]) -> tuple[float, float]:
    """How far from the receiver's middle the light of a lens falls, in its coordinates."""
    return BeamPlan(scene, _FEW_CELLS).light_extent(heights)


def eases_of(
    image: AnyImage, scene: Scene, target: Array, heights: Mapping[str, Tensor]
) -> dict[str, Array]:
    """How much larger waves of a face are to be where its light goes to dark places.

    `heights` (n_u, n_v): control heights of a lens like those to come. Returns (n_u, n_v) for each
    face; see `workbench.design.waves`. Nothing for two faces, several images, and blurred ones.
    """
    if image.blurred or len(heights) > 1 or len(scene.images) > 1:
        return {}
    ((face, net),) = heights.items()
    n_u, n_v = net.shape
    column, row = BeamPlan(scene, (min(n_u, _MOST_PLACES), min(n_v, _MOST_PLACES))).places(heights)
    drawn = target / target.max()
    where_light_is = np.square(drawn).sum() / drawn.sum()
    wanted = torch.as_tensor(drawn / where_light_is, device=net.device)[None, None]
    wanted = avg_pool2d(wanted, 3, 1, 1, count_include_pad=False)
    n_y, n_x = target.shape
    at = [2 * column.to(wanted) / n_x - 1, 2 * row.to(wanted) / n_y - 1]
    places = torch.stack(at, -1).nan_to_num(0.0, 2.0, -2.0)[None]
    found = grid_sample(wanted, places, padding_mode="border", align_corners=False)
    found = interpolate(found, (n_v, n_u), mode="bilinear", align_corners=True)[0, 0].T
    return {face: (1 / (found.square() + _DARK**2).sqrt()).cpu().numpy()}
