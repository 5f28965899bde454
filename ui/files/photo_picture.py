"""Takes the predicted photo to a file."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.files.dialogs import FileDialogs
from ui.widgets.message_bar import MessageBar
from ui.words import error_text, tr
from workbench.errors import Refused
from workbench.files.atomic import replacing

if TYPE_CHECKING:
    from pathlib import Path

    from ui.views.photo_view import PhotoView

_ENDING = ".png"


class PhotoPicture(QObject):
    """Saves the photo that is seen, with its exposure.

    Parameters
    ----------
    view : PhotoView
        What shows it.
    document : Document
        Gives the name of the file.
    messages : MessageBar
        Tells what was done, or why not.
    dialogs : FileDialogs
        Ask for the file.
    show : callable
        Brings the view to the front, where photos are taken.
    """

    def __init__(
        self,
        view: "PhotoView",
        document: Document,
        messages: MessageBar,
        dialogs: FileDialogs,
        show: Callable[[], object],
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._view, self._document = view, document
        self._messages, self._dialogs, self._show = messages, dialogs, show

    def slots(self) -> dict[str, Callable[[], object]]:
        """What commands do here."""
        return {"save_photo": self.choose_and_save}

    def choose_and_save(self) -> None:
        """Ask for a file and save the photo there; where there is none yet, let it be predicted."""
        if self._view.photo is None:
            self._show()
            self._messages.note(tr("There is no photo of this lens yet; save it once it is seen."))
            return
        name = tr("{design} photo").format(design=self._document.name)
        filters = {tr("Picture ({endings})").format(endings=f"*{_ENDING}"): _ENDING}
        path = self._dialogs.to_save("plot", tr("Save predicted photo"), name, filters)
        if path is not None:
            self.save(path)

    def save(self, path: "Path") -> None:
        """Save the photo as PNG."""
        # Late: what it stands on is slow to import.
        from workbench.analysis.photo.photo import write_png

        photo = self._view.photo
        if photo is None:  # the lens has changed while the dialog stood
            self._messages.note(tr("The lens has changed since; save the photo of the new one."))
            return
        try:
            with replacing(path) as file:
                write_png(photo, self._view.stops, file)
        except Refused as refused:
            self._messages.warn(error_text(refused))
        else:
            self._messages.done(tr("{path} is written.").format(path=path))
