"""The dock that perturbs the lens on show and tells what becomes of its image."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal

from ui.shown.frame import same_light, shows
from ui.threads.background import Background
from ui.threads.failure import sentence_of
from ui.tolerances.form import ToleranceForm
from ui.tolerances.sampling import Sample, trace_sample
from ui.tolerances.spread_view import SpreadView
from ui.widgets.side_by_side import SideBySide
from ui.widgets.wrapped_label import WrappedLabel
from ui.words import later, tr
from workbench.analysis.tolerances import Distribution

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.analysis.tolerances import Perturbed
    from workbench.files.session import Session

_RAYS = 1_000_000  # for each lens, as on the command line
_NOTHING_OFF = later("Nothing is off: give a tilt, a decentre or another tolerance.")


class TolerancePane(SideBySide):
    """Fields, the distribution, and its figures.

    What was found is that of the lens that was asked about; once another one is shown, it says so.

    Attributes
    ----------
    plot : SpreadView
        Its picture.
    save_asked : Signal()
        A person wants the plot or the figures in a file.
    failed : Signal(str)
        Why there is no distribution.
    """

    save_asked = Signal()
    failed = Signal(str)

    def __init__(self) -> None:
        plot, form = SpreadView(), ToleranceForm()
        super().__init__(plot, form, (form.begin, form.save))
        self.plot, self.form = plot, form
        self.summary = WrappedLabel()
        self.summary.setContentsMargins(6, 0, 6, 4)
        plot.add_below(self.summary)
        self._frame: Frame | None = None
        self._sample: Sample | None = None
        self._resting = True
        self._of_another = False  # whether the frame is of another design
        self._background = Background("sample of tolerances", self)
        self._background.progressed.connect(self._take)
        self._background.done.connect(self._follow)
        self._background.failed.connect(self._give_up)
        form.toggled.connect(self.toggle)
        form.save_asked.connect(self.save_asked)
        self._offer()

    def show_design(self, session: "Session") -> None:
        """Take the unit of a design."""
        self.form.show_scene(session.scene)
        self.plot.show_design(session)
        if self._frame is not None and not shows(self._frame, session):
            self._background.stop()  # the lenses that are traced count
            self._offer()

    def show_outdated(self, outdated: bool) -> None:
        """Mark the distribution as that of another design, or no longer."""
        self._of_another = outdated
        self._offer()

    def show_frame(self, frame: "Frame") -> None:
        """Take note of the lens that is shown."""
        self._frame = frame
        self._offer()

    def show_nothing(self, session: "Session") -> None:
        """Take note that there is no lens to show."""
        self._frame = None
        self._offer()

    def allow(self, resting: bool) -> None:
        """Whether the lens on show stays as it is; only then it is perturbed."""
        self._resting = resting
        self._offer()

    def toggle(self) -> None:
        """Perturb the lens on show; while that is under way, make do with what there is."""
        if self._background.busy:
            self._background.stop()
            self._offer()
        elif self._frame is not None:
            if not self.form.accepted():
                if self.form.obstacle:
                    self.summary.setText(self.form.obstacle)
                return
            if not self.form.within.any:
                self.summary.setText(tr(_NOTHING_OFF))
                return
            sample = Sample(self._frame, self.form.within, self.form.lenses, self.form.seed)
            self._sample = sample
            self._background.begin(partial(trace_sample, sample, _RAYS), sample)
            self._offer()

    def close_thread(self) -> None:
        """Leave the sample and wait for its thread; safe to call twice."""
        self._background.close()

    def _take(self, sample: Sample, each: "Perturbed") -> None:
        sample.add(each)
        self._follow(sample)

    def _follow(self, sample: Sample) -> None:
        self.plot.show_sample(sample)
        self._offer()

    def _give_up(self, sample: Sample, error: Exception) -> None:
        self._sample = None
        self._offer()
        self.failed.emit(sentence_of(error, tr("sample of tolerances")))

    def _offer(self) -> None:
        """Tell what can be done now, and of which lens the figures are."""
        busy, sample = self._background.busy, self._sample
        begin = self.form.begin
        begin.setText(tr("Cancel") if busy else tr("Start"))
        begin.setToolTip(
            tr("Trace no more; those that are traced count")
            if busy
            else tr("Perturb what is on show at random, and trace each with fresh rays")
        )
        possible = self._resting and self._frame is not None and not self._of_another
        self.plot.show_outdated(sample is not None and (self._of_another or self._is_past(sample)))
        begin.setEnabled(not self._background.stopping if busy else possible)
        self.form.save.setEnabled(sample is not None and sample.shown)
        self.summary.setText(self._figures(busy))

    def _figures(self, busy: bool) -> str:
        sample = self._sample
        if sample is None:
            return ""
        done = tr("{count} of {wanted} lenses").format(
            count=len(sample.others), wanted=sample.wanted
        )
        if sample.nominal is None or not sample.others:
            return f"{done}…"
        spread = Distribution.of(sample.nominal, sample.others)
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
            return f"{text}. {tr('Out of date: the lens has changed since.')}"
        return text

    def _is_past(self, sample: Sample) -> bool:
        """Whether a sample is of another lens than the one on show."""
        return self._frame is None or not same_light(sample.frame, self._frame)
