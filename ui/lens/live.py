"""The light of a lens that is shaped by hand, while it is shaped.

1. The latest lens wins: one is traced at a time, in a thread of its own, and of those that come
   meanwhile the last is next.
2. What a scene's trace needs is kept from lens to lens.
"""

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ui.background import Background, Task, sentence_of
from ui.shown.frame import Frame, make_frame
from ui.words import tr
from workbench.design.evaluation import Evaluator
from workbench.design.snapshot import History
from workbench.optics.ready import without_waiting

if TYPE_CHECKING:
    from workbench.design.snapshot import Result
    from workbench.files.session import Session
    from workbench.geometry.faces import ControlHeights


@dataclass(frozen=True, eq=False)
class Draft:
    """A lens in the making.

    Attributes
    ----------
    session : Session
        The design whose lens it is.
    heights : ControlHeights
        Its control heights, scene units.
    earlier : Result, optional
        The lens that was shaped.
    settled : bool
        Whether it is done, rather than on its way.
    """

    session: "Session"
    heights: "ControlHeights"
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
        self._background = Background("trace of the lens", self, finish_first=True)
        self._background.done.connect(self.traced)
        self._background.failed.connect(self._give_up)
        self._evaluator: Evaluator | None = None

    def show(self, draft: Draft) -> None:
        """Trace a draft as soon as the one before is traced."""
        self._background.begin(partial(self._trace, draft), draft)

    def forget(self) -> None:
        """Trace no more; nothing comes of the draft under way."""
        self._background.cancel()

    def close(self) -> None:
        """Wait for the thread; safe to call twice."""
        self._background.close()

    def _trace(self, draft: Draft, task: Task) -> Frame:
        """Meant for the thread, which alone touches the evaluator."""
        session, heights = draft.session, draft.heights
        scene, target = session.scene, session.target
        with without_waiting():
            there = self._evaluator
            if there is None or not there.suits(scene, target):
                self._evaluator = there = Evaluator(scene, target, heights)
            snapshot = there.snapshot(heights, draft.earlier)
        return make_frame(session, snapshot, History(draft.earlier))

    def _give_up(self, draft: Draft, error: Exception) -> None:
        if not self._background.busy:  # else a later draft is traced
            called = draft.session.scene.optic.called
            self.failed.emit(sentence_of(error, tr("trace of the {optic}", optic=called)))
