"""Unsaved work: kept beside the settings, and offered at the next start.

1. Each window writes a session, a description beside it, and a lock. A lock without a process marks
   a session to recover.
2. A thread writes the immutable session, so that a large one does not block the window.
3. During a run the lens of its latest frame is kept.
"""

import json
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from datetime import datetime
from enum import Enum, auto
from functools import partial
from pathlib import Path
from typing import Any
from uuid import uuid4

from PySide6.QtCore import QLockFile, QObject, QTimer, Signal
from PySide6.QtWidgets import QMessageBox, QWidget

from ui.background import Background, Task
from ui.document.document import ENDING, Document
from ui.document.frame import Frame
from ui.run.control import RunControl
from ui.widgets.messages import question
from ui.words import later, tr
from workbench.errors import Refused
from workbench.files.atomic import remove_left_behind, replacing
from workbench.files.session import Session, write_session


@dataclass(frozen=True)
class About:
    """Description of a kept session, in a file beside it."""

    name: str
    path: Path | None = None
    fingerprint: str | None = None
    ended: bool = False

    @classmethod
    def read(cls, file: Path) -> "About":
        """Read the description; a default if it is missing or damaged."""
        try:
            about = json.loads(file.read_bytes())
            path, name, ended = about["path"], str(about["name"]), bool(about.get("ended"))
            return cls(name, None if path is None else Path(path), about.get("fingerprint"), ended)
        except (OSError, ValueError, KeyError, TypeError, AttributeError):
            return cls("recovered")

    def write(self, file: Path) -> None:
        path = None if self.path is None else str(self.path)
        with replacing(file) as content:
            content.write(json.dumps(asdict(self) | {"path": path}).encode())


@dataclass(frozen=True)
class LeftBehind:
    """Unsaved work of a window that was not closed, with its lock."""

    file: Path
    about: About
    lock: QLockFile

    @property
    def kept_at(self) -> datetime:
        return datetime.fromtimestamp(self.file.stat().st_mtime)

    def remove(self) -> None:
        """Delete the work; if that fails, the next start asks again."""
        for file in (self.file, about_of(self.file)):
            with suppress(OSError):
                file.unlink(missing_ok=True)
            remove_left_behind(file)
        self.lock.unlock()

    def put_back(self) -> None:
        self.lock.unlock()


def find_left_behind(folder: Path) -> list[LeftBehind]:
    """Return unsaved work of closed processes in a folder, the latest first."""
    found = []
    marks = (*folder.glob(f"*{ENDING}"), *folder.glob("*.lock"))
    for file in {mark.with_suffix(ENDING) for mark in marks}:
        lock = lock_of(file)
        if not lock.tryLock(0):
            continue  # its window is open
        if not file.exists():
            remove_left_behind(file)
            lock.unlock()  # which removes the files of a window that had nothing to keep
            continue
        found.append(LeftBehind(file, About.read(about_of(file)), lock))
    return sorted(found, key=lambda each: each.kept_at, reverse=True)


def lock_of(file: Path) -> QLockFile:
    """The lock of a session's window; free once the process is gone."""
    lock = QLockFile(str(file.with_suffix(".lock")))
    lock.setStaleLockTime(0)  # as long as the process lives, however long
    return lock


def about_of(file: Path) -> Path:
    """Return the description file of a session."""
    return file.with_suffix(".json")


class RecoveryChoice(Enum):
    """Answer for unsaved work."""

    RECOVER = auto()
    DISCARD = auto()
    LATER = auto()


def offer_left_behind(
    works: Sequence[LeftBehind], recover: Callable[[LeftBehind], bool], window: QWidget
) -> bool:
    """Ask about each; whether any was recovered."""
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
    """Ask what to do with one."""
    icons, roles = QMessageBox.Icon, QMessageBox.ButtonRole
    text = (
        tr("{name} had unsaved changes when the program was terminated.")
        if work.about.ended
        else tr("The program ended unexpectedly. Unsaved changes to {name} were kept.")
    )
    kept = tr("Kept on {kept_at:%Y-%m-%d, %H:%M:%S}.").format(kept_at=work.kept_at)
    return question(
        window,
        icons.Information if work.about.ended else icons.Question,
        (tr("Unsaved work"), text.format(name=work.about.name), kept),
        [
            (tr("&Recover"), roles.AcceptRole, RecoveryChoice.RECOVER),
            (tr("&Discard"), roles.DestructiveRole, RecoveryChoice.DISCARD),
            (tr("Ask &later"), roles.RejectRole, RecoveryChoice.LATER),
        ],
    )


_EVERY_MS = 60_000


class Recovery(QObject):
    """Keeps a document's unsaved work; `start` begins with it, `close` ends it."""

    failed = Signal(str)  # why nothing can be kept, once

    def __init__(
        self,
        document: Document,
        folder: Path,
        parent: QObject | None = None,
        every_ms: int = _EVERY_MS,
    ) -> None:
        super().__init__(parent)
        self.view_data: Callable[[], dict[str, Any] | None] = lambda: None
        self._document = document
        self._file = folder / f"{uuid4().hex}{ENDING}"
        self._lock = lock_of(self._file)
        self._frame: Frame | None = None
        self._kept: Session | None = None
        self._background = Background(later("recovery"), self, finish_first=True)
        self._background.failed.connect(self._give_up)
        self._warned = self._closed = False
        self._timer = QTimer(self, interval=every_ms)
        self._timer.timeout.connect(self.keep)

    @property
    def folder(self) -> Path:
        return self._file.parent

    def start(self) -> None:
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            self._tell(f"{self.folder}: {error.strerror or error}")
        else:
            self._lock.tryLock(0)
            self._timer.start()

    def follow(self, control: RunControl) -> None:
        """Back up the lens of a run, and its result at once."""

        def note(frame: Frame) -> None:
            if control.busy:
                self._frame = frame

        def end() -> None:  # the document has the result now
            self._frame = None
            self.keep()

        control.runner.frame_ready.connect(note)
        control.ended.connect(end)

    def keep(self) -> None:
        """Back up unsaved work; remove the backup of saved work."""
        session = self._unsaved()
        if session is None:
            if not self._background.running:
                self._remove()
        elif session is not self._kept:
            self._kept = session
            work = replace(self._document.verified.complete(session), view=self.view_data())
            about = self._about(ended=False)
            self._background.begin(partial(_write, work, about, self._file))

    def close(self, leave: bool = False) -> None:
        if self._closed:
            return
        self._closed = True
        self._timer.stop()
        self._background.finish()
        if leave:
            if self.keep_now():
                with suppress(Refused):  # then the next start speaks of a crash, that is all
                    self._about(ended=True).write(about_of(self._file))
        else:
            self._remove()
        self._lock.unlock()

    def keep_now(self) -> bool:
        """Back up now and wait; whether there is a backup."""
        self.keep()
        self._background.finish()
        return self._kept is not None

    def _unsaved(self) -> Session | None:
        if self._frame is not None:
            runs = self._document.session.runs
            return replace(self._frame.session, result=self._frame.result, runs=runs)
        return self._document.session if self._document.dirty else None

    def _about(self, ended: bool) -> About:
        document = self._document
        return About(document.name, document.path, document.fingerprint, ended)

    def _give_up(self, sentence: str) -> None:
        self._kept = None
        self._tell(sentence)

    def _tell(self, reason: str) -> None:
        if not self._warned:
            self._warned = True
            self.failed.emit(tr("Unsaved work cannot be backed up. {reason}").format(reason=reason))

    def _remove(self) -> None:
        self._kept = None
        for file in (self._file, about_of(self._file)):
            try:
                file.unlink(missing_ok=True)
            except OSError as error:  # the next start offers what is there
                self._tell(f"{file}: {error.strerror or error}")


def _write(session: Session, about: About, file: Path, task: Task) -> None:
    about.write(about_of(file))
    write_session(session, file)
