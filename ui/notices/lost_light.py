"""Says after a run why little light comes to the receiver, and what would help."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.widgets.message_bar import MessageBar
from ui.words import tr

if TYPE_CHECKING:
    from ui.run.control import RunControl


class LostLightNotice(QObject):
    """Reports after a run why little light reaches the receiver, and a remedy."""

    def __init__(self, document: Document, control: "RunControl", messages: MessageBar) -> None:
        super().__init__(control)
        self._document, self._messages = document, messages
        self._text = ""
        control.ended.connect(self.say)
        document.session_changed.connect(self._withdraw)

    def say(self) -> None:
        """Report it for the lens of the document."""
        scene, result = self._document.session.scene, self._document.session.result
        advice = None if result is None else result.state.account.advice(scene)
        self._text = "" if advice is None else tr(advice)
        if self._text and not self._messages.taken:
            self._messages.warn(self._text)

    def _withdraw(self) -> None:
        self._messages.withdraw(self._text)
        self._text = ""
