"""Files and pictures that a person chooses or pastes for the design: its target, its light."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, QStandardPaths

from ui.files.dialogs import FileDialogs
from ui.files.pasted import pasted_picture
from ui.panels.forms import Forms
from ui.panels.source import light_files
from ui.panels.target import image_files
from ui.widgets.message_bar import MessageBar
from ui.words import error_text, tr
from workbench.errors import Refused


class ChosenFiles(QObject):
    """Asks for files where the forms want them, and takes pictures from the clipboard."""

    def __init__(
        self, forms: Forms, dialogs: FileDialogs, messages: MessageBar, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._forms, self._dialogs, self._messages = forms, dialogs, messages
        forms.image_asked.connect(self._choose_image)
        forms.light_asked.connect(self._choose_light)

    def slots(self) -> dict[str, Callable[[], object]]:
        """What commands do here."""
        return {"paste_picture": self.paste}

    def paste(self) -> None:
        """Make the picture on the clipboard the target."""
        folder = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppDataLocation)
        try:
            path = pasted_picture(Path(folder) / "pasted")
        except Refused as refused:
            self._messages.warn(error_text(refused))
            return
        if path is None:
            self._messages.note(tr("There is no picture on the clipboard."))
        else:
            self._forms.choose_image(path)

    def _choose_image(self) -> None:
        path = self._dialogs.to_open("image", tr("Target image"), image_files())
        if path is not None:
            self._forms.choose_image(path)

    def _choose_light(self) -> None:
        path = self._dialogs.to_open("light", tr("File of light"), light_files())
        if path is not None:
            self._forms.choose_light(path)
