"""Intensity of the light that leaves a finished lens, by beams of light: it has no noise.

The light is drawn on a fine grid of H and V, the angles of a far field, around all directions that
the lens sends light to. The grid is drawn twice, the second time with finer beams from more origins
of the source: how far the two differ tells how exact the light is known.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
import torch
from scipy.ndimage import gaussian_filter
from torch import Tensor

from workbench.arrays import Array, Index
from workbench.design.levels import JUDGED, cells_of
from workbench.errors import Refused
from workbench.files.export.design import Design
from workbench.measured.lamps import of_known_size
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners
from workbench.said import Said
from workbench.scene import FarField, Scene

# Cells along an axis, origins and pixels of the first images, which only tell where light is.
_FEW, _ORIGINS, _LOOK = 256, 16, 512
# Flux beyond each side of the window, over all of it.
_BEYOND = 1e-5
# Least half-width of the window and of a cell, degrees; the window's rim, over its half-width; and
# the part of a window that light has to fill before the window is final.
_NARROWEST, _RIM, _FULL = (0.01, 0.001), 0.02, 0.4
# The window lies about the axis if light reaches as far on one side of it, up to such a factor.
_LOPSIDED = 2.0
# Width of a cell over that of a pixel of the fine grid, at least and at most, and pixels along an
# axis that are enough.
_FINER, _ENOUGH_PIXELS = (6, 16), 1024
# Length of the window over its width at most.
_LONGEST = 16.0
# Cells across the window: at least and at most.
_FEWEST_CELLS, _MOST_CELLS = 48, 512
# Standard deviation of what spreads the light of an origin, over the way to the next origin.
_SPREAD = 0.5
# Beams grow by such a factor along each axis and in origins, up to so many in all, until two images
# differ by less than this.
_MORE, _MOST_BEAMS, _AGREE = math.sqrt(2), 1 << 24, 2e-3


@dataclass(frozen=True, eq=False)
class FarLight:
    """Intensity of the light that leaves a lens.

    Directions are those of a lamp file: its nadir is where light goes on to, and a direction is
    (cos V sin H, sin V, cos V cos H) with C0 at H > 0 and C90 at V < 0.

    Attributes
    ----------
    h, v : ndarray, shape (n_h,), (n_v,)
        Middles of the pixels in degrees, ascending, in equal steps.
    intensity : ndarray, shape (n_v, n_h)
        Mean in each pixel, flux per solid angle; what the source emits in all is 1.
    finer : int
        Pixels along each axis of a cell: the light is compared by the means in cells.
    uncertainty : float
        Relative L2 difference of the intensity in cells from that of coarser beams.
    flux : float
        All light that leaves the lens.
    origins : int
        Points that stand for a source of some size.
    """

    h: Array
    v: Array
    intensity: Array
    finer: int
    uncertainty: float
    flux: float
    origins: int

    @property
    def cell(self) -> float:
        """Width of a cell, degrees: the larger one of both axes."""
        return self.finer * float(max(self.h[1] - self.h[0], self.v[1] - self.v[0]))

    @property
    def row_measure(self) -> Array:
        """Solid angle of a pixel in each row, up to a factor, shape (n_v,)."""
        return np.asarray(np.cos(np.radians(self.v)))

    def directions(self, row: Index | slice = slice(None)) -> Array:
        """Unit vectors to the middles of all pixels of some rows, shape (rows, n_h, 3)."""
        return directions_of(*np.meshgrid(self.h, self.v[row]))

    def in_cells(self, values: Array) -> Array:
        """Mean over the solid angle of each cell of values in pixels; times its root.

        The root of the sum of squares of what is returned is an L2 norm over the solid angle.
        """
        weight = self.row_measure[:, None]
        measure = _blocks(np.broadcast_to(weight, values.shape), self.finer)
        return _blocks(values * weight, self.finer) / np.sqrt(measure)


def directions_of(h: Array, v: Array) -> Array:
    """Unit vectors of angles H and V in degrees, shape (..., 3); see `FarLight`."""
    h, v = np.radians(h), np.radians(v)
    return np.stack([np.cos(v) * np.sin(h), np.sin(v), np.cos(v) * np.cos(h)], axis=-1)


def far_light(design: Design) -> FarLight:
    """Return the intensity of the light that leaves a lens.

    Parameters
    ----------
    design : Design
        The lens and its task.

    Raises
    ------
    Refused
        If no light leaves the lens.
    """
    scene = design.scene
    heights = {
        face: torch.as_tensor(np.array(each, dtype=np.float64))
        for face, each in design.result.state.heights.items()
    }
    window = _window(scene, heights)
    cells = _cells(scene, window)
    finer = int(np.clip(_ENOUGH_PIXELS // max(cells), *_FINER))
    fine = window.altered(pixels=(finer * cells[0], finer * cells[1]))
    corners = cells_of(JUDGED, _with_far_field(scene, window.altered(pixels=cells)))
    light = _drawn(scene, fine, _denser(corners, 1 / _MORE), finer, heights)
    while light.uncertainty > _AGREE:
        if math.prod(corners[:3]) > _MOST_BEAMS and math.isfinite(light.uncertainty):
            break
        last, light = light, _drawn(scene, fine, corners, finer, heights)
        change = light.in_cells(light.intensity - last.intensity)
        off = float(np.linalg.norm(change) / np.linalg.norm(light.in_cells(light.intensity)))
        light, corners = replace(light, uncertainty=off), _denser(corners, _MORE)
    return light


def _denser(corners: Corners, factor: float) -> Corners:
    """So many times as many cells along an axis, and origins of a source of some size."""
    origins = max(round(corners.origins * factor**2), 1) if corners.origins > 1 else 1
    return Corners(round(corners.x * factor), round(corners.y * factor), origins)


def _drawn(
    scene: Scene, far_field: FarField, corners: Corners, finer: int, heights: Mapping[str, Tensor]
) -> FarLight:
    """The light by so many beams; its uncertainty is not known yet."""
    plan = BeamPlan(_with_far_field(scene, far_field), corners)
    with torch.no_grad():
        light = plan.trace(heights)
    image = _between_origins(scene, far_field, corners, light.flux.double().cpu().numpy())
    image /= far_field.pixel_measure
    # Seen from behind a mirror, V counts the other way.
    upwards = image[::-1] if scene.optic.onwards > 0 else image
    h, v = (
        middle + half * (2 * np.arange(n) + 1 - n) / n
        for middle, half, n in zip(
            (far_field.center[0], scene.optic.onwards * far_field.center[1]),
            far_field.half_angle,
            far_field.pixels,
            strict=True,
        )
    )
    flux = light.account.on_screen + light.account.lost["off_screen"]
    return FarLight(h, v, np.ascontiguousarray(upwards), finer, math.inf, flux, corners.origins)


def _between_origins(scene: Scene, far_field: FarField, corners: Corners, flux: Array) -> Array:
    """Light of origins spread over the way from one to the next, for a source of some size."""
    if corners.origins == 1:
        return flux
    source = of_known_size(scene.source, scene.optic)
    blur = source.blur(scene.optic, far_field)
    sigma = [
        _SPREAD * width / math.sqrt(corners.origins) * pixels / (2 * half)
        for width, pixels, half in zip(blur, far_field.pixels, far_field.half_angle, strict=True)
    ]
    return np.asarray(gaussian_filter(flux, sigma[::-1], mode="constant"))


def _window(scene: Scene, heights: Mapping[str, Tensor]) -> FarField:
    """The angles that hold nearly all light."""
    window = FarField(kind="far_field", half_angle=(90.0, 90.0), pixels=(_LOOK, _LOOK))
    while True:
        plan = BeamPlan(_with_far_field(scene, window), Corners(_FEW, _FEW, _ORIGINS))
        with torch.no_grad():
            image = plan.trace(heights).flux.double().cpu().numpy()
        if not image.sum() > 0:
            raise Refused(
                "session",
                Said(
                    "no light leaves its {body}, so that it has no intensity",
                    body=Said(scene.optic.body_called),
                ),
            )
        image = _between_origins(scene, window, Corners(_FEW, _FEW, _ORIGINS), image)
        ends = [_ends(image.sum(axis=0)), _ends(image.sum(axis=1)[::-1])]
        found = [
            _about_the_axis(middle + half * low, middle + half * high)
            for middle, half, (low, high) in zip(
                window.center, window.half_angle, ends, strict=True
            )
        ]
        # A line of light is not drawn on pixels that are much narrower than long.
        least = max(width for _, width in found) / _LONGEST
        half = tuple(min(max(width, least), 90.0 - abs(middle)) for middle, width in found)
        narrower = window.altered(half_angle=half, center=tuple(middle for middle, _ in found))
        if any(new >= _FULL * old for new, old in zip(half, window.half_angle, strict=True)):
            return narrower
        window = narrower


def _ends(flux: Array) -> tuple[float, float]:
    """Where nearly all of it begins and ends along an axis from -1 to 1, with a rim."""
    part = np.cumsum(flux) / flux.sum()
    first = int(np.searchsorted(part, _BEYOND, side="right"))
    last = int(np.searchsorted(part, 1 - _BEYOND))
    low, high = 2 * first / len(flux) - 1, 2 * (min(last, len(flux) - 1) + 1) / len(flux) - 1
    rim = _RIM * (high - low)
    return low - rim, high + rim


def _about_the_axis(low: float, high: float) -> tuple[float, float]:
    """Middle and half-width of an interval, about 0 if it reaches about as far on both sides."""
    low, high = max(low, -90.0), min(high, 90.0)
    if low < 0 < high and max(-low, high) < _LOPSIDED * min(-low, high):
        low, high = -max(-low, high), max(-low, high)
    middle = (low + high) / 2
    return middle, min(max((high - low) / 2, _NARROWEST[0]), 90.0 - abs(middle))


def _cells(scene: Scene, window: FarField) -> tuple[int, int]:
    """Cells across the window, about square: as wide as a pixel of the receiver from the lens."""
    receiver = scene.receiver
    seen = (
        math.degrees(2 * extent / pixels / per_radian)
        for extent, pixels, per_radian in zip(
            receiver.half_extent,
            receiver.pixels,
            receiver.per_radian(scene.optic.leaving_z),
            strict=True,
        )
    )
    across = 2 * max(window.half_angle)
    cell = min(max(min(seen), across / _MOST_CELLS), across / _FEWEST_CELLS)
    n_h, n_v = (math.ceil(2 * half / max(cell, _NARROWEST[1])) for half in window.half_angle)
    return n_h, n_v


def _with_far_field(scene: Scene, far_field: FarField) -> Scene:
    """The same lens and source with another receiver."""
    image = scene.images[0].model_copy(update={"receiver": far_field})
    return scene.model_copy(update={"images": (image,), "regions": ()})


def _blocks(values: Array, size: int) -> Array:
    n_v, n_h = values.shape
    return np.asarray(values.reshape(n_v // size, size, n_h // size, size).sum(axis=(1, 3)))
