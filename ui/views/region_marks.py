"""Regions drawn on an image of the screen, each with its name and its light."""

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.text import Text

    from workbench.scene import Scene

_OUTLINE: dict[str, Any] = {"fill": False, "edgecolor": "#4aa3df", "linewidth": 1.2}
_TEXT: dict[str, Any] = {"color": "white", "fontsize": "x-small", "va": "top", "clip_on": True}
_BOX: dict[str, Any] = {"facecolor": "#1d2733", "edgecolor": "none", "alpha": 0.7, "pad": 1.5}


class RegionMarks:
    """Outlines of the regions of a scene, and what is written at them.

    Parameters
    ----------
    axes : Axes
        Of an image of the screen, in the receiver's coordinates.
    scene : Scene
        Whose regions.
    """

    def __init__(self, axes: "Axes", scene: "Scene") -> None:
        self._scene = scene
        self.texts: list[Text] = []
        """The artists that change."""
        receiver = scene.receiver
        for region in scene.regions:
            corners = receiver.middle + 2 * region.outline * receiver.half_extent
            axes.fill(*corners.T, **_OUTLINE)
            # Inside its upper left corner, where a region beside it does not hide the words.
            x, y = corners[:, 0].min(), corners[:, 1].max()
            self.texts.append(axes.text(x, y, region.name, bbox=_BOX, **_TEXT))

    def show_light(self, irradiance: npt.NDArray[np.float64]) -> None:
        """Write the share of the light, and how even it is, at each region."""
        if not self.texts:
            return
        from workbench.analysis.regions import light_of_regions  # late: takes long to import

        scene = self._scene
        for text, light in zip(
            self.texts, light_of_regions(scene.regions, scene.receiver, irradiance), strict=True
        ):
            even = "" if light.uniformity is None else f", least / mean {light.uniformity:.2f}"
            text.set_text(f"{light.name}: {100 * light.share:.1f} % of the light{even}")
