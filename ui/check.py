"""Checks the lens on show: another tracer, rays that the design never saw."""

from threading import Event
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal

from ui.background import Background
from ui.views.view import look_alike

if TYPE_CHECKING:
    from ui.frame import Frame
    from workbench.analysis.validation import Validation
    from workbench.files.session import Session


class Check(QObject):
    """One check at a time in a thread of its own, left as soon as another lens is shown.

    Attributes
    ----------
    figures_changed : Signal(str)
        What is known of the lens on show, or how far its check is; empty for nothing.
    under_way_changed : Signal(bool)
        Whether there is a check that could be cancelled.
    checked : Signal(Frame, Validation)
        The outcome for a lens.
    told : Signal(str)
        The same as a sentence.
    failed : Signal(str)
        Why there is none.
    """

    figures_changed = Signal(str)
    under_way_changed = Signal(bool)
    checked = Signal(object, object)
    told = Signal(str)
    failed = Signal(str)

    _came_on = Signal(object, float)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._shown: Frame | None = None
        self._wanted: Frame | None = None  # whose check goes on, waits, or is shown
        self._asked: Frame | None = None  # whose check goes on
        self._left = Event()
        self._background = Background("check", self)
        self._background.done.connect(self._take)
        self._background.failed.connect(self._give_up)
        self._came_on.connect(self._tell_progress)

    def show_frame(self, frame: "Frame") -> None:
        """Take note of the lens that is shown."""
        self._shown = frame
        if self._wanted is not None and not _same_lens(self._wanted, frame):
            self._forget()

    def show_nothing(self, session: "Session") -> None:
        """Take note that there is no lens to show."""
        self._shown = None
        self._forget()

    def toggle(self) -> None:
        """Check the lens on show, unless that is done; while it is under way, cancel it."""
        if self._asked is not None and self._asked is self._wanted:
            self._forget()
        elif self._shown is not None and self._wanted is None:
            self._wanted = self._shown
            self.figures_changed.emit("checking…")
            self.under_way_changed.emit(True)
            self._next()

    def close(self) -> None:
        """Leave the check and wait for the thread; safe to call twice."""
        self._wanted = None
        self._left.set()
        self._background.close()

    def _next(self) -> None:
        if self._wanted is None or self._background.busy:
            return
        asked, left = self._wanted, Event()
        self._asked, self._left = asked, left
        scene, target = asked.session.scene, asked.session.target
        heights = asked.snapshot.control_points

        def work() -> "Validation | None":
            # Late: what it stands on is slow to import.
            from workbench.analysis.validation import validating

            steps = validating(scene, target, heights)
            while not left.is_set():
                try:
                    self._came_on.emit(asked, next(steps))
                except StopIteration as end:
                    found: Validation = end.value
                    return found
            steps.close()
            return None

        self._background.begin(work)

    def _tell_progress(self, frame: "Frame", part: float) -> None:
        if frame is self._wanted:
            self.figures_changed.emit(f"checking… {100 * part:.0f} %")

    def _take(self, found: "Validation | None") -> None:
        asked, self._asked = self._asked, None
        if asked is None or asked is not self._wanted or found is None:
            self._next()
            return
        self.figures_changed.emit(f"checked: error {verified_error(found)}")
        self.under_way_changed.emit(False)
        self.checked.emit(asked, found)
        low, high = found.relative_l2_corrected_interval
        self.told.emit(
            f"Check with {found.rays:,} fresh rays: relative L2 error {verified_error(found)} "
            f"(95 %: {100 * low:.2f} to {100 * high:.2f} %); with the scatter of the rays "
            f"{100 * found.relative_l2:.2f} ± {100 * found.noise:.2f} %, loss {found.loss:.3e}; "
            f"{100 * found.efficiency:.1f} % on the screen"
        )

    def _give_up(self, sentence: str) -> None:
        asked, self._asked = self._asked, None
        if asked is not self._wanted:
            self._next()
            return
        self._forget()
        self.failed.emit(sentence)

    def _forget(self) -> None:
        self._wanted = None
        self._left.set()
        self.figures_changed.emit("")
        self.under_way_changed.emit(False)


def verified_error(found: "Validation") -> str:
    """What a check says of the lens itself: the scatter of its own rays is no error of a lens."""
    return f"{100 * found.relative_l2_corrected:.2f} %"


def _same_lens(one: "Frame", other: "Frame") -> bool:
    alike = look_alike(one.session, other.session)
    return alike and np.array_equal(one.snapshot.control_points, other.snapshot.control_points)
