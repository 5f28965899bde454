"""Unsaved work of windows that were not closed: found at the next start, and offered there.

Each window keeps a session file, says in a small file beside it what is in it, and holds a lock.
"""

import json
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from datetime import datetime
from enum import Enum, auto
from pathlib import Path

from PySide6.QtCore import QLockFile, Qt
from PySide6.QtWidgets import QMessageBox, QWidget

from ui.document.document import ENDING
from ui.words import tr
from workbench.files.atomic import remove_left_behind, replacing


@dataclass(frozen=True)
class About:
    """What is said of a session beside it.

    Attributes
    ----------
    name : str
        What the title called the design.
    path : Path, optional
        The file that saving wrote.
    fingerprint : str, optional
        Of that file when the design was last read from it or written to it.
    ended : bool
        Whether the program was asked to end, as at the end of a login; otherwise it broke off.
    """

    name: str
    path: Path | None = None
    fingerprint: str | None = None
    ended: bool = False

    @classmethod
    def read(cls, file: Path) -> "About":
        """Read it; where it is lost or damaged, the session itself is what counts."""
        try:
            about = json.loads(file.read_bytes())
            path, name, ended = about["path"], str(about["name"]), bool(about.get("ended"))
            return cls(name, None if path is None else Path(path), about.get("fingerprint"), ended)
        except (OSError, ValueError, KeyError, TypeError, AttributeError):
            return cls("recovered")

    def write(self, file: Path) -> None:
        """Write it.

        Raises
        ------
        Refused
            If that is not possible.
        """
        path = None if self.path is None else str(self.path)
        with replacing(file) as content:
            content.write(json.dumps(asdict(self) | {"path": path}).encode())


@dataclass(frozen=True)
class LeftBehind:
    """Work of a window that was not closed; nobody else is offered it meanwhile.

    Attributes
    ----------
    file : Path
        The session.
    about : About
        What is known of it.
    """

    file: Path
    about: About
    lock: QLockFile

    @property
    def kept_at(self) -> datetime:
        """When it was written."""
        return datetime.fromtimestamp(self.file.stat().st_mtime)

    def remove(self) -> None:
        """Nobody needs it any more; where it cannot be removed, the next start asks again."""
        for file in (self.file, about_of(self.file)):
            with suppress(OSError):
                file.unlink(missing_ok=True)
            remove_left_behind(file)
        self.lock.unlock()

    def put_back(self) -> None:
        """Let another start find it."""
        self.lock.unlock()


def find(folder: Path) -> list[LeftBehind]:
    """What windows that are gone have left in a folder, the latest first."""
    found = []
    marks = (*folder.glob(f"*{ENDING}"), *folder.glob("*.lock"))
    for file in {mark.with_suffix(ENDING) for mark in marks}:
        lock = lock_of(file)
        if not lock.tryLock(0):
            continue  # its window is open
        if not file.exists():
            remove_left_behind(file)
            lock.unlock()  # which removes what is left of a window that had nothing to keep
            continue
        found.append(LeftBehind(file, About.read(about_of(file)), lock))
    return sorted(found, key=lambda each: each.kept_at, reverse=True)


def lock_of(file: Path) -> QLockFile:
    """The lock of a session's window; free once the process is gone."""
    lock = QLockFile(str(file.with_suffix(".lock")))
    lock.setStaleLockTime(0)  # as long as the process lives, however long
    return lock


def about_of(file: Path) -> Path:
    """The file that says what a session is."""
    return file.with_suffix(".json")


class RecoveryChoice(Enum):
    """What shall become of work that was left behind."""

    RECOVER = auto()
    DISCARD = auto()
    LATER = auto()


def offer(
    works: Sequence[LeftBehind], recover: Callable[[LeftBehind], bool], window: QWidget
) -> bool:
    """Ask what shall become of each.

    Parameters
    ----------
    works : sequence of LeftBehind
        What was found.
    recover : callable
        Opens one, each in a window of its own; tells whether it is safe elsewhere now.
    window : QWidget
        Asks.

    Returns
    -------
    bool
        Whether any is open now.
    """
    recovered = 0
    for work in works:
        choice = ask(work, window)
        opened = choice is RecoveryChoice.RECOVER and recover(work)
        recovered += opened
        if opened or choice is RecoveryChoice.DISCARD:
            work.remove()
        else:
            work.put_back()
    return recovered > 0


def ask(work: LeftBehind, window: QWidget) -> RecoveryChoice:
    """Put the question about one."""
    box, name = QMessageBox(window), work.about.name
    box.setTextFormat(Qt.TextFormat.PlainText)  # names of files may look like markup
    box.setWindowTitle(tr("Unsaved work"))
    if work.about.ended:
        box.setIcon(QMessageBox.Icon.Information)
        box.setText(
            tr("{name} had unsaved changes when the workbench was asked to end.").format(name=name)
        )
    else:
        box.setIcon(QMessageBox.Icon.Question)
        box.setText(
            tr("The workbench was not closed. Unsaved changes to {name} were kept.").format(
                name=name
            )
        )
    box.setInformativeText(tr("Kept on {kept_at:%Y-%m-%d, %H:%M:%S}.").format(kept_at=work.kept_at))
    roles = QMessageBox.ButtonRole
    recover = box.addButton(tr("&Recover"), roles.AcceptRole)
    discard = box.addButton(tr("&Discard"), roles.DestructiveRole)
    box.setEscapeButton(box.addButton(tr("Ask &later"), roles.RejectRole))
    box.exec()
    pressed = box.clickedButton()
    box.deleteLater()
    if pressed == recover:
        return RecoveryChoice.RECOVER
    return RecoveryChoice.DISCARD if pressed == discard else RecoveryChoice.LATER
