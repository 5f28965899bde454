"""Says after a run why little light comes to the receiver, and what would help."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.widgets.message_bar import MessageBar
from ui.words import tr

if TYPE_CHECKING:
    from ui.run.control import RunControl


class LostLightNotice(QObject):
    """Listens to the runs of a window.

    Parameters
    ----------
    document : Document
        What is designed.
    control : RunControl
        Its runs; the notice goes with it.
    messages : MessageBar
        Gets what is said, unless something else is to be read there.
    """

    def __init__(self, document: Document, control: "RunControl", messages: MessageBar) -> None:
        super().__init__(control)
        self._document, self._messages = document, messages
        self._text = ""
        control.ended.connect(self.say)
        document.session_changed.connect(self._withdraw)

    def say(self) -> None:
        """Say it of the lens that the document has."""
        scene, result = self._document.session.scene, self._document.session.result
        advice = None if result is None else result.state.account.advice(scene)
        self._text = "" if advice is None else tr(advice)
        if self._text and not self._messages.taken:
            self._messages.warn(self._text)

    def _withdraw(self) -> None:
        """It was said of a lens that is another one now, or of another task."""
        self._messages.withdraw(self._text)
        self._text = ""
