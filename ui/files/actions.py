"""New, open and save: dialogs, refusals and the question before changes are lost."""

from collections.abc import Callable
from enum import Enum
from pathlib import Path
from typing import Any

from PySide6.QtCore import QLocale, QObject, Signal
from PySide6.QtWidgets import QMessageBox, QWidget

from resources import Example
from ui.document.document import ENDING, Document, OnDisk
from ui.files import changed
from ui.files.dialogs import FileDialogs
from ui.files.left_behind import LeftBehind
from ui.files.recent import RecentFiles
from ui.run.lens_on_show import LensOnShow
from ui.widgets.message_bar import MessageBar
from ui.words import error_text, later, tr
from workbench.errors import Refused
from workbench.files.session import Session, read_session

_OPENED = later("Designs and scenes ({endings});;All files (*)")
_SAVED = later("Designs ({endings})")
_KIND = "design"  # of files, for dialogs


class Answer(Enum):
    """What shall become of changes that would be lost."""

    SAVE = QMessageBox.StandardButton.Save
    DISCARD = QMessageBox.StandardButton.Discard
    CANCEL = QMessageBox.StandardButton.Cancel


class FileActions(QObject):
    """Takes the document to files and back.

    Attributes
    ----------
    find_other : callable
        The window, other than this one, in which a file is open; None where there is none.
    look : callable
        How the design is looked at, for the file.
    opened : Signal()
        Another design is open.
    saved : Signal(str)
        What was saved, in a sentence.
    recent_changed : Signal()
        The list of files used last is another.
    """

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
                choice = changed.ask(path, found, self._window)
                if choice is not changed.ChangedFileChoice.OVERWRITE:
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

    def _save_otherwise(self, choice: changed.ChangedFileChoice) -> bool:
        """Save elsewhere or not at all; False if not saved."""
        if choice is changed.ChangedFileChoice.RELOAD:
            self.revert()
        return choice is changed.ChangedFileChoice.SAVE_AS and self.save_as()

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
