"""Traces the lens to screens elsewhere in a thread, always for the latest question."""

from dataclasses import dataclass
from functools import partial
from threading import Event
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QObject, QThread, Signal

from ui.threads.latest import Latest
from workbench.errors import RunFailed

if TYPE_CHECKING:
    from workbench.analysis.validation import Validation
    from workbench.files.session import Session


@dataclass(frozen=True, eq=False)
class Question:
    """What the light of a lens is like on screens elsewhere.

    Attributes
    ----------
    session : Session
        Its task.
    control_points : ndarray, shape (n_u, n_v)
        Heights of its control points.
    traces : tuple of (float, int)
        One after the other: z of the screen, and rays.
    """

    session: "Session"
    control_points: npt.NDArray[np.float64]
    traces: tuple[tuple[float, int], ...]


class Focusing(QObject):
    """Another question, or none any more, ends the one before within a moment.

    Attributes
    ----------
    found : Signal(Question, float, Validation or None)
        z of a screen and what the light is like there; None for no light.
    failed : Signal(Question, str)
        Why there is no answer.
    """

    found = Signal(object, float, object)
    failed = Signal(object, str)

    _traced = Signal(object, float, object)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._latest = Latest("trace through focus", self)
        self._latest.failed.connect(self.failed)
        self._traced.connect(self._take)  # queued: the receiver lives in the window's thread

    def ask(self, question: Question) -> None:
        """Answer this instead of what was asked before."""
        self._latest.ask(question, partial(self._answer, question))

    def forget(self) -> None:
        """Tell nothing more."""
        self._latest.forget()

    def close(self) -> None:
        """Wait for the thread; safe to call twice."""
        self._latest.close()

    def _answer(self, question: Question, left: Event) -> None:
        for z, rays in question.traces:
            if left.is_set():
                return
            self._traced.emit(question, z, _trace(question, z, rays, left))

    def _take(self, question: Question, z: float, found: "Validation | None") -> None:
        if self._latest.wants(question):
            self.found.emit(question, z, found)


def _trace(question: Question, z: float, rays: int, left: Event) -> "Validation | None":
    """The light on a screen; None if there is none, or nobody wants to know any more."""
    # Late: what it stands on is slow to import.
    from workbench.analysis.validation import validating

    session, threads = question.session, max(1, QThread.idealThreadCount() - 1)
    steps = validating(
        session.scene, session.target, question.control_points, rays, screen_z=z, threads=threads
    )
    try:
        while not left.is_set():
            next(steps)
    except StopIteration as end:
        found: Validation = end.value
        return found
    except RunFailed:
        return None
    steps.close()
    return None
