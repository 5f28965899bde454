"""Checks the lens on show: another tracer, rays that the design never saw."""

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
    """One check at a time in a thread of its own, forgotten as soon as another lens is shown.

    A check that is forgotten goes on unheard until it ends, and the next waits for that.

    Attributes
    ----------
    figures_changed : Signal(str)
        What is known of the lens on show, or that it is being checked; empty for nothing.
    told : Signal(str)
        The outcome as a sentence.
    failed : Signal(str)
        Why there is none.
    """

    figures_changed = Signal(str)
    told = Signal(str)
    failed = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._shown: Frame | None = None
        self._wanted: Frame | None = None  # whose check goes on, waits, or is shown
        self._asked: Frame | None = None  # whose check goes on
        self._background = Background("check", self)
        self._background.done.connect(self._take)
        self._background.failed.connect(self._give_up)

    def show_frame(self, frame: "Frame") -> None:
        """Take note of the lens that is shown."""
        self._shown = frame
        if self._wanted is not None and not _same_lens(self._wanted, frame):
            self._forget()

    def show_nothing(self, session: "Session") -> None:
        """Take note that there is no lens to show."""
        self._shown = None
        self._forget()

    def begin(self) -> None:
        """Check the lens on show, unless that is under way or done."""
        if self._shown is not None and self._wanted is None:
            self._wanted = self._shown
            self.figures_changed.emit("checking…")
            self._next()

    def close(self) -> None:
        """Wait for the thread; safe to call twice."""
        self._wanted = None
        self._background.close()

    def _next(self) -> None:
        if self._wanted is None or self._background.busy:
            return
        self._asked = self._wanted
        scene, target = self._asked.session.scene, self._asked.session.target
        heights = self._asked.snapshot.control_points

        def work() -> "Validation":
            # Late: what it stands on is slow to import.
            from workbench.analysis.validation import validate

            return validate(scene, target, heights)

        self._background.begin(work)

    def _take(self, found: "Validation") -> None:
        if self._asked is not self._wanted:
            self._next()
            return
        error = f"{100 * found.relative_l2:.2f} ± {100 * found.noise:.2f} %"
        on_screen = f"{100 * found.efficiency:.1f} %"
        self.figures_changed.emit(f"checked: error {error}, {on_screen}")
        self.told.emit(
            f"Check with {found.rays} fresh rays: relative L2 error {error}, "
            f"loss {found.loss:.3e}, {on_screen} on the screen"
        )

    def _give_up(self, sentence: str) -> None:
        if self._asked is not self._wanted:
            self._next()
            return
        self._forget()
        self.failed.emit(sentence)

    def _forget(self) -> None:
        self._wanted = None
        self.figures_changed.emit("")


def _same_lens(one: "Frame", other: "Frame") -> bool:
    alike = look_alike(one.session, other.session)
    return alike and np.array_equal(one.snapshot.control_points, other.snapshot.control_points)
