"""File dialogs, and files that a person chooses, drops or pastes for the design."""

import hashlib
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path

from PySide6.QtCore import QBuffer, QIODevice, QObject, QSettings, QStandardPaths
from PySide6.QtGui import QGuiApplication, QImage, QImageWriter
from PySide6.QtWidgets import QFileDialog, QWidget

from ui.background import Background
from ui.document.document import ENDING, Document
from ui.panels.forms import Forms
from ui.panels.images import image_files, is_image_file
from ui.panels.scene import is_light_file, light_files
from ui.widgets.messages import Messages
from ui.words import error_text, tr
from workbench.errors import Refused
from workbench.files.atomic import replacing

_KEY = "folders"


class FileDialogs(QObject):
    """Asks for files of a document; messages report what became of them.

    A dialog starts in the folder used last for its kind of file, the folder of the design, or the
    folder that any window used last.
    """

    def __init__(
        self, document: Document, messages: Messages, settings: QSettings, window: QWidget
    ) -> None:
        super().__init__(window)
        self.document, self.messages, self.window = document, messages, window
        self._settings = settings
        self.chosen = ""
        self._used: dict[str, Path] = {}
        self._own = document.folder
        document.path_changed.connect(self._follow)

    def to_open(self, kind: str, title: str, filters: str) -> Path | None:
        begin = str(self._begin(kind))
        chosen, _ = QFileDialog.getOpenFileName(self.window, title, begin, filters)
        return self._note(kind, Path(chosen)) if chosen else None

    def picture(self, title: str) -> Path | None:
        return self.to_open("image", title, image_files())

    def light(self) -> Path | None:
        return self.to_open("light", tr("File of light"), light_files())

    def to_open_several(self, kind: str, title: str, filters: str) -> list[Path]:
        begin = str(self._begin(kind))
        chosen, _ = QFileDialog.getOpenFileNames(self.window, title, begin, filters)
        return [self._note(kind, Path(each)) for each in chosen]

    def to_save(self, kind: str, title: str, name: str, endings: Mapping[str, str]) -> Path | None:
        """Ask for a file to write; a name without an ending gets that of the chosen filter."""
        dialog = QFileDialog(self.window, title, str(self._begin(kind)))
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setNameFilters(list(endings))

        def suggest(chosen: str) -> None:
            dialog.setDefaultSuffix(endings[chosen].removeprefix("."))

        dialog.filterSelected.connect(suggest)
        suggest(dialog.selectedNameFilter())
        dialog.selectFile(name)
        accepted = dialog.exec()
        dialog.deleteLater()  # else it lives as long as the window
        self.chosen = dialog.selectedNameFilter()
        return self._note(kind, Path(dialog.selectedFiles()[0])) if accepted else None

    def _begin(self, kind: str) -> Path:
        return next((folder for folder in self._folders(kind) if folder.is_dir()), Path.home())

    def _folders(self, kind: str) -> Iterator[Path]:
        kept = self._settings.value(f"{_KEY}/{kind}")
        found = self._used.get(kind), self._own, Path(kept) if isinstance(kept, str) else None
        yield from (folder for folder in found if folder is not None)
        documents = QStandardPaths.StandardLocation.DocumentsLocation
        yield Path(QStandardPaths.writableLocation(documents))

    def _note(self, kind: str, path: Path) -> Path:
        self._used[kind] = path.parent
        self._settings.setValue(f"{_KEY}/{kind}", str(path.parent))
        return path

    def _follow(self) -> None:
        if self.document.folder != self._own:
            self._own = self.document.folder
            self._used.clear()


class FileWriter(QObject):
    """Writes files in a thread, one at a time."""

    _WORK = ""  # name of the work, in English

    def __init__(self, dialogs: FileDialogs) -> None:
        super().__init__(dialogs)
        self._dialogs, self._document, self._messages = dialogs, dialogs.document, dialogs.messages
        self.background = Background(self._WORK, self)
        self.background.failed.connect(self._messages.warn)


def png_bytes(image: QImage) -> bytes:
    """Return an image as the content of a PNG file."""
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, b"png").write(image)
    return bytes(buffer.data().data())


def pasted_picture(folder: Path) -> Path | None:
    """Return the file of the picture on the clipboard, written to a folder if needed; or None."""
    copied = QGuiApplication.clipboard().mimeData()
    files = [Path(url.toLocalFile()) for url in copied.urls() if url.isLocalFile()]
    if files:
        return files[0]
    image = QGuiApplication.clipboard().image()
    if image.isNull():
        return None
    content = png_bytes(image)
    path = folder / f"pasted-{hashlib.sha256(content).hexdigest()[:12]}.png"
    folder.mkdir(parents=True, exist_ok=True)
    with replacing(path) as file:
        file.write(content)
    return path


class ChosenFiles(QObject):
    """Files that a person chooses, drops or pastes for target and source."""

    def __init__(self, forms: Forms, dialogs: FileDialogs) -> None:
        super().__init__(dialogs)
        self._forms, self._dialogs, self._messages = forms, dialogs, dialogs.messages
        self.use_picture: Callable[[Path], object] = forms.choose_image
        self.use_light: Callable[[Path], object] = forms.choose_light
        self.ask = True  # before a file that is opened is used in the design
        forms.file_asked.connect(self._choose)

    def slots(self) -> dict[str, Callable[[], object]]:
        return {"paste_picture": self.paste}

    def take(self, path: Path) -> bool:
        """Use a light file or picture in the design; False for a design or scene."""
        if is_light_file(path):
            self.use_light(path)
        elif path.suffix.lower() in (ENDING, ".json"):
            return False
        else:
            self.use_picture(path)
        return True

    def offer(self, path: Path) -> bool:
        """Offer to use a picture or light file; False for other files."""
        if not path.is_file() or not (is_light_file(path) or is_image_file(path)):
            return False
        if not self.ask:
            return self.take(path)
        sentence, action = (
            (tr("{name} is a file of light, not a design."), tr("Use as light source"))
            if is_light_file(path)
            else (tr("{name} is a picture, not a design."), tr("Use as target"))
        )
        self._messages.note(sentence.format(name=path.name), (action, partial(self.take, path)))
        return True

    def paste(self) -> None:
        folder = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppDataLocation)
        try:
            path = pasted_picture(Path(folder) / "pasted")
        except Refused as refused:
            self._messages.warn(error_text(refused))
            return
        if path is None:
            self._messages.note(tr("There is no picture on the clipboard."))
        else:
            self.use_picture(path)

    def _choose(self, where: str) -> None:
        if where == "source":
            if (path := self._dialogs.light()) is not None:
                self._forms.choose_light(path)
        elif (path := self._dialogs.picture(tr("Target image"))) is not None:
            self._forms.choose_image(path, where)
