"""The dock Tolerances: the distribution of the error of perturbed lenses."""

from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton

from ui.background import Background, Task
from ui.document.frame import Frame, same_light, shows
from ui.manufacture.tolerance_form import Samples, ToleranceForm
from ui.views.plot_view import PlotView
from ui.views.view import View
from ui.widgets.controls import SideBySide
from ui.widgets.labels import WrappedLabel
from ui.words import error_text, later, tr
from workbench.analysis.tolerance_fields import ABOUT, PAIRS, Tolerances
from workbench.analysis.tolerances import Distribution, Perturbed
from workbench.errors import Refused
from workbench.files.session import Session
from workbench.pictures.axes import Column
from workbench.pictures.error_curves import draw_errors


@dataclass(eq=False)
class Sample:
    """Perturbed lenses that are traced so far."""

    frame: Frame
    within: Tolerances
    wanted: Samples
    lenses: list[Perturbed] = field(default_factory=list)  # the first is the nominal one

    @property
    def others(self) -> list[Perturbed]:
        return self.lenses[1:]

    @property
    def distribution(self) -> Distribution | None:
        """Distribution of the error; None before there is a lens beside the nominal one."""
        return Distribution.of(self.lenses[0], self.others) if self.others else None


def trace_sample(sample: Sample, rays: int, task: Task) -> None:
    """Trace perturbed lenses in a thread, and report each."""
    # Late: what it stands on is slow to import.
    from workbench.analysis.tolerances import perturbed

    session, heights = sample.frame.session, sample.frame.state.heights
    count, seed = sample.wanted.lenses, sample.wanted.seed
    for number, each in enumerate(
        perturbed(session.scene, session.target, heights, sample.within, count, rays, seed)
    ):
        if task.stopped:
            break
        task.part = number / count
        task.report(each)


class SpreadView(PlotView):
    """The distribution of the error over the traced lenses."""

    ENDINGS = (*PlotView.ENDINGS, ".json")

    _WAITING = later(
        "Start traces randomly perturbed lenses and shows the distribution of the error."
    )

    def __init__(self) -> None:
        super().__init__()
        self._sample: Sample | None = None

    def show_sample(self, sample: Sample) -> None:
        if sample.others:
            self._sample = sample
            self.show_frame(sample.frame)
            self._begin_anew()

    def data(self) -> list[Column]:
        """Perturbation and figures of each lens."""
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

    def figures(self) -> dict[str, Any]:
        """The distribution and each lens, as the command line writes them."""
        sample = self._sample
        spread = None if sample is None else sample.distribution
        if sample is None or spread is None:
            return {}  # there is nothing to save yet
        return spread.to_data() | {"samples": [each.to_data() for each in sample.others]}

    def _why_empty(self, frame: Frame | None) -> str:
        return "" if self._sample is not None else tr(self._WAITING)

    def _begin(self, axes: Axes, session: Session) -> None:
        if self._sample is not None:
            nominal, *errors = (each.relative_l2 for each in self._sample.lenses)
            draw_errors(axes, nominal, errors)


_RAYS = 1_000_000  # for each lens, as on the command line
_NOTHING_OFF = later("All tolerances are zero. Enter a tilt, a decentre or another tolerance.")


class TolerancePane(View):
    """Fields, distribution and figures; it marks results of another lens as outdated."""

    save_asked = Signal()
    failed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.plot, self.form = SpreadView(), ToleranceForm()
        self.begin, self.save = QPushButton(), QPushButton(tr("Save…"))
        tip = tr("Save the plot (PNG, SVG), or the figures of each lens (CSV, JSON)")
        self.save.setToolTip(tip)
        self._box.addWidget(SideBySide(self.plot, self.form, (self.begin, self.save)))
        self.summary = WrappedLabel()
        self.summary.setContentsMargins(6, 0, 6, 4)
        self.plot.add_below(self.summary)
        self._sample: Sample | None = None
        self.background = Background(later("tolerance analysis"), self)
        self.background.progressed.connect(self._add_lens)
        self.background.done.connect(self._follow)
        self.background.failed.connect(self._give_up)
        self.begin.clicked.connect(self.toggle)
        self.save.clicked.connect(self.save_asked)
        self._offer()

    @property
    def outdated(self) -> bool:
        return self._of_another

    def show_design(self, session: Session) -> None:
        self.form.show_scene(session.scene)
        self.plot.show_design(session)
        super().show_design(session)
        if self._frame is not None and not shows(self._frame, session):
            self.background.stop()  # the lenses that are traced count
            self._offer()

    def show_frame(self, frame: Frame) -> None:
        super().show_frame(frame)
        self._offer()

    def allow(self, resting: bool) -> None:
        super().allow(resting)
        self._offer()

    def toggle(self) -> None:
        if self.background.busy:
            self.background.stop()
            self._offer()
        elif self._frame is not None:
            self.form.commit()
            if not self.form.refused:
                self._begin(self._frame)

    def _begin(self, frame: Frame) -> None:
        try:
            self.form.check()
        except Refused as refused:  # for no field
            self.summary.setText(error_text(refused))
            return
        if not self.form.within.any:
            self.summary.setText(tr(_NOTHING_OFF))
            return
        sample = self._sample = Sample(frame, self.form.within, self.form.samples)
        self.background.begin(partial(trace_sample, sample, _RAYS), sample, tr("Tolerances"))
        self._offer()

    def _add_lens(self, sample: Sample, each: Perturbed) -> None:
        sample.lenses.append(each)
        self._follow(sample)

    def _follow(self, sample: Sample) -> None:
        self.plot.show_sample(sample)
        self._offer()

    def _give_up(self, sentence: str) -> None:
        self._sample = None
        self._offer()
        self.failed.emit(sentence)

    def _show_veil(self) -> None:
        self._offer()  # the plot alone is outdated

    def _offer(self) -> None:
        busy, sample = self.background.busy, self._sample
        self.begin.setText(tr("Cancel") if busy else tr("Start"))
        self.begin.setToolTip(
            tr("Stop; the traced lenses are kept")
            if busy
            else tr("Perturb the lens at random and trace each sample independently")
        )
        possible = self._resting and self._frame is not None and not self._of_another
        self.plot.show_outdated(sample is not None and (self._of_another or self._is_past(sample)))
        self.begin.setEnabled(not self.background.stopping if busy else possible)
        self.save.setEnabled(sample is not None and bool(sample.others))
        self.summary.setText(self._figures(busy))

    def _figures(self, busy: bool) -> str:
        sample = self._sample
        if sample is None:
            return ""
        done = tr("{count} of {wanted} lenses").format(
            count=len(sample.others), wanted=sample.wanted.lenses
        )
        spread = sample.distribution
        if spread is None:
            return f"{done}…"
        text = tr(
            "{done}: error as designed {nominal:.2f} %, median {median:.2f} %, 95 % of lenses "
            "below {most:.2f} %, worst {worst:.2f} %"
        ).format(
            done=f"{done}…" if busy else done,
            nominal=100 * spread.nominal,
            median=100 * spread.percentiles["50"],
            most=100 * spread.percentiles["95"],
            worst=100 * spread.worst,
        )
        if self._is_past(sample):
            return f"{text}. {tr('Outdated: the lens has changed.')}"
        return text

    def _is_past(self, sample: Sample) -> bool:
        return self._frame is None or not same_light(sample.frame, self._frame)
