"""The open design: a session, its file, and every change that was made to it."""

import weakref
from dataclasses import replace
from enum import Enum, auto
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

import resources
from ui.document.undo_steps import UndoSteps
from ui.words import tr
from workbench.design.session import KeptRun, VerifiedError
from workbench.design.snapshot import Result
from workbench.design.task import with_file, with_task
from workbench.files.scene import with_absolute_files
from workbench.files.session import Session, is_session, open_design, read_session, write_session
from workbench.reading import fingerprint
from workbench.scene import Scene

if TYPE_CHECKING:
    from workbench.analysis.validation_figures import Validation


class VerifiedErrors:
    """Verified errors of living lenses, kept beside the sessions: a check is no edit."""

    def __init__(self) -> None:
        # By id of the result, which may be gone by now.
        self._all: dict[int, tuple[weakref.ref[Result], VerifiedError]] = {}

    def note(self, lens: Result, found: "Validation") -> None:
        lens_error = found.verified
        error = VerifiedError(
            lens_error.relative_l2_corrected, lens_error.relative_l2_corrected_interval
        )
        self._all[id(lens)] = weakref.ref(lens), error

    def of(self, run: KeptRun) -> VerifiedError | None:
        """Return the error of a run's lens, from the latest check or its file."""
        return self.of_lens(run.result) or run.verified

    def of_lens(self, result: Result) -> VerifiedError | None:
        """Return the error of a lens from the latest check."""
        lens, error = self._all.get(id(result), (None, None))
        return error if lens is not None and lens() is result else None

    def complete(self, session: Session) -> Session:
        """The session with the errors of its kept runs, for a file."""
        runs = tuple(replace(run, verified=self.of(run)) for run in session.runs)
        return replace(session, runs=runs)


ENDING = ".freeform"

_File = tuple[Path | None, str | None, Path]
"""The file of a design, its fingerprint, and where the design might be saved without one."""


class OnDisk(Enum):
    """Whether a design's file holds what it held when it was last read or written."""

    KNOWN = auto()
    CHANGED = auto()
    GONE = auto()


class Document(QObject):
    """Owns the session, the file path and the undo stack.

    Sessions are immutable: when an edit raises, the open session is unchanged.
    """

    session_changed = Signal(object)  # Session
    edited = Signal(object, object)  # Session, Session
    begun = Signal(object)  # Session
    path_changed = Signal()
    dirty_changed = Signal(bool)

    def __init__(self, session: Session, name: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.session = session  # scene, target and, once designed, the result
        self.path: Path | None = None  # of the file that saving writes
        self.fingerprint: str | None = None  # of that file when it was last read or written
        self._suggestion = Path(name)
        self.in_run = False  # whether a run works on the task, which stays until its end
        self.verified = VerifiedErrors()
        self.undo_stack = UndoSteps(self._show, self)
        self.undo_stack.cleanChanged.connect(self._emit_dirty)

    @property
    def name(self) -> str:
        return self.suggested_path.stem

    @property
    def suggested_path(self) -> Path:
        return self.path or self._suggestion.with_suffix(ENDING)

    @property
    def folder(self) -> Path | None:
        """Folder of the design, if it was opened or saved."""
        path = self.suggested_path
        return path.parent if path.is_absolute() else None

    @property
    def dirty(self) -> bool:
        return not self.undo_stack.isClean()

    def edit(self, scene: Scene, text: str, key: str) -> None:
        """Replace the scene as an undoable step; edits with the same key are merged."""
        # One step is one edit: what was lost on the way comes back with the value it hung on.
        old = self.before(key)
        # A relative path typed by hand starts beside the file, as it will when saved there.
        scene = with_absolute_files(scene, self.suggested_path)
        if scene == self.session.scene:
            return
        after = with_task(old, scene, self.suggested_path.parent)
        self.change(after, text, key)
        self.edited.emit(old, after)

    def after_edit(self, scene: Scene) -> Session:
        """Return the session after an edit, without making it."""
        scene = with_absolute_files(scene, self.suggested_path)
        return with_task(self.session, scene, self.suggested_path.parent)

    def before(self, key: str) -> Session:
        """Return the session before a step with this key, which may be merged with the last one."""
        return self.undo_stack.origin(key) or self.session

    def read_image_again(self) -> None:
        """Reload the target's image file as an undoable step."""
        before = self.session
        after = with_file(before, self.suggested_path.parent)
        self.change(after, tr("reload of the image"))
        self.edited.emit(before, after)

    def set_result(self, result: Result, text: str) -> None:
        self.change(replace(self.session, result=result), text)

    def change(self, session: Session, text: str, key: str = "") -> None:
        """Replace the session as an undoable step."""
        self.undo_stack.take(self.session, session, text, key)

    def improve(self, session: Session) -> None:
        """Replace the lens by a better one for the same task, as part of the last step.

        No signal is sent: the caller shows the lens.
        """
        self.session = session
        self.undo_stack.amend(session)

    def seal(self) -> None:
        """Keep the next edit separate: undoing it restores this lens."""
        self.undo_stack.seal()

    def begin(self, session: Session, name: str) -> None:
        """Open a new task without a file as an undoable step; undo also restores name and file."""
        other: _File = None, None, Path(name)  # file and name of the design that is not open

        def exchange() -> None:
            nonlocal other
            now = self.path, self.fingerprint, self._suggestion
            (self.path, self.fingerprint, self._suggestion), other = other, now
            self.path_changed.emit()

        self.undo_stack.take(
            self.session, session, tr("new task: {name}").format(name=name), exchange=exchange
        )
        self.begun.emit(session)

    def open(self, path: Path) -> None:
        """Open a session, or an untitled design from a scene file."""
        path = path.absolute()
        shipped = path.is_relative_to(resources.path())  # no place to save to
        suggestion = Path(path.name) if shipped else path
        # Beforehand: what is written while it is read is a change. Other files may be endless.
        found = fingerprint(path) if is_session(path) else None
        session = open_design(path)
        if found is None:
            self._begin(session, suggestion)
        else:
            self._begin(session, suggestion, path, found)

    def recover(self, session: Session, name: str, path: Path | None, known: str | None) -> None:
        self._begin(session, Path(name), path, known)
        self.undo_stack.resetClean()

    def on_disk(self, path: Path) -> OnDisk:
        """Compare a file with the design; `OnDisk.KNOWN` for any file but its own."""
        if self.path is None or path.resolve() != self.path.resolve():
            return OnDisk.KNOWN
        found = fingerprint(path)
        if found == self.fingerprint:
            return OnDisk.KNOWN
        return OnDisk.GONE if found is None else OnDisk.CHANGED

    def revert(self) -> None:
        """Restore the saved file as an undoable step."""
        if self.path is not None:
            found = fingerprint(self.path)
            self.change(read_session(self.path), tr("revert to the file"))
            self.fingerprint = found
            self.undo_stack.setClean()

    def save(
        self, path: Path, view: dict[str, Any] | None = None, making: Result | None = None
    ) -> None:
        session = replace(self.verified.complete(self.session), view=view)
        if making is not None:
            session = replace(session, result=making)
        self.fingerprint = write_session(session, path)
        self.path = path
        if making is None:
            self.undo_stack.setClean()
        else:
            self.undo_stack.resetClean()
        self.path_changed.emit()

    def _emit_dirty(self, clean: bool) -> None:
        self.dirty_changed.emit(not clean)

    def _begin(
        self, session: Session, suggestion: Path, path: Path | None = None, known: str | None = None
    ) -> None:
        self.path, self.fingerprint, self._suggestion = path, known, suggestion
        self.undo_stack.clear()
        self.undo_stack.setClean()  # an empty stack is left as it was, a recovered one too
        self._show(session)
        self.path_changed.emit()

    def _show(self, session: Session) -> None:
        self.session = session
        self.session_changed.emit(session)
