"""New, open, save, and the files that were open last."""

from collections.abc import Callable
from enum import Enum, auto
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QLocale, QObject, QSettings, Qt, Signal
from PySide6.QtWidgets import QAbstractButton, QMenu, QMessageBox, QWidget

from resources import Example
from ui.document.document import ENDING, Document, OnDisk
from ui.files.dialogs import FileDialogs
from ui.files.recovery import LeftBehind
from ui.run.control import LensOnShow
from ui.widgets.messages import MessageBar
from ui.words import error_text, later, tr
from workbench.errors import Refused
from workbench.files.session import Session, read_session

_RECENT_KEY = "recent_files"
_MOST_RECENT = 10


class RecentFiles:
    """A list of paths in the settings, the latest first."""

    def __init__(self, settings: QSettings) -> None:
        self._settings = settings

    def paths(self) -> list[Path]:
        """At most ten files; some may be gone by now."""
        stored = self._settings.value(_RECENT_KEY)
        if isinstance(stored, str):  # a list of one, as an ini file tells it
            return [Path(stored)]
        named = stored if isinstance(stored, list) else []
        return [Path(path) for path in named if isinstance(path, str)]

    def add(self, path: Path) -> None:
        """Put a file first."""
        path = path.absolute()
        self._store([path, *(other for other in self.paths() if other != path)])

    def remove(self, path: Path) -> None:
        """Forget a file."""
        self._store([other for other in self.paths() if other != path])

    def _store(self, paths: list[Path]) -> None:
        self._settings.setValue(_RECENT_KEY, [str(path) for path in paths[:_MOST_RECENT]])


class RecentMenu:
    """Has an action for each file."""

    def __init__(
        self, menu: QMenu, recent: RecentFiles, open_file: Callable[[Path], object]
    ) -> None:
        self._menu, self._recent, self._open_file = menu, recent, open_file
        self._shown: list[Path] = []

    def show(self, allowed: bool) -> None:
        """Name the files of now; whether they may be opened."""
        paths = self._recent.paths()
        if paths != self._shown:
            self._shown = paths
            self._menu.clear()
            for number, path in enumerate(paths, 1):
                text = f"&{number % 10} " + str(path).replace("&", "&&")  # a digit opens it
                self._menu.addAction(text, partial(self._open_file, path))
        for action in self._menu.actions():
            action.setEnabled(allowed)  # also in the palette, which asks no menu
        self._menu.setEnabled(allowed and bool(paths))


class ChangedFileChoice(Enum):
    """What to do about a file that is no longer what the design was read from or saved to."""

    OVERWRITE = auto()
    SAVE_AS = auto()
    RELOAD = auto()
    CANCEL = auto()


def ask_about_changed_file(path: Path, found: OnDisk, window: QWidget) -> ChangedFileChoice:
    """Put the question."""
    box = QMessageBox(window)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setTextFormat(Qt.TextFormat.PlainText)  # names of files may look like markup
    roles = QMessageBox.ButtonRole
    choices: dict[QAbstractButton, ChangedFileChoice] = {}
    if found is OnDisk.CHANGED:
        box.setWindowTitle(tr("The file has changed"))
        box.setText(
            tr("Another program has changed {name} since it was last read or saved here.").format(
                name=path.name
            )
        )
        box.setInformativeText(
            tr(
                "Overwrite loses what the file holds now. Reload shows it in place of "
                "your design; Undo brings your design back."
            )
        )
        choices[box.addButton(tr("&Overwrite"), roles.DestructiveRole)] = (
            ChangedFileChoice.OVERWRITE
        )
        choices[box.addButton(tr("&Reload"), roles.ActionRole)] = ChangedFileChoice.RELOAD
    else:
        box.setWindowTitle(tr("The file is gone"))
        box.setText(
            tr("{name} has been deleted, moved or renamed since it was last saved here.").format(
                name=path.name
            )
        )
        if path.parent.is_dir():
            choices[box.addButton(tr("&Save there again"), roles.ApplyRole)] = (
                ChangedFileChoice.OVERWRITE
            )
        else:
            box.setInformativeText(
                tr("Its folder, {parent}, is gone, too.").format(parent=path.parent)
            )
    save_as = box.addButton(tr("Save &as…"), roles.AcceptRole)
    choices[save_as] = ChangedFileChoice.SAVE_AS
    box.setDefaultButton(save_as)
    box.setEscapeButton(box.addButton(QMessageBox.StandardButton.Cancel))
    box.exec()
    choice = choices.get(box.clickedButton(), ChangedFileChoice.CANCEL)
    box.deleteLater()
    return choice


_OPENED = later("Designs and scenes ({endings});;All files (*)")
_SAVED = later("Designs ({endings})")
_KIND = "design"  # of files, for dialogs


class Answer(Enum):
    """What shall become of changes that would be lost."""

    SAVE = QMessageBox.StandardButton.Save
    DISCARD = QMessageBox.StandardButton.Discard
    CANCEL = QMessageBox.StandardButton.Cancel


class FileActions(QObject):
    """Takes the document to files and back."""

    opened = Signal()
    saved = Signal(str)
    recent_changed = Signal()

    def __init__(
        self,
        document: Document,
        lens: LensOnShow,
        recent: RecentFiles,
        messages: MessageBar,
        dialogs: FileDialogs,
        window: QWidget,
    ) -> None:
        super().__init__(window)
        self._document = document
        self._lens = lens
        self._recent = recent
        self._messages = messages
        self._dialogs = dialogs
        self._window = window
        self.find_other: Callable[[Path], QWidget | None] = lambda path: None
        self.offer: Callable[[Path], bool] = lambda path: False
        self.look: Callable[[], dict[str, Any] | None] = lambda: None

    def new(self, example: Example) -> bool:
        """Begin with an example, and say what to look for; False if not opened."""
        if not (self.may_leave() and self._attempt(lambda: self._document.open(example.file))):
            return False
        self.opened.emit()
        self._messages.note(tr(example.look))
        return True

    def begin(self, session: Session, name: str) -> bool:
        """Begin a new task, which can be undone; False if unsaved changes are to stay open."""
        if not self.may_leave():
            return False
        self._document.begin(session, name)
        self._messages.clear()
        self.opened.emit()
        return True

    def choose_and_open(self) -> None:
        """Ask for a file and open it."""
        path = self._dialogs.to_open(
            _KIND, tr("Open"), tr(_OPENED).format(endings=f"*{ENDING} *.json")
        )
        if path is not None:
            self.open(path)

    def open(self, path: Path) -> bool:
        """Open a file, unless changes would be lost that should not; False if not opened.

        A file that another window has open is shown there. What is a picture or a file of light is
        offered for the open design.
        """
        other = self.find_other(path)
        if other is not None:
            other.activateWindow()
            other.raise_()
            return False
        if self.offer(path):
            return False
        if not (self.may_leave() and self._attempt(lambda: self._document.open(path))):
            return False
        self.opened.emit()
        self._remember(path)
        return True

    def recover(self, work: LeftBehind) -> bool:
        """Go on with unsaved work; False if it cannot be read."""
        about = work.about

        def recover() -> None:
            session = read_session(work.file)
            self._document.recover(session, about.name, about.path, about.fingerprint)

        if not self._attempt(recover):
            return False
        self.opened.emit()
        return True

    def revert(self) -> None:
        """Go back to the file as it was saved."""
        self._attempt(self._document.revert)

    def open_recent(self, path: Path) -> None:
        """Open a file of the list, or strike it off the list if it is gone."""
        if path.exists():
            self.open(path)
            return
        self._recent.remove(path)
        self.recent_changed.emit()
        self._messages.warn(
            tr("{path} is no longer there; it was taken off the list.").format(path=path)
        )

    def save(self) -> bool:
        """Write the design to its file, asking for one where it has none; False if not saved."""
        path = self._document.path
        return self.save_as() if path is None else self._write(path)

    def save_as(self) -> bool:
        """Ask for a file and write the design to it; False if not saved."""
        path = self.ask_for_name()
        if path is None:
            return False
        if path.suffix != ENDING:  # adding it now might overwrite a file without a question
            self._messages.warn(
                tr("{name}: the name of a design ends in {ending}").format(
                    name=path.name, ending=ENDING
                )
            )
            return False
        return self._write(path)

    def ask_for_name(self) -> Path | None:
        """Ask where to save."""
        name = self._document.suggested_path.name
        return self._dialogs.to_save(
            _KIND, tr("Save as"), name, {tr(_SAVED).format(endings=f"*{ENDING}"): ENDING}
        )

    def may_leave(self) -> bool:
        """Whether the open design may be left, after saving it if a person wants that."""
        if not self._document.dirty:
            return True
        answer = self.ask(tr("Save the changes to {name}?").format(name=self._document.name))
        return answer is Answer.DISCARD or (answer is Answer.SAVE and self.save())

    def ask(self, question: str) -> Answer:
        """Put a question with the answers Save, Discard and Cancel."""
        buttons = Answer.SAVE.value | Answer.DISCARD.value | Answer.CANCEL.value
        given = QMessageBox.question(
            self._window, tr("Unsaved changes"), question, buttons, Answer.SAVE.value
        )
        return Answer(given)

    def _write(self, path: Path) -> bool:
        if self.find_other(path) is not None:  # which would not know of it
            self._messages.warn(
                tr("{name} is open in another window: choose another name.").format(name=path.name)
            )
            return False
        making = self._lens.in_the_making
        words = "" if making is None else tr(", with {lens}").format(lens=self._lens.text)
        try:
            found = self._document.on_disk(path)
            if found is not OnDisk.KNOWN:
                choice = ask_about_changed_file(path, found, self._window)
                if choice is not ChangedFileChoice.OVERWRITE:
                    return self._save_otherwise(choice)
            self._document.save(path, self.look(), making)
        except Refused as refused:
            self._messages.warn(error_text(refused), (tr("Save as…"), self.save_as))
            return False
        self._messages.clear()
        self._remember(path)
        size = QLocale.c().formattedDataSize(
            path.stat().st_size, 1, QLocale.DataSizeFormat.DataSizeSIFormat
        )
        self.saved.emit(
            tr("Saved {name}, {size}{words}").format(name=path.name, size=size, words=words)
        )
        return True

    def _save_otherwise(self, choice: ChangedFileChoice) -> bool:
        if choice is ChangedFileChoice.RELOAD:
            self.revert()
        return choice is ChangedFileChoice.SAVE_AS and self.save_as()

    def _attempt(self, action: Callable[[], None]) -> bool:
        try:
            action()
        except Refused as refused:
            self._messages.warn(error_text(refused))
            return False
        self._messages.clear()
        return True

    def _remember(self, path: Path) -> None:
        self._recent.add(path)
        self.recent_changed.emit()
