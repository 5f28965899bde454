"""Flux and uniformity of regions of a receiver."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from functools import lru_cache
from typing import Any

from workbench.arrays import Array
from workbench.measured.lamps import IN_PARTS, LightUnit
from workbench.messages import Message
from workbench.scene import AnyReceiver, AnyRegion
from workbench.targets.raster import coverage

_INSIDE = 0.5  # least part of a pixel inside a region for its extremes


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
        """Least over mean (U₀ of EN 12464-1); None without pixels or light inside."""
        if self.least is None or not self.mean:
            return None
        return self.least / self.mean

    @property
    def words(self) -> Message:
        """Flux and uniformity in words."""
        part, even = 100 * self.share, "–" if self.uniformity is None else f"{self.uniformity:.3f}"
        if self.least is None or self.most is None or not self.mean:
            return Message("{part:.3f} % of the light, least / mean {even}", part=part, even=even)
        if self.unit.lumens is None:
            return Message(
                "{part:.3f} % of the light, least / mean {even}, most / mean {most:.3f}",
                part=part,
                even=even,
                most=self.most / self.mean,
            )
        mean, least, most = map(self.unit.density_in_words, (self.mean, self.least, self.most))
        return Message(
            "{part:.3f} % of the light, {lumens}, mean {mean}, least {least}, most {most}, "
            "least / mean {even}",
            part=part,
            lumens=self.unit.flux_in_words(self.share),
            mean=mean,
            least=least,
            most=most,
            even=even,
        )

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        figures = asdict(self) | {"uniformity": self.uniformity}
        del figures["unit"]
        return figures


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
