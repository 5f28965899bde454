"""The shown lens, and the history of a run."""

import weakref
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from ui.document.document import Document
from ui.document.frame import Frame, iterations_before, lit_alike, same_task, shows
from workbench.arrays import Array
from workbench.design.snapshot import Result
from workbench.files.session import Session

if TYPE_CHECKING:
    from workbench.pictures.loss import Verified

_BUDGET = 64 << 20  # bytes of the frames of one course
_COURSES = 2  # as large as that are kept


@dataclass
class _KeptCourse:
    losses: weakref.ref[Array]
    frames: tuple[Frame, ...]
    gap: int
    checks: "tuple[Verified, ...]"


class FrameHistory(QObject):
    """Frames of a run and of its continuations, including the first and the latest.

    Beyond the memory budget every second frame is dropped. A history lives as long as its result,
    and `show` restores it after undo and redo.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None, budget: int = _BUDGET) -> None:
        super().__init__(parent)
        self._budget = budget
        self.frames: list[Frame] = []
        self._gap = 1  # iterations between frames, at least
        self.checks: tuple[Verified, ...] = ()  # of lenses of this history, in their order
        self._kept: list[_KeptCourse] = []

    def add(self, frame: Frame) -> None:
        """Add the latest frame; later frames of an earlier history are dropped."""
        frames, at = self.frames, iterations_before(frame)
        while frames and iterations_before(frames[-1]) >= at:
            frames.pop()
        if not frames:
            self._gap = 1
        self.checks = _until(at, self.checks)
        # Replace the last frame, unless it is far enough from the one before it.
        if (
            len(frames) > 1
            and iterations_before(frames[-1]) - iterations_before(frames[-2]) < self._gap
        ):
            frames.pop()
        frames.append(frame)
        while len(frames) > 2 and sum(map(_size, frames)) > self._budget:
            self._gap *= 2
            frames[:] = [*frames[:-1:2], frames[-1]]
        self.changed.emit()

    def add_check(self, check: "Verified") -> None:
        self.checks += (check,)
        self.changed.emit()

    def add_later_check(self, check: "Verified", result: Result, session: Session) -> None:
        """Add a check of the lens of a result, whatever is shown now."""
        kept = self._of(result)
        if kept is not None:
            kept.checks += (check,)
            self.show(session)

    def keep(self, result: Result) -> None:
        self._keep(result.losses, tuple(self.frames), self.checks)

    def branch(self, frame: Frame) -> None:
        """Keep the shown history up to a frame that becomes a result."""
        at = iterations_before(frame)
        before = (each for each in self.frames if iterations_before(each) < at)
        self._keep(frame.result.losses, (*before, frame), _until(at, self.checks))

    def show(self, session: Session) -> None:
        """Show the history of a session's result; empty if there is none."""
        self._kept = [kept for kept in self._kept if kept.losses() is not None]
        kept = None if session.result is None else self._of(session.result)
        frames, checks = ((), ()) if kept is None else (kept.frames, kept.checks)
        if frames and not same_task(frames[0].session, session):
            frames = ()  # the lens is the same, but its frames are of another scene
        if (*frames,) != (*self.frames,) or checks != self.checks:
            self.frames, self.checks = list(frames), checks
            self._gap = 1 if kept is None else kept.gap
            self.changed.emit()

    def _of(self, result: Result) -> _KeptCourse | None:
        return next((kept for kept in self._kept if kept.losses() is result.losses), None)

    def _keep(
        self, losses: Array, frames: tuple[Frame, ...], checks: "tuple[Verified, ...]"
    ) -> None:
        self._kept.append(_KeptCourse(weakref.ref(losses), frames, self._gap, checks))
        self._save_memory()

    def _save_memory(self) -> None:
        sizes: dict[int, int] = {}  # courses share frames
        for kept in reversed(self._kept):
            sizes |= {id(frame): _size(frame) for frame in kept.frames}
            if sum(sizes.values()) > _COURSES * self._budget:
                kept.frames = ()


def _until(at: int, checks: "tuple[Verified, ...]") -> "tuple[Verified, ...]":
    return tuple(check for check in checks if check.iteration <= at)


def _size(frame: Frame) -> int:
    state, paths = frame.state, frame.paths
    lights = state.irradiance, *(light.irradiance for light in state.further)
    faces = *state.heights.values(), *frame.surfaces.values()
    arrays = (*faces, *lights, frame.result.losses)
    return sum(array.nbytes for array in (*arrays, paths.points, paths.weight))


_AT_ONCE_MS = 60  # for a person; first lenses of small edits come sooner, and nothing flickers


class ShownLens(QObject):
    """The frame of the lens that all views show; producers emit it by these signals."""

    frame_changed = Signal(object)
    emptied = Signal(object)
    untraced = Signal()  # after `emptied`: the design has no image
    outdated_changed = Signal(bool)

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self.frame: Frame | None = None
        self._outdated = False
        self._wait = QTimer(self, singleShot=True, interval=_AT_ONCE_MS)
        self._wait.timeout.connect(lambda: self._mark(True))
        document.session_changed.connect(self._follow)
        document.begun.connect(self.emptied)  # nothing of another design stands in for a new one
        self.frame_changed.connect(self._store)
        self.emptied.connect(self._empty)

    def _follow(self, session: Session) -> None:
        self._judge(self.frame is None or shows(self.frame, session))

    def _store(self, frame: Frame) -> None:
        self.frame = frame
        self._mark(False)
        self._judge(lit_alike(frame.session, self._document.session))

    def _empty(self, session: Session) -> None:
        self.frame = None
        self._judge(True)

    def _judge(self, up_to_date: bool) -> None:
        if up_to_date:
            self._wait.stop()
            self._mark(False)
        elif not self._wait.isActive():
            self._wait.start()

    def _mark(self, outdated: bool) -> None:
        if outdated != self._outdated:
            self._outdated = outdated
            self.outdated_changed.emit(outdated)
