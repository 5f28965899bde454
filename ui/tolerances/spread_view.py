"""Which part of the perturbed lenses stays below an error."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ui.tolerances.sampling import Sample
from ui.views.plot_view import PlotView
from ui.words import later, tr
from workbench.analysis.tolerance_fields import ABOUT, PAIRS
from workbench.analysis.tolerances import Distribution
from workbench.pictures.axes import Column
from workbench.pictures.error_curves import draw_errors

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class SpreadView(PlotView):
    """The distribution of the error over the lenses of a sample, while they come in."""

    _HAS_BAR = False
    _WAITING = later(
        "How does the image change when lenses are a little off? Start traces some of them."
    )

    def __init__(self) -> None:
        super().__init__()
        self._sample: Sample | None = None

    def show_sample(self, sample: Sample) -> None:
        """Show the lenses of a sample that are traced."""
        if sample.shown:
            self._sample = sample
            self.show_frame(sample.frame)
            self._begin_anew()

    def data(self) -> list[Column]:
        """How far each lens is off, and what comes of it."""
        if self._sample is None:
            return []
        scene = self._sample.frame.session.scene
        unit = scene.unit
        rows = [each.to_data() for each in self._sample.others]
        columns: list[Column] = []
        for name in (name for name in ABOUT if name not in PAIRS):
            in_unit = {"": "", "degrees": " [deg]", "length": f" [{unit}]"}[ABOUT[name].unit]
            sizes, words = np.array([row[name] for row in rows]), name.replace("_", " ")
            along = {"error": sizes} if sizes.ndim == 1 else dict(zip("xyz", sizes.T, strict=False))
            columns += [Column(f"{words} {axis}{in_unit}", each) for axis, each in along.items()]
        for words, name in (
            ("relative L2 error", "relative_l2"),
            (f"light {scene.receiver.place}", "efficiency"),
        ):
            columns.append(Column(words, np.array([row[name] for row in rows])))
        return columns

    def figures(self) -> dict[str, Any] | None:
        """The distribution and each lens, as the command line tells them."""
        sample = self._sample
        if sample is None or sample.nominal is None:
            return {}  # there is nothing to save yet
        spread = Distribution.of(sample.nominal, sample.others)
        return spread.to_data() | {"samples": [each.to_data() for each in sample.others]}

    def _why_empty(self, frame: "Frame | None") -> str:
        return "" if self._sample is not None else tr(self._WAITING)

    def _begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        sample = self._sample
        if sample is not None and sample.nominal is not None:
            errors = [each.relative_l2 for each in sample.others]
            draw_errors(axes, sample.nominal.relative_l2, errors)
        return ()

    def _change(self, frame: "Frame") -> bool:
        return False  # another lens has another picture
