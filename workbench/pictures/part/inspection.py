"""Residuals of measured parts, and their light beside that of the design."""

from collections.abc import Mapping
from pathlib import PurePath
from typing import TYPE_CHECKING, BinaryIO

import numpy as np

from workbench.arrays import Array
from workbench.pictures.axes import SIGNED, Extent, colour_bar, map_image
from workbench.pictures.images import ErrorImage, IrradianceImage

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from workbench.analysis.inspection.inspection import Inspection
    from workbench.analysis.validation_figures import Validation

_FONT, _DPI = 9, 150
_SHOWN = 99.8  # percent of the values within the scale: a spike at the rim must not hide the rest


def write_inspection(
    file: BinaryIO, found: "Inspection", target: Array, lights: Mapping[str, "Validation"]
) -> None:
    """Write residuals, and irradiance and error of each light, as PNG; the design comes first."""
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    layout = ConstrainedLayoutEngine(w_pad=0.15, h_pad=0.1)
    figure = Figure(figsize=(15, 3.1 * (len(found.parts) + 1)), layout=layout)
    panels = figure.subplots(len(found.parts) + 1, 4, squeeze=False)
    maps = [part.residual.map() for part in found.parts]
    measured = np.concatenate([each.ravel() for each, _ in maps])
    top = float(np.nanpercentile(np.abs(measured), _SHOWN)) / found.micrometre
    for axes in panels[0, :2]:
        axes.set_axis_off()
    for row, (part, each) in enumerate(zip(found.parts, maps, strict=True), start=1):
        for axes, values, name in zip(
            panels[row], each, ("residual as measured", "resolved residual"), strict=False
        ):
            _draw(axes, found, values, top)
            axes.set_title(f"{PurePath(part.name).name}: {name}", fontsize=_FONT)
    scene = found.scene.wanted(target)[0].scene
    for row, (name, light) in enumerate(lights.items()):
        irradiance = (light.by_cells or light).irradiance
        lit, off = panels[row, 2:]
        IrradianceImage(lit, scene, target).update(irradiance)
        ErrorImage(off, scene, target).update(irradiance)
        error = 100 * light.verified.relative_l2_corrected
        lit.set_title(f"{PurePath(name).name}: {scene.receiver.density}", fontsize=_FONT)
        off.set_title(f"error, relative L2 {error:.3g} %", fontsize=_FONT)
    figure.savefig(file, dpi=_DPI, format="png")


def _draw(axes: "Axes", found: "Inspection", values: Array, top: float) -> None:
    extent = Extent.around(found.face.net.half_width, found.scene.unit)
    image = map_image(axes, "residual", extent, values.shape[::-1], SIGNED)
    image.set_data(values / found.micrometre)
    image.set_clim(-top, top)
    colour_bar(axes, image, "µm", "both")
