"""Says what a person should know of the target's image: whether it is kept, or has changed."""

from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.widgets.message_bar import MessageBar
from ui.words import error_text, tr
from workbench.design.picture import changed_on_disk, why_not_kept
from workbench.errors import Refused
from workbench.files.session import Session


class TargetImage(QObject):
    """Reports that the target's image is not stored, or has changed on disk."""

    def __init__(self, document: Document, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._messages = document, messages
        self._text = ""
        document.edited.connect(self._tell_of_edit)
        document.session_changed.connect(self._withdraw)

    def look(self) -> None:
        """Report on a design that was just opened."""
        session = self._document.session
        if self._document.path is None:  # drawn from its file a moment ago
            self._tell_if_not_kept(session)
            self._tell_remarks(session)
        self._tell_if_changed(session)

    def _tell_of_edit(self, before: Session, after: Session) -> None:
        if after.target is before.target:
            return
        if after.scene.image != before.scene.image:
            self._tell_if_not_kept(after)
        if after.picture_remarks != before.picture_remarks:
            self._tell_remarks(after)
        self._tell_if_changed(after)

    def _tell_if_not_kept(self, session: Session) -> None:
        why = why_not_kept(session.scene, session.picture)
        if why:
            self._messages.note(why)

    def _tell_remarks(self, session: Session) -> None:
        if session.picture_remarks:
            self._messages.note("; ".join(map(tr, session.picture_remarks)))

    def _tell_if_changed(self, session: Session) -> None:
        if changed_on_disk(session.scene, session.picture):
            self._text = tr(
                "{image} has changed. The design keeps the picture that it has."
            ).format(image=session.scene.image)
            self._messages.note(self._text, (tr("Read it again"), self._read_again))

    def _read_again(self) -> None:
        try:
            self._document.read_image_again()
        except Refused as refused:
            self._messages.warn(error_text(refused))

    def _withdraw(self) -> None:
        self._messages.withdraw(self._text)
