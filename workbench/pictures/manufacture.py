"""Maps of thickness, slope and curvature, and of the areas within and beyond all limits."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, BinaryIO, NamedTuple

import numpy as np
from matplotlib.colors import ListedColormap, PowerNorm
from matplotlib.patches import Patch

from workbench.analysis.manufacture import exceeded
from workbench.arrays import Array, Mask
from workbench.messages import capitalised
from workbench.pictures.axes import (
    BEYOND,
    FONT,
    UNSIGNED,
    WITHIN,
    Extent,
    colour_bar,
    constant_value,
    map_image,
    show_constant,
)
from workbench.powers import written

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

    from workbench.analysis.manufacture import SurfaceMaps
    from workbench.analysis.shop_limits import Limits

_FONT = 9
_DPI = 150
_APART = {"wspace": 0.12, "hspace": 0.06}
_HATCH = "#ff4d3d"  # viridis has no red


_LIMITS = "Limits"
_QUANTITIES = ("Thickness", "Slope", "Concave curvature", "Convex curvature")
MAPS = (*_QUANTITIES, _LIMITS)
"""What can be shown of a face."""
LEGEND = ("Within limits", "No limit is set", "Ball cutter")
"""What the legend of the map of limits names beside quantities."""


class _Map(NamedTuple):
    values: Array
    unit: str
    in_words: str


def map_unit(name: str, unit: str) -> str:
    """Unit of a map's values for a unit of length; none for the map that counts limits."""
    return {_LIMITS: "", "Thickness": unit, "Slope": "°"}.get(name, f"1 / {unit}")


def draw_map(axes: "Axes", name: str, maps: "SurfaceMaps", limits: "Limits", unit: str) -> Array:
    """Draw one of `MAPS` of a face and return its values (n_y, n_x)."""
    broken = exceeded(maps, limits)
    half_width = float(maps.x.max()), float(maps.y.max())
    extent = Extent.around(half_width, unit)
    if name == _LIMITS:
        return _draw_limits(axes, extent, maps, broken)
    values, of, _ = _map(name, maps, limits, unit)
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
    _hatch(axes, maps, broken.get(name.lower()), _HATCH)
    return values


def _draw_limits(
    axes: "Axes", extent: Extent, maps: "SurfaceMaps", broken: Mapping[str, Mask]
) -> Array:
    beside = np.where(np.isnan(maps.slope), np.nan, 0.0)
    count = np.add.reduce([mask.astype(float) for mask in broken.values()]) + beside
    image = map_image(axes, _LIMITS, extent, count.shape[::-1], ListedColormap([WITHIN, BEYOND]))
    image.set_data(count.clip(0, 1))
    image.set_clim(0, 1)
    _hatch(axes, maps, count > 0, WITHIN)
    whole = np.isfinite(count)
    inside = "Within limits" if broken else "No limit is set"
    areas = {inside: count == 0, **{capitalised(key): mask & whole for key, mask in broken.items()}}
    seen = {name: 100 * mask.sum() / whole.sum() for name, mask in areas.items() if mask.any()}
    shown = [Patch(facecolor=WITHIN if name == inside else BEYOND) for name in seen]
    axes.legend(
        shown, [f"{name} ({written(part, '%', 2)})" for name, part in seen.items()], fontsize=FONT
    )
    return np.asarray(count)


def draw_manufacture(
    figure: "FigureBase", maps: "SurfaceMaps", limits: "Limits", unit: str
) -> None:
    """Draw thickness, slope and both curvatures of a face on an empty figure."""
    slots = figure.subplots(2, 2, gridspec_kw=_APART).ravel()
    for axes, name in zip(slots, _QUANTITIES, strict=True):
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
        return _Map(maps.thickness, of, in_words)
    if name == "Slope":
        steep = limits.max_slope
        return _Map(maps.slope, of, _in_words("at most", steep, "°"))
    values, radius = maps.concave if name == "Concave curvature" else maps.convex, limits.min_radius
    return _Map(values.clip(0), of, _in_words("radius at least", radius, f" {unit}"))


def _hatch(axes: "Axes", maps: "SurfaceMaps", places: Mask | None, colour: str) -> None:
    if places is not None and places.any():
        hatched = axes.contourf(
            maps.x, maps.y, 1.0 * places, levels=[0.5, 1.5], colors="none", hatches=["////"]
        )
        hatched.set_edgecolor(colour)
        hatched.set_linewidth(1.0)


def _in_words(word: str, limit: float | None, unit: str) -> str:
    return "" if limit is None else f", {word} {limit:g}{unit}"
