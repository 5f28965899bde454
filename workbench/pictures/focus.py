"""The image of a lens on screens at several distances, and how its error changes with them."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, BinaryIO

import numpy as np
from matplotlib.figure import Figure

from workbench.arrays import Array
from workbench.pictures.images import LIGHT, full_scale
from workbench.pictures.numbers import write_numbers
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

    from workbench.analysis.focus import Focus

_FONT = 8
_DPI = 150
_COLUMNS, _MOST = 6, 12  # images beside each other, and in all
_ERROR, _LIGHT, _SCREEN = "#2f86d1", "#d9822b", "#8a8f98"


def draw_focus(
    figure: "FigureBase",
    scene: Scene,
    target: Array,
    series: Sequence["Focus"],
) -> None:
    """Draw up to twelve of the images on one scale, and the curves below them."""
    chosen = np.unique(np.linspace(0, len(series) - 1, min(len(series), _MOST)).round().astype(int))
    rows = -(-chosen.size // _COLUMNS)
    columns = -(-chosen.size // rows)
    parts = figure.subfigures(2, 1, height_ratios=[rows, 1.5], squeeze=False)
    above, below = parts[:, 0]
    top = max(full_scale(scene, target, scene.receiver.total(one.irradiance)) for one in series)
    r_x, r_y = scene.receiver.half_extent
    panels = above.subplots(rows, columns, squeeze=False).ravel()
    for axes in panels:
        axes.set_axis_off()
    for axes, number in zip(panels, chosen, strict=False):
        found = series[number]
        axes.imshow(found.irradiance, LIGHT, vmin=0, vmax=top, extent=(-r_x, r_x, -r_y, r_y))
        axes.set_title(f"z = {found.z:.6g} {scene.unit}", fontsize=_FONT)
    _draw_curves(below.subplots(), scene, series)


def _draw_curves(axes: "Axes", scene: Scene, series: Sequence["Focus"]) -> None:
    z = [found.z for found in series]
    errors = [100 * found.relative_l2 for found in series]
    light = [100 * found.efficiency for found in series]
    axes.plot(z, errors, "o-", color=_ERROR, markersize=3, label="relative L2 error")
    axes.plot(z, light, "s--", color=_LIGHT, markersize=3, label="light on the screen")
    axes.axvline(scene.receiver.plane_z, color=_SCREEN, linestyle=":", linewidth=1, label="screen")
    axes.set_ylim(bottom=0)
    axes.set_xlabel(f"z of the screen ({scene.unit})", fontsize=_FONT)
    axes.set_ylabel("%", fontsize=_FONT)
    axes.tick_params(labelsize=_FONT)
    write_numbers(axes, "x")
    write_numbers(axes, "y")
    axes.grid(visible=True, linewidth=0.6, alpha=0.35)
    axes.legend(loc="best", fontsize=_FONT)


def write_focus(file: BinaryIO, scene: Scene, target: Array, series: Sequence["Focus"]) -> None:
    """Draw `draw_focus` as a PNG file.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    rows = -(-min(len(series), _MOST) // _COLUMNS)
    figure = Figure(figsize=(10, 1.9 * rows + 2.8), layout="constrained")
    draw_focus(figure, scene, target, series)
    figure.savefig(file, dpi=_DPI, format="png")
