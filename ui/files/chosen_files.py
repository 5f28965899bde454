"""Files and pictures that a person chooses or pastes for the design: its target, its light."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, QStandardPaths

from ui.document.document import ENDING
from ui.files.dialogs import FileDialogs
from ui.files.pasted import pasted_picture
from ui.panels.forms import Forms
from ui.panels.source import is_light_file, light_files
from ui.panels.target import image_files, is_image_file
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

    def take(self, path: Path) -> bool:
        """Take a file of light or a picture into the design; False for a design or scene."""
        if is_light_file(path):
            self._forms.choose_light(path)
        elif path.suffix.lower() in (ENDING, ".json"):
            return False
        else:
            self._forms.choose_image(path)
        return True

    def offer(self, path: Path) -> bool:
        """Offer to take a file that is no design; whether it is a picture or a file of light."""
        if not path.is_file() or not (is_light_file(path) or is_image_file(path)):
            return False
        sentence, action = (
            (tr("{name} is a file of light, not a design."), tr("Use as light source"))
            if is_light_file(path)
            else (tr("{name} is a picture, not a design."), tr("Use as target"))
        )

        def accept() -> None:
            self._messages.clear()
            self.take(path)

        self._messages.note(sentence.format(name=path.name), (action, accept))
        return True

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
