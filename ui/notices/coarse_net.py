"""Messages after a run: net too coarse, little light on the receiver, total reflection."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.panels.edits import Edit, edited_scene
from ui.widgets.message_bar import MessageBar
from ui.words import tr

if TYPE_CHECKING:
    from ui.run.control import RunControl


class CoarseNetNotice(QObject):
    """Reports after a run that the net is too coarse, and offers a finer one."""

    def __init__(
        self,
        document: Document,
        control: "RunControl",
        messages: MessageBar,
        start_over: Callable[[], object],
    ) -> None:
        super().__init__(control)
        self._document, self._messages, self._start_over = document, messages, start_over
        self._text = ""
        control.ended.connect(self._say)
        document.session_changed.connect(self._withdraw)

    def _say(self) -> None:
        # Late: torch comes with it, and the window shows before that.
        from workbench.design.coarse_net import coarse_net

        session = self._document.session
        if session.result is None or self._messages.taken:
            return
        coarse = coarse_net(session.scene, session.target, session.result)
        if coarse is not None:
            self._text = tr(coarse.sentence)
            self._messages.warn(self._text, (tr("Refine and start over"), self._refine))

    def _refine(self) -> None:
        scene = self._document.session.scene
        path = f"{scene.face_path()}.control_points"
        edit = Edit(path, tr("automatic control points"), {path: "auto"})
        self._document.edit(edited_scene(scene, [edit]), edit.text, "")
        self._start_over()

    def _withdraw(self) -> None:
        self._messages.withdraw(self._text)
        self._text = ""
