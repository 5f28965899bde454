"""The course of a run, kept in frames that a person can go back to."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

if TYPE_CHECKING:
    from ui.run.frame import Frame

_BUDGET = 64 << 20  # bytes of all frames


class Moments(QObject):
    """Frames of a run and of those that continue it, first and latest always among them.

    When they take too much memory every second one is dropped, and from then on frames are kept
    half as often: the course is told evenly, however long it is.

    Parameters
    ----------
    budget : int
        Bytes that the frames may take.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None, budget: int = _BUDGET) -> None:
        super().__init__(parent)
        self._budget = budget
        self._frames: list[Frame] = []
        self._gap = 1  # iterations between frames, at least

    @property
    def frames(self) -> "Sequence[Frame]":
        """In the order of their iterations."""
        return self._frames

    def add(self, frame: "Frame") -> None:
        """Keep the latest frame; what came later in an earlier course is forgotten."""
        frames, at = self._frames, moment(frame)
        while frames and moment(frames[-1]) >= at:
            frames.pop()
        if not frames:
            self._gap = 1
        # The last one gives way, unless it is far enough from the one before it.
        if len(frames) > 1 and moment(frames[-1]) - moment(frames[-2]) < self._gap:
            frames.pop()
        frames.append(frame)
        while len(frames) > 2 and sum(map(_size, frames)) > self._budget:
            self._gap *= 2
            frames[:] = [*frames[:-1:2], frames[-1]]
        self.changed.emit()

    def clear(self) -> None:
        """Forget all of them."""
        if self._frames:
            self._frames.clear()
            self.changed.emit()


def moment(frame: "Frame") -> int:
    """Iterations before a frame, those of a continued run included."""
    return int(frame.losses.size)


def _size(frame: "Frame") -> int:
    snapshot, paths = frame.snapshot, frame.paths
    arrays = (snapshot.control_points, snapshot.irradiance, frame.surface, frame.losses)
    return sum(array.nbytes for array in (*arrays, paths.points, paths.weight))
