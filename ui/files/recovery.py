"""What is not saved, kept beside the settings in case the program ends without being closed.

1. Each window writes a file of its own and holds a lock beside it, so that several windows can be
   open. A lock whose process is gone tells that its file was left behind.
2. Sessions are immutable, so a thread of its own writes them: a large one would hold the window up.
3. A run hands its result over at its end. Until then the lens of its latest frame is kept.
"""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any
from uuid import uuid4

from PySide6.QtCore import QObject, QTimer, Signal

from ui.document.document import ENDING, Document
from ui.files.left_behind import About, about_of, lock_of
from ui.threads.background import Background, Task
from ui.threads.failure import sentence_of
from ui.words import tr
from workbench.errors import Refused
from workbench.files.session import Session, write_session

if TYPE_CHECKING:
    from ui.run.control import RunControl
    from ui.shown.frame import Frame

_EVERY_MS = 60_000


class Recovery(QObject):
    """Keeps a document's unsaved work; `start` begins with it, `close` ends it.

    Parameters
    ----------
    document : Document
        What is kept while it is dirty.
    folder : Path
        Where; made if it is not there.
    every_ms : int
        How often, in milliseconds.

    Attributes
    ----------
    look : callable
        How the design is looked at, which is kept with it.
    """

    failed = Signal(str)  # why nothing can be kept, once

    def __init__(
        self,
        document: Document,
        folder: Path,
        parent: QObject | None = None,
        every_ms: int = _EVERY_MS,
    ) -> None:
        super().__init__(parent)
        self.look: Callable[[], dict[str, Any] | None] = lambda: None
        self._document = document
        self._file = folder / f"{uuid4().hex}{ENDING}"
        self._lock = lock_of(self._file)
        self._frame: Frame | None = None
        self._kept: Session | None = None
        self._background = Background("recovery", self, finish_first=True)
        self._background.failed.connect(self._give_up)
        self._warned = self._closed = False
        self._timer = QTimer(self, interval=every_ms)
        self._timer.timeout.connect(self.keep)

    @property
    def folder(self) -> Path:
        """Where it is kept."""
        return self._file.parent

    def start(self) -> None:
        """Keep what is not saved, every minute."""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            self._tell(f"{self.folder}: {error.strerror or error}")
        else:
            self._lock.tryLock(0)
            self._timer.start()

    def follow(self, control: "RunControl") -> None:
        """Keep the lens of a run while it goes on, and its result at once."""

        def note(frame: "Frame") -> None:
            if control.busy:
                self._frame = frame

        def end() -> None:  # the document has the result now
            self._frame = None
            self.keep()

        control.runner.frame_ready.connect(note)
        control.ended.connect(end)

    def keep(self) -> None:
        """Write what is not saved, unless that is done; remove what is saved."""
        session = self._unsaved()
        if session is None:
            if not self._background.running:
                self._remove()
        elif session is not self._kept:
            self._kept = session
            work = replace(self._document.verified.complete(session), view=self.look())
            about = self._about(ended=False)
            self._background.begin(partial(_write, work, about, self._file))

    def close(self, leave: bool = False) -> None:
        """End keeping; safe to call twice.

        Parameters
        ----------
        leave : bool
            Leave the file behind, for the next start, instead of removing it.
        """
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
        """Keep, and wait until that is done; whether anything is kept."""
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

    def _give_up(self, _: None, error: Exception) -> None:
        self._kept = None
        self._tell(sentence_of(error, tr("recovery")))

    def _tell(self, reason: str) -> None:
        if not self._warned:
            self._warned = True
            self.failed.emit(
                tr("Unsaved work cannot be kept for a recovery. {reason}").format(reason=reason)
            )

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
