"""A photograph of the projected light beside its prediction."""

from typing import TYPE_CHECKING, BinaryIO

import numpy as np

from workbench.messages import Message
from workbench.pictures.axes import SIGNED, UNSIGNED, colour_bar
from workbench.pictures.images import receiver_map
from workbench.scene import Scene
from workbench.scene.image import as_viewed

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from workbench.analysis.making.photograph import Photograph

_FONT, _DPI = 9, 150
_UNIT = Message("1 = mean")
_TITLES = (
    Message("photograph, rectified"),
    Message("prediction with causes"),
    Message("photograph less prediction"),
)
_SHOWN = 99.8  # percent of the values within the scale: a glint must not hide the rest


def write_photograph(file: BinaryIO, found: "Photograph", scene: Scene) -> None:
    """Write a photograph, its prediction and their difference as PNG."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(15, 4.5), layout="constrained")
    draw_photograph(figure, found, scene)
    figure.savefig(file, dpi=_DPI, format="png")


def draw_photograph(figure: "Figure", found: "Photograph", scene: Scene) -> None:
    """Draw a photograph, its prediction and their difference side by side."""
    first, *_ = scene.single
    difference = found.light - found.predicted
    top = float(np.percentile([found.light, found.predicted], _SHOWN))
    off = float(np.percentile(np.abs(difference), _SHOWN)) or 1.0
    for axes, title, values, limits in zip(
        figure.subplots(1, 3),
        _TITLES,
        (found.light, found.predicted, difference),
        ((0, top), (0, top), (-off, off)),
        strict=True,
    ):
        image = receiver_map(axes, title, first, SIGNED if limits[0] else UNSIGNED[0])
        image.set_data(as_viewed(first, values))
        image.set_clim(*limits)
        colour_bar(axes, image, _UNIT, "both" if limits[0] else "max")
        axes.set_title(title, fontsize=_FONT)
