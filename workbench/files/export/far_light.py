"""Intensity of the light that leaves a designed lens, by a beam mesh, without ray noise.

The intensity is computed on a fine grid of H and V, the angles of a far field, around all
directions of the light. It is computed twice, the second time with finer beams from more points of
the source: the difference is the uncertainty.
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
from workbench.messages import Message
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners
from workbench.scene import FarField, Scene

# Cells along an axis, source points and pixels of the first images, which locate the light.
_FEW, _ORIGINS, _FIRST_PIXELS = 256, 16, 512
# Relative flux beyond each side of the window.
_BEYOND = 1e-5
# Least half-width of the window and of a cell, degrees; rim of the window over its half-width; part
# of a window that light must fill for the window to be final.
_NARROWEST, _RIM, _FULL = (0.01, 0.001), 0.02, 0.4
# The window is centred on the axis if the extents on both sides differ by less than this factor.
_ASYMMETRY = 2.0
# Least and largest width of a cell in pixels of the fine grid; sufficient pixels along an axis.
_FINER, _ENOUGH_PIXELS = (6, 16), 1024
# Largest aspect ratio of the window.
_LONGEST = 16.0
# Least and most cells across the window.
_FEWEST_CELLS, _MOST_CELLS = 48, 512
# Standard deviation of the blur of a source point, over the distance of source points.
_SPREAD = 0.5
# Factor of refinement of beams along each axis and in source points, most beams, and the difference
# of two images at which refinement ends.
_MORE, _MOST_BEAMS, _AGREE = math.sqrt(2), 1 << 24, 2e-3


@dataclass(frozen=True, eq=False)
class FarLight:
    """Intensity of the light that leaves a lens.

    Directions are those of a lamp file: the nadir is the direction of the light, and a direction is
    (cos V sin H, sin V, cos V cos H) with C0 at H > 0 and C90 at V < 0.
    """

    # (n_h,), (n_v,), middles of the pixels in degrees, ascending, in equal steps.
    h: Array
    v: Array
    intensity: Array  # (n_v, n_h), mean in each pixel, flux per solid angle, for a source of flux 1
    finer: int  # pixels along each axis of a cell: errors are measured on means over cells
    uncertainty: float  # relative L2 difference of the intensity in cells to that of coarser beams
    flux: float  # all light that leaves the lens
    origins: int  # number of points that stand for an extended source

    @property
    def cell(self) -> float:
        """Width of a cell, degrees: the larger one of both axes."""
        return self.finer * float(max(self.h[1] - self.h[0], self.v[1] - self.v[0]))

    @property
    def row_measure(self) -> Array:
        """Solid angle of a pixel in each row (n_v,), up to a factor."""
        return np.asarray(np.cos(np.radians(self.v)))

    def directions(self, row: Index | slice = slice(None)) -> Array:
        """Unit vectors (rows, n_h, 3) to the middles of all pixels of some rows."""
        return directions_of(*np.meshgrid(self.h, self.v[row]))

    def in_cells(self, values: Array) -> Array:
        """Mean of pixel values over the solid angle of each cell, times its square root.

        The root of the sum of squares of the result is an L2 norm over the solid angle.
        """
        weight = self.row_measure[:, None]
        measure = _blocks(np.broadcast_to(weight, values.shape), self.finer)
        return _blocks(values * weight, self.finer) / np.sqrt(measure)


def directions_of(h: Array, v: Array) -> Array:
    """Unit vectors (..., 3) of angles H and V in degrees; see `FarLight`."""
    h, v = np.radians(h), np.radians(v)
    return np.stack([np.cos(v) * np.sin(h), np.sin(v), np.cos(v) * np.cos(h)], axis=-1)


def far_light(design: Design) -> FarLight:
    """Return the intensity of the light that leaves a lens; raise Refused if there is none."""
    scene = design.scene
    scene.check_no_diffuser("a file of intensities")
    heights = {
        face: torch.as_tensor(np.array(each, dtype=np.float64))
        for face, each in design.result.state.heights.items()
    }
    window = _window(scene, heights)
    cells = _cells(scene, window)
    finer = int(np.clip(_ENOUGH_PIXELS // max(cells), *_FINER))
    fine = window.altered(pixels=(finer * cells[0], finer * cells[1]))
    corners = cells_of(JUDGED, _with_far_field(scene, window.altered(pixels=cells)))
    light = _compute(scene, fine, _denser(corners, 1 / _MORE), finer, heights)
    while light.uncertainty > _AGREE:
        if math.prod(corners[:3]) > _MOST_BEAMS and math.isfinite(light.uncertainty):
            break
        last, light = light, _compute(scene, fine, corners, finer, heights)
        change = light.in_cells(light.intensity - last.intensity)
        off = float(np.linalg.norm(change) / np.linalg.norm(light.in_cells(light.intensity)))
        light, corners = replace(light, uncertainty=off), _denser(corners, _MORE)
    return light


def _denser(corners: Corners, factor: float) -> Corners:
    origins = max(round(corners.origins * factor**2), 1) if corners.origins > 1 else 1
    return Corners(round(corners.x * factor), round(corners.y * factor), origins)


def _compute(
    scene: Scene, far_field: FarField, corners: Corners, finer: int, heights: Mapping[str, Tensor]
) -> FarLight:
    plan = BeamPlan(_with_far_field(scene, far_field), corners)
    with torch.no_grad():
        light = plan.trace(heights)
    image = _blurred_by_origins(scene, far_field, corners, light.flux.double().cpu().numpy())
    image /= far_field.pixel_measure
    # From behind a mirror, V counts in the other direction.
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


def _blurred_by_origins(scene: Scene, far_field: FarField, corners: Corners, flux: Array) -> Array:
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
    window = FarField(
        kind="far_field", half_angle=(90.0, 90.0), pixels=(_FIRST_PIXELS, _FIRST_PIXELS)
    )
    while True:
        plan = BeamPlan(_with_far_field(scene, window), Corners(_FEW, _FEW, _ORIGINS))
        with torch.no_grad():
            image = plan.trace(heights).flux.double().cpu().numpy()
        if not image.sum() > 0:
            raise Refused(
                "session",
                Message(
                    "no light leaves its {body}, so that it has no intensity",
                    body=Message(scene.optic.body_called),
                ),
            )
        image = _blurred_by_origins(scene, window, Corners(_FEW, _FEW, _ORIGINS), image)
        ends = [_ends(image.sum(axis=0)), _ends(image.sum(axis=1)[::-1])]
        found = [
            _about_the_axis(middle + half * low, middle + half * high)
            for middle, half, (low, high) in zip(
                window.center, window.half_angle, ends, strict=True
            )
        ]
        # A line of light needs pixels that are not much narrower than long.
        least = max(width for _, width in found) / _LONGEST
        half = tuple(min(max(width, least), 90.0 - abs(middle)) for middle, width in found)
        narrower = window.altered(half_angle=half, center=tuple(middle for middle, _ in found))
        if any(new >= _FULL * old for new, old in zip(half, window.half_angle, strict=True)):
            return narrower
        window = narrower


def _ends(flux: Array) -> tuple[float, float]:
    part = np.cumsum(flux) / flux.sum()
    first = int(np.searchsorted(part, _BEYOND, side="right"))
    last = int(np.searchsorted(part, 1 - _BEYOND))
    low, high = 2 * first / len(flux) - 1, 2 * (min(last, len(flux) - 1) + 1) / len(flux) - 1
    rim = _RIM * (high - low)
    return low - rim, high + rim


def _about_the_axis(low: float, high: float) -> tuple[float, float]:
    low, high = max(low, -90.0), min(high, 90.0)
    if low < 0 < high and max(-low, high) < _ASYMMETRY * min(-low, high):
        low, high = -max(-low, high), max(-low, high)
    middle = (low + high) / 2
    return middle, min(max((high - low) / 2, _NARROWEST[0]), 90.0 - abs(middle))


def _cells(scene: Scene, window: FarField) -> tuple[int, int]:
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
