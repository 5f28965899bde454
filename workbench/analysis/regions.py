"""Light of regions of a receiver: how much there is, and how even it is."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from functools import lru_cache
from typing import Any

from workbench.arrays import Array
from workbench.measured.lamps import IN_PARTS, LightUnit
from workbench.said import Said
from workbench.scene import AnyReceiver, AnyRegion
from workbench.targets.raster import coverage

# A pixel that is less inside than this says more of what is beside the region.
_INSIDE = 0.5


@dataclass(frozen=True)
class RegionLight:
    """The light of a region. All but the share are None where no pixel is half inside."""

    name: str  # of the region
    # Part of the emitted flux that falls on it; of pixels at its edge, the part inside counts.
    share: float
    mean: float  # flux per area, or per solid angle in a far field, over all of the region
    # The same of the darkest and the brightest pixel of which at least half is inside.
    least: float | None
    most: float | None
    unit: LightUnit = field(default=IN_PARTS, repr=False)  # in what it is told

    @property
    def uniformity(self) -> float | None:
        """Least over mean (U₀ of EN 12464-1); None without a pixel inside or without light."""
        if self.least is None or not self.mean:
            return None
        return self.least / self.mean

    @property
    def words(self) -> Said:
        """How much light it gets, and how even that is."""
        part, even = 100 * self.share, "–" if self.uniformity is None else f"{self.uniformity:.3f}"
        if self.least is None or self.most is None or not self.mean:
            return Said("{part:.3f} % of the light, least / mean {even}", part=part, even=even)
        if self.unit.lumens is None:
            return Said(
                "{part:.3f} % of the light, least / mean {even}, most / mean {most:.3f}",
                part=part,
                even=even,
                most=self.most / self.mean,
            )
        mean, least, most = map(self.unit.density_in_words, (self.mean, self.least, self.most))
        return Said(
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
    """The light of each region.

    `regions`: parts of the receiver; they may overlap; `receiver`: pixel raster; `irradiance` (n_y,
    n_x): flux per area, or per solid angle, of a source whose flux is 1; row 0 at +y; `unit`: in
    what they tell their light; by default as parts of all.

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


@lru_cache(maxsize=64)  # a run shows image after image
def _inside(region: AnyRegion, receiver: AnyReceiver) -> Array:
    """The part of each pixel that is in a region, shape (n_y, n_x)."""
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
