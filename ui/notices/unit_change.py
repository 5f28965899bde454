"""Says that a change of the unit converted all lengths, and offers to keep the numbers."""

from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.widgets.message_bar import MessageBar
from ui.words import tr
from workbench.files.session import Session
from workbench.units import ratio


class UnitChange(QObject):
    """Reports that a change of unit converted all lengths, and offers to keep the numbers."""

    def __init__(self, document: Document, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._messages = document, messages
        self._after: Session | None = None
        self._text = ""
        document.edited.connect(self._tell)
        document.session_changed.connect(self._withdraw)

    def _tell(self, before: Session, after: Session) -> None:
        old, new = before.scene.unit, after.scene.unit
        if old == new:
            return
        self._after = after
        self._text = tr("All lengths are converted: 1 {old} is {ratio:.6g} {new} now.").format(
            old=old, ratio=float(ratio(old, new)), new=new
        )
        self._messages.note(
            self._text, (tr("Keep the numbers"), lambda: self._keep_numbers(before, after))
        )

    def _keep_numbers(self, before: Session, after: Session) -> None:
        scene = before.scene.model_copy(update={"unit": after.scene.unit})
        self._document.change(before.with_scene(scene, before.target), tr("change of unit alone"))

    def _withdraw(self, session: Session) -> None:
        if session is not self._after:
            self._messages.withdraw(self._text)
