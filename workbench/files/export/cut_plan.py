"""Cuts of a face, and whether the cutter fits."""

from typing import NamedTuple

from workbench.errors import Refused
from workbench.files.export.cutting import Cutting
from workbench.geometry.ball_cutter import CutErrors, Raster
from workbench.powers import written
from workbench.said import Said

# Times the height of ridges that may be left, and be cut off: a cutter that fits does better.
_LEFT, _OFF = 2.0, 0.25


class CutPlan(NamedTuple):
    """Cuts of a face, as a program has them, and what they leave.

    Attributes
    ----------
    cutting : Cutting
        What was asked for.
    raster : Raster
        The cuts, scene units.
    scallop : float
        Height of ridges that was planned.
    remains : CutErrors
        What the simulated cut leaves, with the place in the scene's x and y.
    top : float
        Highest control height of the face as it lies below the cutter.
    default_radius : float
        Radius of a ball that fits everywhere, scene units; infinite if none is known, as for a
        face with edges.
    """

    cutting: Cutting
    raster: Raster
    scallop: float
    remains: CutErrors
    top: float
    default_radius: float

    def refusal(self, unit: str) -> Refused | None:
        """Why this is not written: the cutter leaves more than ridges. None if it fits.

        Parameters
        ----------
        unit : str
            The scene's unit of length.
        """
        cut_off, left, (x, y) = self.remains
        if cut_off <= _OFF * self.scallop and left <= _LEFT * self.scallop:
            return None
        return Refused(
            "tool_radius",
            Said(
                "a ball cutter of {radius} does not fit: it leaves {left} at x = {x}, y = {y} and "
                "cuts off {cut}; {cure}",
                radius=written(self.raster.radius, unit),
                left=written(left, unit, 2),
                x=written(x, unit),
                y=written(y, unit),
                cut=written(max(cut_off, 0), unit, 2),
                cure=self._cure(unit),
            ),
        )

    def _cure(self, unit: str) -> Said:
        if self.default_radius < self.raster.radius:
            return Said("one of {fitting} fits", fitting=written(self.default_radius, unit, 2))
        return Said("a smaller one or higher ridges are needed")
