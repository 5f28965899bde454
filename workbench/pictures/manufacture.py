"""Maps of thickness, slope and curvature, with areas beyond the limits hatched."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, BinaryIO, NamedTuple

import numpy as np
from matplotlib.colors import PowerNorm

from workbench.arrays import Array
from workbench.messages import capitalised
from workbench.pictures.axes import (
    UNSIGNED,
    Extent,
    colour_bar,
    constant_value,
    map_image,
    show_constant,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

    from workbench.analysis.manufacture import SurfaceMaps
    from workbench.analysis.shop_limits import Limits

_FONT = 9
_DPI = 150
_APART = {"wspace": 0.12, "hspace": 0.06}
_BEYOND = "#ff4d3d"  # viridis has no red


MAPS = ("Thickness", "Slope", "Concave curvature", "Convex curvature")
"""What can be shown of a face."""


class _Map(NamedTuple):
    values: Array
    unit: str
    low: float | None
    high: float | None
    in_words: str


def map_unit(name: str, unit: str) -> str:
    """Unit of a map's values for a unit of length."""
    return {"Thickness": unit, "Slope": "°"}.get(name, f"1 / {unit}")


def draw_map(axes: "Axes", name: str, maps: "SurfaceMaps", limits: "Limits", unit: str) -> Array:
    """Draw one of `MAPS` of a face and return its values (n_y, n_x)."""
    values, of, below, above, _ = _map(name, maps, limits, unit)
    half_width = float(maps.x.max()), float(maps.y.max())
    extent = Extent.around(half_width, unit)
    image = map_image(axes, name, extent, values.shape[::-1], UNSIGNED[1])
    image.set_data(values)
    # Sharp bends are few and far above the others.
    image.set_norm(PowerNorm(0.5 if "Curvature" in name else 1.0))
    size = {"Thickness": max(half_width), "Slope": 1.0}.get(name, 1 / max(half_width))
    value, of = constant_value(values, size), "degrees" if of == "°" else of
    if value is not None:
        show_constant(image, value, of)
        values = np.where(np.isnan(values), np.nan, value)
    else:
        image.set_clim(float(np.nanmin(values)), float(np.nanmax(values)))
        colour_bar(axes, image, of, "neither")
    if below is not None and (values < below).any():
        _hatch(axes, maps, values, [float(np.nanmin(values)) - 1, below])
    if above is not None and (values > above).any():
        _hatch(axes, maps, values, [above, float(np.nanmax(values)) + 1])
    return values


def draw_manufacture(
    figure: "FigureBase", maps: "SurfaceMaps", limits: "Limits", unit: str
) -> None:
    """Draw thickness, slope and both curvatures of a face on an empty figure."""
    for axes, name in zip(figure.subplots(2, 2, gridspec_kw=_APART).ravel(), MAPS, strict=True):
        draw_map(axes, name, maps, limits, unit)
        axes.set_title(f"{name}{_map(name, maps, limits, unit).in_words}", fontsize=_FONT)


def write_manufacture(
    file: BinaryIO, faces: Mapping[str, "SurfaceMaps"], limits: "Limits", unit: str
) -> None:
    """Write `draw_manufacture` of each named face as PNG; raise OSError if that fails."""
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    layout = ConstrainedLayoutEngine(w_pad=0.15)
    figure = Figure(figsize=(11, 9 * len(faces)), layout=layout)
    parts = figure.subfigures(len(faces), squeeze=False).ravel()
    for part, (name, maps) in zip(parts, faces.items(), strict=True):
        draw_manufacture(part, maps, limits, unit)
        if len(faces) > 1:
            part.suptitle(capitalised(name))
    figure.savefig(file, dpi=_DPI, format="png")


def _map(name: str, maps: "SurfaceMaps", limits: "Limits", unit: str) -> _Map:
    of = map_unit(name, unit)
    if name == "Thickness":
        low, high = limits.min_thickness, limits.max_thickness
        in_words = _in_words("at least", low, f" {unit}") + _in_words("at most", high, f" {unit}")
        return _Map(maps.thickness, of, low, high, in_words)
    if name == "Slope":
        steep = limits.max_slope
        return _Map(maps.slope, of, None, steep, _in_words("at most", steep, "°"))
    radius = limits.min_radius
    curvature = None if radius is None else 1 / radius
    values = maps.concave if name == "Concave curvature" else maps.convex
    return _Map(
        values.clip(0), of, None, curvature, _in_words("radius at least", radius, f" {unit}")
    )


def _hatch(axes: "Axes", maps: "SurfaceMaps", values: Array, between: list[float]) -> None:
    hatched = axes.contourf(maps.x, maps.y, values, levels=between, colors="none", hatches=["////"])
    hatched.set_edgecolor(_BEYOND)
    hatched.set_linewidth(1.0)


def _in_words(word: str, limit: float | None, unit: str) -> str:
    return "" if limit is None else f", {word} {limit:g}{unit}"
