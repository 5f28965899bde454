"""The open design: a session, the file it lives in, and every change that was made to it."""

from dataclasses import replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

import resources
from ui.run.verified import VerifiedErrors
from ui.steps import Steps
from workbench.design.snapshot import Result
from workbench.files.scene import with_absolute_image
from workbench.files.session import (
    Session,
    is_session,
    open_design,
    read_session,
    write_session,
)
from workbench.scene import Scene
from workbench.targets import load_target

ENDING = ".freeform"


class Document(QObject):
    """Owns the session, the file path, the undo stack and with it the dirty flag.

    Sessions are immutable values, so an edit is a step from one session to the next and whatever
    raises on the way (a refusal, a full disk) leaves the open one as it is.

    Parameters
    ----------
    session : Session
        What is open at first.
    name : str
        What the title calls it until it has a file of its own.

    Attributes
    ----------
    verified : VerifiedErrors
        What checks say of the lenses of kept runs, which goes into files.
    session_changed : Signal(Session)
        Another session is open, in whatever way it came.
    edited : Signal(Session, Session)
        An edit has led from the one to the other.
    path_changed : Signal()
        The design has another file.
    dirty_changed : Signal(bool)
        Whether closing now would lose changes.
    """

    session_changed = Signal(object)
    edited = Signal(object, object)
    path_changed = Signal()
    dirty_changed = Signal(bool)

    def __init__(self, session: Session, name: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._path: Path | None = None
        self._suggestion = Path(name)
        self.verified = VerifiedErrors()
        self.undo_stack = Steps(self._show, self)
        self.undo_stack.cleanChanged.connect(self._tell_dirty)

    @property
    def session(self) -> Session:
        """Scene, target and, once designed, the result."""
        return self._session

    @property
    def path(self) -> Path | None:
        """The session file that saving writes; None for a design without one."""
        return self._path

    @property
    def name(self) -> str:
        """What the title calls the design."""
        return self.suggested_path.stem

    @property
    def suggested_path(self) -> Path:
        """Where the design is or might be saved."""
        return self._path or self._suggestion.with_suffix(ENDING)

    @property
    def dirty(self) -> bool:
        """Whether closing now would lose changes."""
        return not self.undo_stack.isClean()

    def edit(self, scene: Scene, text: str, key: str) -> None:
        """Go on with another scene, as one step that can be undone.

        Parameters
        ----------
        scene : Scene
            Takes the place of the open one.
        text : str
            What the undo menu calls the step.
        key : str
            Consecutive edits with the same key become one step.

        Raises
        ------
        Refused
            If the scene's target cannot be loaded; nothing has changed then.
        """
        # One step is one edit: what was lost on the way comes back with the value it hung on.
        old = self.undo_stack.origin(key) or self._session
        # A relative path typed by hand starts beside the file, as it will when saved there.
        scene = with_absolute_image(scene, self.suggested_path)
        if scene == self._session.scene:
            return
        target = old.target
        if _wish(scene) != _wish(old.scene):
            target = load_target(scene, self.suggested_path.parent)
        after = old.with_scene(scene, target)
        self.change(after, text, key)
        self.edited.emit(old, after)

    def set_result(self, result: Result, text: str) -> None:
        """Put a run's result into the session, as one step that can be undone."""
        self.change(replace(self._session, result=result), text)

    def change(self, session: Session, text: str, key: str = "") -> None:
        """Go on with another session, as one step that can be undone.

        Parameters
        ----------
        session : Session
            Takes the place of the open one.
        text, key
            As for `edit`.
        """
        self.undo_stack.take(self._session, session, text, key)

    def open(self, path: Path) -> None:
        """Open a session, or an untitled design from a scene file.

        Raises
        ------
        Refused
            If it cannot be read; the open design stays.
        """
        path = path.absolute()
        shipped = path.is_relative_to(resources.path())  # no place to save to
        suggestion = Path(path.name) if shipped else path
        self._begin(open_design(path), path if is_session(path) else None, suggestion)

    def recover(self, session: Session, path: Path | None, name: str) -> None:
        """Go on with a session that was never saved to ``path``, where it has one."""
        self._begin(session, path, Path(name))
        self.undo_stack.resetClean()

    def revert(self) -> None:
        """Go back to what the file holds, as one step that can be undone.

        Raises
        ------
        Refused
            If it cannot be read; nothing has changed then.
        """
        if self._path is not None:
            self.change(read_session(self._path), "revert to the file")
            self.undo_stack.setClean()

    def save(self, path: Path, view: dict[str, Any] | None = None) -> None:
        """Write the session and make ``path`` its file.

        Parameters
        ----------
        path : Path
            Session file.
        view : dict, optional
            How the design is looked at, which goes into the file and is no change of the design.

        Raises
        ------
        Refused
            If it cannot be written; what was at ``path`` before is still there.
        """
        write_session(replace(self.verified.complete(self._session), view=view), path)
        self._path = path
        self.undo_stack.setClean()
        self.path_changed.emit()

    def _tell_dirty(self, clean: bool) -> None:
        self.dirty_changed.emit(not clean)

    def _begin(self, session: Session, path: Path | None, suggestion: Path) -> None:
        self._path, self._suggestion = path, suggestion
        self.undo_stack.clear()
        self._show(session)
        self.path_changed.emit()

    def _show(self, session: Session) -> None:
        self._session = session
        self.session_changed.emit(session)


def _wish(scene: Scene) -> tuple[object, ...]:
    """All that the target's image depends on."""
    return scene.target, scene.screen.half_width, scene.screen.pixels
