"""Flux and uniformity of regions of a receiver."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np
from scipy.ndimage import binary_erosion
from scipy.spatial import ConvexHull

from workbench.analysis.metrics import lit, lit_light
from workbench.arrays import Array, Mask
from workbench.measured.lamps import IN_PARTS, LightUnit, light_unit
from workbench.messages import Message
from workbench.scene import AnyReceiver, AnyRegion, Scene
from workbench.targets.raster import coverage

_INSIDE = 0.5  # least part of a pixel inside a region for its extremes
# A lit area is even if its target deviates by less, and one piece without holes or bays if its
# pixels are such a part of their convex hull: a disc in pixels has 0.98, a letter less than 0.7.
_EVEN, _CONVEX = 0.05, 0.95
_NONE = "–"


@dataclass(frozen=True)
class RegionLight:
    """Light of a region; the extremes are None if no pixel is half inside."""

    name: str  # of the region
    share: float  # part of the emitted flux
    mean: float  # flux per area, or per solid angle in a far field
    # Of the darkest and the brightest pixel with at least half inside.
    least: float | None
    most: float | None
    unit: LightUnit = field(default=IN_PARTS, repr=False)

    @property
    def uniformity(self) -> float | None:
        """Minimum over average, U₀; None without pixels or light inside."""
        return self.least / self.mean if self.least is not None and self.mean else None

    @property
    def least_over_most(self) -> float | None:
        """Minimum over maximum, U₁; None without pixels or light inside."""
        return self.least / self.most if self.least is not None and self.most else None

    @property
    def figures(self) -> dict[str, str]:
        """Figures by their English names; extremes as multiples of the average without lumens."""
        even, ends = self.uniformity, self.least_over_most
        part, flux = f"{100 * self.share:.2f} %", self.unit.flux_in_words(self.share)
        return {
            Message("part of the light"): f"{part} ({flux})" if flux else part,
            Message("average"): self.unit.density_in_words(self.mean),
            Message("minimum"): self._extreme(self.least),
            Message("maximum"): self._extreme(self.most),
            Message("U₀ (minimum / average)"): _NONE if even is None else f"{even:.3f}",
            Message("U₁ (minimum / maximum)"): _NONE if ends is None else f"{ends:.3f}",
        }

    def _extreme(self, density: float | None) -> str:
        if density is None or not self.mean:
            return _NONE
        if self.unit.lumens is None:
            return Message("{times:.3f} × average", times=density / self.mean)
        return self.unit.density_in_words(density)

    @property
    def words(self) -> Message:
        """All figures in one line."""
        part, average, least, most, even, ends = self.figures.values()
        return Message(
            "{part} of the light, average {average}, minimum {least}, maximum {most}, U₀ {even}, "
            "U₁ {ends}",
            part=part,
            average=average,
            least=least,
            most=most,
            even=even,
            ends=ends,
        )

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        figures = asdict(self) | {
            "uniformity": self.uniformity,
            "least_over_most": self.least_over_most,
        }
        del figures["unit"]
        return figures


def light_of_areas(scene: Scene, target: Array, irradiance: Array) -> tuple[RegionLight, ...]:
    """Return the light of the target's lit area, where that is even, and of each region."""
    area, unit = light_of_lit_area(scene, target, irradiance), light_unit(scene)
    regions = light_of_regions(scene.regions, scene.receiver, irradiance, unit)
    return regions if area is None else (area, *regions)


def light_of_lit_area(scene: Scene, target: Array, irradiance: Array) -> RegionLight | None:
    """Return the light where a target is lit; None unless that is one even area."""
    area = even_area(target)
    if area is None:
        return None
    least, mean, most = lit_light(irradiance, target)
    name = Message("whole receiver") if area.all() else Message("lit area of the target")
    share = scene.receiver.total(irradiance * area)
    return RegionLight(name, share, mean, least, most, light_unit(scene))


def even_area(target: Array) -> Mask | None:
    """Return where a target is lit, if that is one even area without holes or bays."""
    area = lit(target)
    # Pixels at its edge may be lit in part.
    within = binary_erosion(area, border_value=True)
    inside = target[within if within.any() else area]
    if inside.std() > _EVEN * inside.mean():
        return None
    rows = np.flatnonzero(area.any(axis=1))
    first = area[rows].argmax(axis=1)
    behind = area.shape[1] - area[rows, ::-1].argmax(axis=1)
    ends = [(row, column) for row in (rows, rows + 1) for column in (first, behind)]
    corners = np.concatenate([np.column_stack(end) for end in ends])
    return area if area.sum() >= _CONVEX * ConvexHull(corners).volume else None


def light_of_regions(
    regions: Sequence[AnyRegion],
    receiver: AnyReceiver,
    irradiance: Array,
    unit: LightUnit = IN_PARTS,
) -> tuple[RegionLight, ...]:
    """Return the light of each region; regions may overlap.

    `irradiance` (n_y, n_x): flux per area, or per solid angle, for a source of flux 1, row 0 at +y.

    Examples
    --------
    >>> import numpy as np
    >>> from workbench.scene import RectangleRegion, Screen
    >>> screen = Screen(position=(0, 0, 5), half_width=(1, 1), pixels=(4, 4))
    >>> even = np.full((4, 4), 0.25)
    >>> light_of_regions([RectangleRegion(name="Desk", size=(0.5, 0.5))], screen, even)
    (RegionLight(name='Desk', share=0.25, mean=0.25, least=0.25, most=0.25),)
    """
    return tuple(_light_of(region, receiver, irradiance, unit) for region in regions)


@lru_cache(maxsize=64)  # a run evaluates image after image
def _inside(region: AnyRegion, receiver: AnyReceiver) -> Array:
    """Part of each pixel (n_y, n_x) that is in a region."""
    return coverage(2 * region.outline * receiver.half_extent, receiver)


def _light_of(
    region: AnyRegion, receiver: AnyReceiver, irradiance: Array, unit: LightUnit
) -> RegionLight:
    inside = _inside(region, receiver)
    share = receiver.total(irradiance * inside)
    within = irradiance[inside >= _INSIDE]
    return RegionLight(
        region.name,
        share,
        share / receiver.total(inside),
        float(within.min()) if within.size else None,
        float(within.max()) if within.size else None,
        unit,
    )
