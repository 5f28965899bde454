"""Messages about edits: postponed by a run, refused, changes of target image and unit."""

from PySide6.QtCore import QObject

from ui.panels.forms import Forms
from ui.run.control import RunControl
from ui.widgets.message_bar import MessageBar
from ui.words import tr


class PostponedEdits(QObject):
    """Reports which edits wait for the end of a run, and offers to stop it."""

    def __init__(
        self, forms: Forms, control: RunControl, messages: MessageBar, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._forms, self._control, self._messages = forms, control, messages
        self._text = ""
        forms.postponed.connect(self._offer)

    def make(self) -> None:
        """Apply the edits after the run."""
        self._withdraw()
        self._forms.make_postponed_edits()

    def remind(self, sentence: str) -> None:
        """Show a sentence, and that edits still wait."""
        self._offer(f"{sentence} {self._forms.postponed_text}")

    def _offer(self, sentence: str) -> None:
        self._text = sentence
        stop = self._control.runner.stop
        self._messages.note(
            sentence, (tr("Stop and apply"), stop), (tr("Take back"), self._take_back)
        )

    def _take_back(self) -> None:
        self._withdraw()
        self._forms.drop_postponed_edits()

    def _withdraw(self) -> None:
        self._messages.withdraw(self._text)
