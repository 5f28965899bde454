"""Says where light of a finished lens is totally reflected, and shows it in the 3D scene."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ui.document.document import Document
from ui.threads.background import Background, Task
from ui.threads.failure import sentence_of
from ui.views.scene_view import SceneView
from ui.words import tr
from workbench.optics.account import LOSSES
from workbench.said import Said

if TYPE_CHECKING:
    from ui.run.control import RunControl
    from workbench.files.session import Session
    from workbench.optics.total_reflection import TotalReflection

_LEAST = 1e-6  # of the light; less is rounding


class TotalReflectionNotice(QObject):
    """Reports after a run where light is totally reflected, and marks it in the 3D view."""

    said = Signal(str)

    def __init__(self, document: Document, control: "RunControl", view: SceneView) -> None:
        super().__init__(control)
        self._document, self._view = document, view
        self._background = Background("search for total reflection", self)
        self._background.done.connect(self._take)
        self._background.failed.connect(self._give_up)
        control.ended.connect(self.look)
        document.session_changed.connect(self._forget)

    def look(self) -> None:
        """Search in the lens of the document."""
        session = self._document.session
        result = session.result
        lost = {} if result is None else result.state.account.lost
        if lost.get("total_reflection", 0.0) > _LEAST:
            self._background.begin(partial(_find, session), session)

    def close(self) -> None:
        """Wait for the thread; safe to call twice."""
        self._background.close()

    def _take(self, session: "Session", found: "TotalReflection | None") -> None:
        heights = session.heights
        if found is None or heights is None:
            return
        self._view.show_spots(heights, found.places)
        said = Said(
            "{where}, as marked in the 3D scene: {cure}.",
            where=found.sentence(session.scene),
            cure=LOSSES["total_reflection"].cure_in(session.scene),
        )
        self.said.emit(tr(said))

    def _give_up(self, session: "Session", error: Exception) -> None:
        self.said.emit(sentence_of(error, tr("search for total reflection")))

    def _forget(self) -> None:
        self._background.cancel()


def _find(session: "Session", task: Task) -> "TotalReflection | None":
    # Late: torch comes with it, and the window shows before that.
    from workbench.optics.total_reflection import total_reflection

    heights = session.heights
    return None if heights is None else total_reflection(session.scene, heights)
