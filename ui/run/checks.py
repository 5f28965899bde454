"""Checks of the shown lens and of a run's lenses, and the lower bound of a task."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from time import monotonic
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from ui.background import Background, Task
from ui.document.document import Document
from ui.document.frame import iterations_before, lit_alike, same_lens, shows
from ui.run.control import RunControl
from ui.words import later, tr
from workbench.arrays import Array
from workbench.design.session import verified_error as verified_error
from workbench.pictures.loss import Verified
from workbench.powers import written
from workbench.process import cores

if TYPE_CHECKING:
    from ui.document.frame import Frame
    from workbench.analysis.validation_figures import Validation
    from workbench.design.lens_state import LensState
    from workbench.design.snapshot import Result
    from workbench.files.session import KeptRun, Session
    from workbench.geometry.faces import ControlHeights
    from workbench.report.findings import Attainable


RAYS = 4_000_000
"""Rays of a thorough check."""

_FEW_RAYS = 1_000_000  # enough to distinguish successive errors
_ROUGH = 5e-3  # error of an image by cells that such a check may have


@dataclass(frozen=True, eq=False)
class CheckedLens:
    """A lens to check."""

    session: "Session"
    heights: "ControlHeights"
    iterations: int = 0
    irradiance: Array | None = None
    further: tuple[Array, ...] = ()

    @classmethod
    def of(cls, session: "Session", state: "LensState", iterations: int = 0) -> "CheckedLens":
        """A lens with its own images, for their difference to the check."""
        further = tuple(light.irradiance for light in state.further)
        return cls(session, state.heights, iterations, state.irradiance, further)

    def lights(self, task: "Session | KeptRun", heights: "ControlHeights") -> bool:
        """Whether heights are those of this lens, and it gives a task the same light."""
        return heights == self.heights and lit_alike(task, self.session)


def check(
    lens: CheckedLens, rays: int | None, task: Task
) -> "tuple[Validation, float | None] | None":
    """Check a lens in a thread, roughly without a number of rays; reports the finished part."""
    # Late: what it stands on is slow to import.
    from workbench.analysis.making.as_made import checking
    from workbench.analysis.metrics import relative_l2
    from workbench.analysis.validation import validating

    lit = lens.session.scene, lens.session.target, lens.heights
    if rays is None:
        steps = validating(*lit, _FEW_RAYS, threads=1, accuracy=_ROUGH)
    else:
        steps = checking(*lit, rays)
    found = task.follow(steps, task.report)
    if found is None:
        return None
    task.outcome = tr(found.contradiction or "")  # else the result cards state the error
    own = lens.irradiance
    return found, None if own is None else relative_l2(found.irradiance, own)


class Check(QObject):
    """A check of the shown lens, asked for or of a run's end; dropped with the lens."""

    asked = Signal()
    under_way_changed = Signal(bool)
    checked = Signal(object, object, object)  # CheckedLens, Validation, float
    summary_ready = Signal(str)
    failed = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._shown: Frame | None = None
        self._asked: Frame | None = None  # whose check goes on, or whose figures are shown
        self._rays = self._asked_rays = RAYS
        self.background = Background(later("check"), self)
        self.background.done.connect(self._show_outcome)
        self.background.failed.connect(self._give_up)

    def show_frame(self, frame: "Frame") -> None:
        self._shown = frame
        if self._asked is not None and not same_lens(self._asked, frame):
            self._forget()

    def show_design(self, session: "Session") -> None:
        """Drop a lens of another design, and its check."""
        if self._shown is not None and not shows(self._shown, session):
            self._shown = None
        if self._asked is not None and not shows(self._asked, session):
            self._forget()

    def show_nothing(self, session: "Session") -> None:
        self._shown = None
        self._forget()

    def use_rays(self, rays: int) -> None:
        self._rays = rays

    def toggle(self) -> None:
        if self.background.busy:
            self._forget()
        elif self._shown is None:
            self.failed.emit(tr("The image is still being computed. Try again in a moment."))
        else:
            self.asked.emit()
            if self._asked is None or self._asked_rays != self._rays:
                self.under_way_changed.emit(True)  # first: what follows shows its best lens
                self._begin(self._shown)

    def take(self, lens: CheckedLens, found: "Validation", difference: float) -> None:
        """Take over the check of a run's lens while that is shown."""
        shown = self._shown
        if shown is not None and lens.lights(shown.session, shown.state.heights):
            self._asked, self._asked_rays = shown, RAYS
            self.checked.emit(lens, found, difference)

    def _begin(self, shown: "Frame") -> None:
        self._asked, self._asked_rays = shown, self._rays
        lens = CheckedLens.of(shown.session, shown.state)
        work = partial(check, lens, self._rays)
        self.background.begin(work, lens, tr("Check"))

    def cancel(self) -> None:
        if self.background.busy:
            self._forget()

    def _show_outcome(self, lens: CheckedLens, outcome: "tuple[Validation, float] | None") -> None:
        if outcome is None:  # stopped
            self._forget()
            return
        found, difference = outcome
        failed = found.contradiction
        self.under_way_changed.emit(False)
        self.checked.emit(lens, found, difference)
        if failed:
            self.failed.emit(tr(failed))
            return
        low, high = found.verified.relative_l2_corrected_interval
        self.summary_ready.emit(
            tr(
                "Check with {rays:,} rays: relative L2 error {verified} ({low:.2f} to {high:.2f} "
                "%); with ray noise {relative_l2:.2f} ± {noise:.2f} %, loss {loss}; "
                "{efficiency:.1f} % {place}"
            ).format(
                rays=found.rays,
                verified=verified_error(found.verified),
                low=100 * low,
                high=100 * high,
                relative_l2=100 * found.relative_l2,
                noise=100 * found.noise,
                loss=written(found.loss),
                efficiency=100 * found.efficiency,
                place=tr(lens.session.scene.receiver.place),
            )
        )

    def _give_up(self, sentence: str) -> None:
        self._forget()
        self.failed.emit(sentence)

    def _forget(self) -> None:
        self._asked = None
        self.background.cancel()
        self.under_way_changed.emit(False)


_REST = 5.0  # seconds between checks, at least
_RESTS = 19.0  # seconds of rest for each second of a check: 5 % of one core
_GUESS = 0.5  # seconds that the first one takes


class RunCheck(QObject):
    """Checks lenses at stage ends, at intervals on an idle core, and each that is finished."""

    checked = Signal(object, object)  # CheckedLens, Validation
    ended = Signal(object, object, object)  # CheckedLens, Validation, float: of a finished lens
    failed = Signal(str)

    def __init__(self, document: Document, control: RunControl, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._control = document, control
        self.wanted: Callable[[], bool] = lambda: True
        self._last: Frame | None = None
        self._began = self._rested_at = 0.0
        self._cost = _GUESS
        self._end: CheckedLens | None = None  # the lens that was finished last
        self._result: Result | None = None  # that it is of
        self.background = Background(later("check of the result"), self)
        self.background.done.connect(self._show_outcome)
        self.background.failed.connect(self.failed)
        control.runner.state_changed.connect(self._follow)
        control.runner.frame_ready.connect(self._check_frame)
        control.ended.connect(self._finish)
        document.session_changed.connect(self._follow_document)

    def _follow(self, state: str) -> None:
        if state == "running" and self._last is None:
            self.background.cancel()

    def _check_frame(self, frame: "Frame") -> None:
        if not self._control.busy:  # a preview
            return
        last, self._last = self._last, frame
        if last is None:  # what came before was no run yet
            self._rested_at = monotonic()
            return
        if self.background.busy or cores() < 2 or not self.wanted():
            return
        if last.snapshot.stage != frame.snapshot.stage:
            self._check(last)
        elif monotonic() - self._rested_at > max(_REST, _RESTS * self._cost):
            self._check(frame)

    def _check(self, frame: "Frame") -> None:
        self._began = monotonic()
        lens = CheckedLens(frame.session, frame.state.heights, iterations_before(frame))
        self.background.begin(partial(check, lens, None), lens)

    def check_result(self) -> None:
        """Check the finished lens of the document."""
        session, result = self._document.session, self._document.session.result
        self._result = result
        if result is not None and self.wanted():
            self._end = CheckedLens.of(session, result.state, result.iterations)
            work = partial(check, self._end, RAYS)
            self.background.begin(work, self._end, tr("Check of the result"))

    def _finish(self) -> None:
        seen, self._last = self._last, None
        if seen is not None:
            self.check_result()

    def _show_outcome(
        self, lens: CheckedLens, outcome: "tuple[Validation, float | None] | None"
    ) -> None:
        if outcome is None:  # stopped
            return
        found, difference = outcome
        if found.contradiction:
            self.failed.emit(tr(found.contradiction))
            return
        verified = Verified(lens.iterations, found.loss_corrected)
        history = self._control.history
        if lens is self._end and self._result is not None:
            self._document.verified.note(self._result, found)  # also while its run is undone
            history.add_later_check(verified, self._result, self._document.session)
            self.ended.emit(lens, found, difference)
        else:
            self._rested_at = monotonic()
            self._cost = self._rested_at - self._began
            history.add_check(verified)
        self.checked.emit(lens, found)

    def _follow_document(self, session: "Session") -> None:
        if self._end is not None and not lit_alike(self._end.session, session):
            self.background.cancel()


_REST_MS = 1000  # without edits before bounds are computed: live designs come first


class BoundOfDesign(QObject):
    """Computes the bounds of error and light of each new task in a thread."""

    found = Signal(object, str)  # Attainable or None, its sentences
    failed = Signal(str)

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._task: Session | None = None  # whose bound is shown, or looked for
        self._background = Background(later("bound"), self)
        self._background.done.connect(lambda _, found: self.found.emit(*found))
        self._background.failed.connect(self.failed)
        self._rest = QTimer(self, singleShot=True)
        self._rest.timeout.connect(self._begin)
        document.session_changed.connect(self.follow)

    def follow(self, session: "Session") -> None:
        last, self._task = self._task, session
        if last is not None and lit_alike(last, session):
            return
        self._background.cancel()
        self.found.emit(None, "")
        self._rest.start(_REST_MS)

    def _begin(self) -> None:
        assert self._task is not None
        self._background.begin(partial(_bounds, self._task), self._task)


def _bounds(session: "Session", task: Task) -> "tuple[Attainable | None, str]":
    # Late: all of them take long to import.
    from workbench.analysis.light_limit import light_limits
    from workbench.extended.bound import Bound, percent
    from workbench.report.findings import Attainable

    scene = session.scene
    limits, bound = light_limits(scene), Bound(scene, session.target)
    lights = zip(limits, scene.receivers, strict=True)
    sentences = list(dict.fromkeys(tr(limit.sentence(scene, each)) for limit, each in lights))
    error = None
    if bound.certified:
        if task.follow(bound.finding()) is None:
            return None, ""
        allowed = task.follow(bound.finding_half_as_wide())
        if allowed is None:
            return None, ""
        error = bound.relative_l2
        certified = tr(
            "Certified lower bound of the relative L2 error: {bound}; {error} with a source of "
            "half the width. Details: freeform bound."
        )
        sentences.insert(0, certified.format(bound=bound.short, error=percent(allowed)))
    tip = f"<p>{' '.join(sentences)}</p>"
    return Attainable(error, max(limit.most for limit in limits)), tip
