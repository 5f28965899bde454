"""Residuals of measured parts, and their light beside that of the design."""

from collections.abc import Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, BinaryIO

import numpy as np

from workbench.analysis.inspection.inspection import AS_DESIGNED
from workbench.arrays import Array
from workbench.messages import Message
from workbench.pictures.axes import SIGNED, Extent, colour_bar, map_image
from workbench.pictures.images import ErrorImage, IrradianceImage

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from workbench.analysis.inspection.inspection import Inspection
    from workbench.analysis.validation_figures import Validation

_FONT, _DPI = 9, 150
_RESIDUALS = Message("residual as measured"), Message("resolved residual")
_REPEATS = Message("repeats")
_SHOWN = 99.8  # percent of the values within the scale: a spike at the rim must not hide the rest


def write_inspection(
    file: BinaryIO, found: "Inspection", target: Array, lights: Sequence["Validation"]
) -> None:
    """Write residuals, and irradiance and error of the lights of `Inspection.lenses`, as PNG."""
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    layout = ConstrainedLayoutEngine(w_pad=0.15, h_pad=0.1)
    figure = Figure(figsize=(15, 3.1 * (len(found.parts) + 1)), layout=layout)
    draw_inspection(figure, found, target, lights)
    figure.savefig(file, dpi=_DPI, format="png")


def draw_inspection(
    figure: "Figure", found: "Inspection", target: Array, lights: Sequence["Validation"]
) -> None:
    """Draw residuals, and irradiance and error of the lights of `Inspection.lenses`."""
    panels = figure.subplots(len(found.parts) + 1, 4, squeeze=False)
    maps = [part.residual.map() for part in found.parts]
    measured = np.concatenate([each.ravel() for each, _ in maps])
    top = float(np.nanpercentile(np.abs(measured), _SHOWN)) / found.micrometre
    panels[0, 0].set_axis_off()
    _draw(panels[0, 1], found, _repeating(found, maps[0][1]), top)
    panels[0, 1].set_title(_REPEATS, fontsize=_FONT)
    for row, (part, each) in enumerate(zip(found.parts, maps, strict=True), start=1):
        for axes, values, name in zip(panels[row], each, _RESIDUALS, strict=False):
            _draw(axes, found, values, top)
            axes.set_title(f"{PurePath(part.name).name}: {name}", fontsize=_FONT)
    scene = found.scene.wanted(target)[0].scene
    names = AS_DESIGNED, *(PurePath(part.name).name for part in found.parts)
    for row, (lens, light) in enumerate(zip(names, lights, strict=False)):
        irradiance = (light.by_cells or light).irradiance
        lit, off = panels[row, 2:]
        IrradianceImage(lit, scene, target).update(irradiance)
        ErrorImage(off, scene, target).update(irradiance)
        error = 100 * light.verified.relative_l2_corrected
        lit.set_title(f"{lens}: {scene.receiver.density}", fontsize=_FONT)
        off.set_title(f"error (relative L2 {error:.3g} %)", fontsize=_FONT)


def _repeating(found: "Inspection", resolved: Array) -> Array:
    """Map of what repeats, where the resolved residual of a part has values."""
    places = ((np.arange(count) + 0.5) / count for count in resolved.shape[::-1])
    values = found.face.net.grid(*places).evaluate(found.repeating)[0][:, ::-1].T
    return np.where(np.isnan(resolved), np.nan, values)


def _draw(axes: "Axes", found: "Inspection", values: Array, top: float) -> None:
    extent = Extent.around(found.face.net.half_width, found.scene.unit)
    image = map_image(axes, "residual", extent, values.shape[::-1], SIGNED)
    image.set_data(values / found.micrometre)
    image.set_clim(-top, top)
    colour_bar(axes, image, "µm", "both")
