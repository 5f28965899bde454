"""What is stated of a measurement of a made part, with titles, tips and units."""

import math
from dataclasses import dataclass
from typing import ClassVar

from workbench.measured.surfaces import UNITS, PictureScale
from workbench.option_groups import OptionGroup, option

_UNITS = {unit: unit for unit in UNITS}


@dataclass(frozen=True)
class InspectionOptions(OptionGroup):
    """Units of a measurement, and the scale of pictures of heights."""

    called: ClassVar[str] = "a measurement"

    unit: str | None = option(
        "Unit",
        "Unit of the measurements. Empty: that of the file, or else of the scene.",
        kind=str,
        choices=_UNITS,
        empty="of file or scene",
    )
    z_unit: str | None = option(
        "Unit of heights",
        "Unit of their heights. Empty: that of their lengths.",
        kind=str,
        choices=_UNITS,
        empty="as lengths",
    )
    scale: bool = option(
        "Determine a scale", "Determine a scale (shrinkage), too.", False, kind=bool
    )
    pixel: float | None = option(
        "Pixel",
        "Of pictures: side of a pixel. Empty: of the file.",
        above=True,
        empty="of the file",
    )
    black: float = option("Black", "Of pictures: height of black.", 0.0, least=-math.inf)
    white: float = option("White", "Of pictures: height of white.", 1.0, least=-math.inf)

    @property
    def pictures(self) -> PictureScale | None:
        """Scale of pictures; None for that of the file."""
        return None if self.pixel is None else PictureScale(self.pixel, self.black, self.white)
