"""The light of a lens that is shaped by hand, while it is shaped.

1. The latest lens wins: one is traced at a time, in a thread of its own, and of those that come
   meanwhile the last is next.
2. What a scene's trace needs is kept from lens to lens.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
import torch
from PySide6.QtCore import QObject, QThread, Signal

from ui.shown.frame import Frame, make_frame
from ui.threads.background import Background
from workbench.design.evaluation import Evaluator
from workbench.design.snapshot import History
from workbench.optics.kernels.ready import without_waiting

if TYPE_CHECKING:
    from workbench.design.snapshot import Result
    from workbench.files.session import Session


@dataclass(frozen=True, eq=False)
class Draft:
    """A lens in the making.

    Attributes
    ----------
    session : Session
        The design whose lens it is.
    heights : ndarray, shape (n_u, n_v)
        Its control heights, scene units.
    earlier : Result, optional
        The lens that was shaped.
    settled : bool
        Whether it is done, rather than on its way.
    """

    session: "Session"
    heights: npt.NDArray[np.float64]
    earlier: "Result | None" = None
    settled: bool = False


class LiveLens(QObject):
    """Traces drafts.

    Attributes
    ----------
    traced : Signal(Draft, Frame)
        What a draft looks like.
    failed : Signal(str)
        Why the last one cannot be shown.
    """

    traced = Signal(object, object)
    failed = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._background = Background("trace of the lens", self)
        self._background.done.connect(self._take)
        self._background.failed.connect(self._give_up)
        self._waiting: Draft | None = None
        self._asked: Draft | None = None
        self._evaluator: Evaluator | None = None

    def show(self, draft: Draft) -> None:
        """Trace a draft as soon as the one before is traced."""
        self._waiting = draft
        self._next()

    def forget(self) -> None:
        """Trace no more; the draft under way is not told of."""
        self._waiting = self._asked = None

    def close(self) -> None:
        """Wait for the thread; safe to call twice."""
        self.forget()
        self._background.close()

    def _next(self) -> None:
        if self._waiting is None or self._background.busy:
            return
        self._asked, self._waiting = self._waiting, None
        draft = self._asked
        self._background.begin(lambda: self._trace(draft))

    def _trace(self, draft: Draft) -> Frame:
        """Meant for the thread, which alone touches the evaluator."""
        # As for runs: one core stays the window's.
        torch.set_num_threads(max(1, QThread.idealThreadCount() - 1))
        session, heights = draft.session, draft.heights
        scene, locked = session.scene, session.locked
        with without_waiting():
            if self._evaluator is None or not self._evaluator.suits(scene, heights, locked):
                self._evaluator = Evaluator(scene, session.target, heights, locked)
            snapshot = self._evaluator.snapshot(heights, draft.earlier)
        return make_frame(session, snapshot, History(draft.earlier))

    def _take(self, frame: Frame) -> None:
        draft, self._asked = self._asked, None
        if draft is not None:
            self.traced.emit(draft, frame)
        self._next()

    def _give_up(self, sentence: str) -> None:
        draft, self._asked = self._asked, None
        if draft is not None and self._waiting is None:
            self.failed.emit(sentence)
        self._next()
