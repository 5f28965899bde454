"""New, open, save, and the files that were open last."""

from collections.abc import Callable
from enum import Enum, auto
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QLocale, QObject, QSettings, Signal
from PySide6.QtWidgets import QMenu, QMessageBox, QWidget

from resources import Example
from ui.document.document import ENDING, OnDisk
from ui.files.dialogs import FileDialogs
from ui.files.recovery import LeftBehind
from ui.run.control import CurrentLens
from ui.widgets.messages import question
from ui.words import error_text, later, tr
from workbench.errors import Refused
from workbench.files.session import Session, read_session

_RECENT_KEY = "recent_files"
_MOST_RECENT = 10


class RecentFiles:
    """A list of paths in the settings, the latest first."""

    def __init__(self, settings: QSettings) -> None:
        self._settings = settings
        self._offered: list[Path] = []

    def paths(self) -> list[Path]:
        """At most ten files; some may be gone by now."""
        stored = self._settings.value(_RECENT_KEY)
        if isinstance(stored, str):  # a list of one, as an ini file returns it
            return [Path(stored)]
        named = stored if isinstance(stored, list) else []
        return [Path(path) for path in named if isinstance(path, str)]

    def add(self, path: Path) -> None:
        path = path.absolute()
        self._store([path, *(other for other in self.paths() if other != path)])

    def remove(self, path: Path) -> None:
        self._store([other for other in self.paths() if other != path])

    def fill(self, menu: QMenu, open_file: Callable[[Path], object], allowed: bool) -> None:
        """Offer the files in a menu, if they may be opened now."""
        paths = self.paths()
        if paths != self._offered:
            self._offered = paths
            menu.clear()
            for number, path in enumerate(paths, 1):
                text = f"&{number % 10} " + str(path).replace("&", "&&")  # a digit opens it
                menu.addAction(text, partial(open_file, path))
        for action in menu.actions():
            action.setEnabled(allowed)  # also in the palette, which asks no menu
        menu.setEnabled(allowed and bool(paths))

    def _store(self, paths: list[Path]) -> None:
        self._settings.setValue(_RECENT_KEY, [str(path) for path in paths[:_MOST_RECENT]])


class ChangedFileChoice(Enum):
    """Answer for a file that has changed on disk."""

    OVERWRITE = auto()
    SAVE_AS = auto()
    RELOAD = auto()
    CANCEL = auto()


def ask_about_changed_file(path: Path, found: OnDisk, window: QWidget) -> ChangedFileChoice:
    """Ask what saving should do about a changed file."""
    roles, name = QMessageBox.ButtonRole, path.name
    save_as = (tr("Save &as…"), roles.AcceptRole, ChangedFileChoice.SAVE_AS)
    cancel = (tr("Cancel"), roles.RejectRole, ChangedFileChoice.CANCEL)
    if found is OnDisk.CHANGED:
        texts = (
            tr("The file has changed"),
            tr("Another program has changed {name}.").format(name=name),
            tr("Overwrite discards its changes. Reload discards yours; Undo restores them."),
        )
        overwrite = (tr("&Overwrite"), roles.DestructiveRole, ChangedFileChoice.OVERWRITE)
        reload = (tr("&Reload"), roles.ActionRole, ChangedFileChoice.RELOAD)
        answers = [overwrite, reload, save_as, cancel]
    else:
        here, answers = path.parent.is_dir(), [save_as, cancel]
        texts = (
            tr("The file is missing"),
            tr("{name} was deleted, moved or renamed.").format(name=name),
            "" if here else tr("Its folder is missing too: {parent}").format(parent=path.parent),
        )
        if here:
            again = (tr("&Save there again"), roles.ApplyRole, ChangedFileChoice.OVERWRITE)
            answers.insert(0, again)
    return question(window, QMessageBox.Icon.Warning, texts, answers)


_OPENED = later("Designs and scenes ({endings});;All files (*)")
_SAVED = later("Designs ({endings})")
_KIND = "design"  # of files, for dialogs


Answer = QMessageBox.StandardButton
"""Answers about unsaved changes: to save or to discard them, or to cancel."""


class FileActions(QObject):
    """New, open and save."""

    opened = Signal()
    saved = Signal(str)
    recent_changed = Signal()

    def __init__(self, lens: CurrentLens, recent: RecentFiles, dialogs: FileDialogs) -> None:
        super().__init__(dialogs)
        self._lens, self._recent = lens, recent
        self._dialogs, self._document, self._messages = dialogs, dialogs.document, dialogs.messages
        self.find_other: Callable[[Path], QWidget | None] = lambda path: None
        self.offer: Callable[[Path], bool] = lambda path: False
        self.view_data: Callable[[], dict[str, Any] | None] = lambda: None

    def new(self, example: Example) -> bool:
        """Open an example and show its hint; False if not opened."""
        if not (self.may_leave() and self._attempt(lambda: self._document.open(example.file))):
            return False
        self.opened.emit()
        self._messages.note(tr(example.look))
        return True

    def begin(self, session: Session, name: str) -> bool:
        """Open a new task as an undoable step; False if cancelled."""
        if not self.may_leave():
            return False
        self._document.begin(session, name)
        self._messages.clear()
        self.opened.emit()
        return True

    def choose_and_open(self) -> None:
        path = self._dialogs.to_open(
            _KIND, tr("Open"), tr(_OPENED).format(endings=f"*{ENDING} *.json")
        )
        if path is not None:
            self.open(path)

    def open(self, path: Path) -> bool:
        """Open a file after asking about unsaved changes; False if not opened.

        A file of another window is shown there; pictures and light files are offered for the
        design.
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
        """Open unsaved work; False if it cannot be read."""
        about = work.about

        def recover() -> None:
            session = read_session(work.file)
            self._document.recover(session, about.name, about.path, about.fingerprint)

        if not self._attempt(recover):
            return False
        self.opened.emit()
        return True

    def revert(self) -> None:
        self._attempt(self._document.revert)

    def open_recent(self, path: Path) -> None:
        """Open a file of the list, or remove a missing one."""
        if path.exists():
            self.open(path)
            return
        self._recent.remove(path)
        self.recent_changed.emit()
        self._messages.warn(
            tr("{path} no longer exists; it was removed from the list.").format(path=path)
        )

    def save(self) -> bool:
        """Write the design to its file, asking for one where it has none; False if not saved."""
        path = self._document.path
        return self.save_as() if path is None else self._write(path)

    def save_as(self) -> bool:
        """Ask for a file and write the design to it; False if not saved."""
        name = self._document.suggested_path.name
        endings = {tr(_SAVED).format(endings=f"*{ENDING}"): ENDING}
        path = self._dialogs.to_save(_KIND, tr("Save as"), name, endings)
        if path is None:
            return False
        if path.suffix != ENDING:  # adding it now might overwrite a file without a question
            self._messages.warn(
                tr("{name}: a design file ends in {ending}").format(name=path.name, ending=ENDING)
            )
            return False
        return self._write(path)

    def may_leave(self) -> bool:
        """Ask about unsaved changes; False if cancelled or not saved."""
        if not self._document.dirty:
            return True
        answer = self.ask(tr("Save the changes to {name}?").format(name=self._document.name))
        return answer == Answer.Discard or (answer == Answer.Save and self.save())

    def ask(self, question: str) -> Answer:
        buttons = Answer.Save | Answer.Discard | Answer.Cancel
        # A program that is ended closes it without one of them.
        return QMessageBox.question(
            self._dialogs.window, tr("Unsaved changes"), question, buttons, Answer.Save
        )

    def _write(self, path: Path) -> bool:
        if self.find_other(path) is not None:  # which would not know of it
            self._messages.warn(
                tr("{name} is open in another window. Choose another name.").format(name=path.name)
            )
            return False
        making = self._lens.in_the_making
        words = "" if making is None else tr(", with {lens}").format(lens=self._lens.text)
        try:
            found = self._document.on_disk(path)
            if found is not OnDisk.KNOWN:
                choice = ask_about_changed_file(path, found, self._dialogs.window)
                if choice is not ChangedFileChoice.OVERWRITE:
                    return self._save_otherwise(choice)
            self._document.save(path, self.view_data(), making)
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
