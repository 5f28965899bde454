"""Dialogs that ask for a file, each kind of file where such a file was last."""

from collections.abc import Iterator, Mapping
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, QStandardPaths
from PySide6.QtWidgets import QFileDialog, QWidget

from ui.document.document import Document

_KEY = "folders"


class FileDialogs(QObject):
    """Asks for files.

    A dialog begins in the folder that was used last for its kind of file since the design was
    opened or saved elsewhere; else in the design's own; for a design without one, in the folder
    that was used last for this kind of file by whatever window.

    Attributes
    ----------
    chosen : str
        Filter that was chosen in the last dialog for a file to write.
    """

    def __init__(self, document: Document, settings: QSettings, window: QWidget) -> None:
        super().__init__(window)
        self._document, self._settings, self._window = document, settings, window
        self.chosen = ""
        self._used: dict[str, Path] = {}
        self._own = document.folder
        document.path_changed.connect(self._follow)

    def to_open(self, kind: str, title: str, filters: str) -> Path | None:
        """Ask for a file that is there.

        Parameters
        ----------
        kind : str
            Kind of file, for the folder.
        title : str
            Of the dialog.
        filters : str
            Names of files to choose from, as Qt writes them.
        """
        begin = str(self._begin(kind))
        chosen, _ = QFileDialog.getOpenFileName(self._window, title, begin, filters)
        return self._note(kind, Path(chosen)) if chosen else None

    def to_save(self, kind: str, title: str, name: str, endings: Mapping[str, str]) -> Path | None:
        """Ask for a file to write; a name without an ending gets that of the chosen filter.

        Parameters
        ----------
        kind, title
            As for `to_open`.
        name : str
            Suggestion for the name of the file.
        endings : mapping of str to str
            What may be chosen, as Qt's filters, and the ending of each.
        """
        dialog = QFileDialog(self._window, title, str(self._begin(kind)))
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        dialog.setNameFilters(list(endings))

        def suggest(chosen: str) -> None:
            dialog.setDefaultSuffix(endings[chosen].removeprefix("."))

        dialog.filterSelected.connect(suggest)
        suggest(dialog.selectedNameFilter())
        dialog.selectFile(name)
        accepted = dialog.exec()
        self.chosen = dialog.selectedNameFilter()
        return self._note(kind, Path(dialog.selectedFiles()[0])) if accepted else None

    def _begin(self, kind: str) -> Path:
        return next((folder for folder in self._folders(kind) if folder.is_dir()), Path.home())

    def _folders(self, kind: str) -> Iterator[Path]:
        """The one that suits best first; some may be gone by now."""
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
        """Another folder of the design is where a person works now."""
        if self._document.folder != self._own:
            self._own = self._document.folder
            self._used.clear()
