"""Maps of what a shop asks of a lens, with what is beyond its limits hatched."""

from typing import TYPE_CHECKING, BinaryIO, Protocol

import numpy as np
import numpy.typing as npt
from matplotlib.colors import PowerNorm

from workbench.pictures.maps import UNSIGNED, colour_bar, map_image

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

Array = npt.NDArray[np.float64]

_FONT = 9
_DPI = 150
_APART = {"wspace": 0.12, "hspace": 0.06}
_BEYOND = "#ff4d3d"  # viridis has no red


class FaceMaps(Protocol):
    """The exit face point by point: `workbench.analysis.manufacture.SurfaceMaps`."""

    @property
    def x(self) -> Array:
        """Shape (n_x,), ascending."""

    @property
    def y(self) -> Array:
        """Shape (n_y,), descending."""

    @property
    def thickness(self) -> Array:
        """Shape (n_y, n_x), as those below."""

    @property
    def slope(self) -> Array:
        """Degrees."""

    @property
    def concave(self) -> Array:
        """Largest curvature of hollows."""

    @property
    def convex(self) -> Array:
        """Largest curvature of humps."""


class ShopLimits(Protocol):
    """What a shop asks for: `workbench.analysis.manufacture_limits.Limits`."""

    @property
    def min_thickness(self) -> float | None:
        """Scene units."""

    @property
    def max_thickness(self) -> float | None:
        """Scene units."""

    @property
    def max_slope(self) -> float | None:
        """Degrees."""

    @property
    def min_radius(self) -> float | None:
        """Scene units."""


def draw_manufacture(figure: "FigureBase", maps: FaceMaps, limits: ShopLimits, unit: str) -> None:
    """Draw thickness, slope and both curvatures of a lens.

    Parameters
    ----------
    figure : matplotlib.figure.FigureBase
        Empty figure, or an empty part of one.
    maps : FaceMaps
        The exit face point by point.
    limits : ShopLimits
        Places beyond them are hatched.
    unit : str
        The scene's unit of length.
    """
    low, high, steep, radius = (
        limits.min_thickness,
        limits.max_thickness,
        limits.max_slope,
        limits.min_radius,
    )
    bent = None if radius is None else 1 / radius
    tool = _told("radius at least", radius, f" {unit}")
    thickness = _told("at least", low, f" {unit}") + _told("at most", high, f" {unit}")
    panels = (
        (maps.thickness, "Thickness", unit, low, high, thickness),
        (maps.slope, "Slope", "°", None, steep, _told("at most", steep, "°")),
        (maps.concave.clip(0), "Curvature of hollows", f"1 / {unit}", None, bent, tool),
        (maps.convex.clip(0), "Curvature of humps", f"1 / {unit}", None, bent, tool),
    )
    for axes, (values, name, of, below, above, told) in zip(
        figure.subplots(2, 2, gridspec_kw=_APART).ravel(), panels, strict=True
    ):
        half_width = float(maps.x.max()), float(maps.y.max())
        image = map_image(axes, name, half_width, values.shape[::-1], unit, UNSIGNED[1])
        image.set_data(values)
        # Sharp bends are few and far above the others.
        image.set_norm(PowerNorm(0.5 if "Curvature" in name else 1.0))
        image.set_clim(float(values.min()), float(values.max()) or 1.0)
        colour_bar(axes, image, of, "neither")
        axes.set_title(f"{name}{told}", fontsize=_FONT)
        if below is not None and (values < below).any():
            _hatch(axes, maps, values, [float(values.min()) - 1, below])
        if above is not None and (values > above).any():
            _hatch(axes, maps, values, [above, float(values.max()) + 1])


def write_manufacture(file: BinaryIO, maps: FaceMaps, limits: ShopLimits, unit: str) -> None:
    """Draw `draw_manufacture` as a PNG file.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    layout = ConstrainedLayoutEngine(w_pad=0.15)
    figure = Figure(figsize=(11, 9), layout=layout)
    draw_manufacture(figure, maps, limits, unit)
    figure.savefig(file, dpi=_DPI, format="png")


def _hatch(axes: "Axes", maps: FaceMaps, values: Array, between: list[float]) -> None:
    hatched = axes.contourf(maps.x, maps.y, values, levels=between, colors="none", hatches=["////"])
    hatched.set_edgecolor(_BEYOND)
    hatched.set_linewidth(1.0)


def _told(word: str, limit: float | None, unit: str) -> str:
    return "" if limit is None else f", {word} {limit:g}{unit}"
