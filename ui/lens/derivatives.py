"""Computes derivative maps in a thread of their own, one at a time, always the latest asked for."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QObject, QThread, Signal, Slot

from workbench.errors import Refused

if TYPE_CHECKING:
    from workbench.scene import Scene


@dataclass(frozen=True, eq=False)
class Question:
    """Whose derivative is asked for.

    Attributes
    ----------
    scene : Scene
        What is traced.
    control_points : ndarray, shape (n_u, n_v)
        Heights of the lens.
    index : tuple[int, int]
        The control point.
    """

    scene: "Scene"
    control_points: npt.NDArray[np.float64]
    index: tuple[int, int]


class Solver(QObject):
    """Answers questions in the thread that it was moved to."""

    # The question; its map or None; a sentence that says what went wrong, or nothing.
    solved = Signal(object, object, str)

    @Slot(object)
    def solve(self, question: Question) -> None:
        """Answer a question."""
        found, sentence = None, ""
        try:
            # Late: torch comes with it, and the window shows before that.
            import torch

            from workbench.analysis.derivatives import irradiance_derivative

            # For this thread alone; a core stays the window's.
            torch.set_num_threads(max(1, QThread.idealThreadCount() - 1))
            found = irradiance_derivative(question.scene, question.control_points, question.index)
        except Refused as error:
            sentence = str(error)
        except Exception as error:
            # A defect of the engine has to reach the person instead of ending the thread.
            sentence = f"No derivative for an unexpected {type(error).__name__}: {error}"
        self.solved.emit(question, found, sentence)


class Derivatives(QObject):
    """Owns the thread; lives in the window's.

    A question that comes while another is answered waits, and replaces one that waits already.

    Attributes
    ----------
    answered : Signal(Question, DerivativeMap or None, str)
        The map, or why there is none in one sentence.
    """

    answered = Signal(object, object, str)

    _asked = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._busy = False
        self._waiting: Question | None = None
        self._thread: QThread | None = None
        self._solver: Solver | None = None

    def ask(self, question: Question) -> None:
        """Answer a question as soon as the one before is answered."""
        self._waiting = question
        self._next()

    def forget(self) -> None:
        """Drop the question that waits."""
        self._waiting = None

    def close(self) -> None:
        """Wait for the thread; the answer under way is dropped. Safe to call twice."""
        self._waiting = None
        if self._thread is not None and self._solver is not None:
            self._solver.solved.disconnect(self._end)
            self._thread.quit()
            self._thread.wait()
        self._thread = self._solver = None
        self._busy = False

    def _next(self) -> None:
        if self._busy or self._waiting is None:
            return
        if self._thread is None:
            self._start_thread()
        question, self._waiting = self._waiting, None
        self._busy = True
        self._asked.emit(question)

    def _start_thread(self) -> None:
        self._thread = QThread()
        self._solver = Solver()
        self._solver.moveToThread(self._thread)
        self._solver.solved.connect(self._end)
        self._asked.connect(self._solver.solve)
        self._thread.start()

    @Slot(object, object, str)
    def _end(self, question: Question, found: object, sentence: str) -> None:
        self._busy = False
        self.answered.emit(question, found, sentence)
        self._next()
