"""Says which fields are refused when a run cannot begin for them."""

from PySide6.QtCore import QObject

from ui.panels.forms import Forms
from ui.widgets.message_bar import MessageBar
from ui.words import tr


class RefusedFields(QObject):
    """Reports refused fields, as long as there are any."""

    def __init__(self, forms: Forms, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._forms, self._messages = forms, messages
        self._text = ""
        forms.refusals_changed.connect(self._follow)

    def tell(self) -> None:
        """Report which fields need a correction."""
        count = len(self._forms.refusals)
        first = self._forms.refusals[0]
        others = tr(" ({count} more refused)").format(count=count - 1) if count > 1 else ""
        self._text = tr("{first}{others}. Correct it, or press Esc, first.").format(
            first=first, others=others
        )
        self._messages.warn(self._text)

    def _follow(self) -> None:
        if self._text and self._messages.text == self._text:
            if self._forms.refusals:
                self.tell()
            else:
                self._messages.clear()
