"""Marks of regions on images: outlines, names, and the light of each."""

from typing import TYPE_CHECKING, Any

import numpy as np

from workbench.arrays import Array
from workbench.measured.lamps import light_unit
from workbench.pictures.axes import label_place
from workbench.powers import written

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.text import Text

    from workbench.scene import Scene

_OUTLINE: dict[str, Any] = {"color": "#4aa3df", "linewidth": 1.2}


class RegionMarks:
    """Outlines and labels of the regions of a scene."""

    def __init__(self, axes: "Axes", scene: "Scene") -> None:
        self._scene = scene
        self._texts: list[Text] = []
        receiver = scene.receiver
        for number, region in enumerate(scene.regions):
            corners = receiver.middle + 2 * region.outline * receiver.half_extent
            axes.plot(*np.append(corners, corners[:1], axis=0).T, **_OUTLINE)
            (left, bottom), (right, top) = corners.min(axis=0), corners.max(axis=0)
            side = "left" if left + right <= 2 * receiver.middle[0] else "right"  # towards it
            at = left if side == "left" else right
            # In turn above and below: words are wider than regions that stand beside each other.
            edge, up = (bottom, "bottom") if number % 2 else (top, "top")
            text = label_place(axes, (at, edge), region.name, side, up)
            self._texts.append(text)

    def show_light(self, irradiance: Array) -> None:
        """Add to each label the light of its region."""
        if not self._texts:
            return
        from workbench.analysis.regions import light_of_regions  # late: takes long to import

        scene = self._scene
        found = light_of_regions(scene.regions, scene.receiver, irradiance, light_unit(scene))
        for text, light in zip(self._texts, found, strict=True):
            label, unit = f"{light.name} {100 * light.share:.1f} %", light.unit
            if unit.lumens is not None:
                label += f", {written(light.mean * unit.density, unit.words, 3)}"
            if light.uniformity is not None:
                label += f"\nU₀ {light.uniformity:.2f}"
            text.set_text(label)
