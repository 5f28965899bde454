"""Independent traces of lenses in a thread: the latest that was asked for, and no other."""

from dataclasses import dataclass
from functools import partial
from threading import Event
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QObject, Signal

from ui.threads.latest import Latest
from workbench.design.session import verified_error as verified_error  # to be had from here, too

if TYPE_CHECKING:
    from workbench.analysis.validation import Validation
    from workbench.files.session import Session

Array = npt.NDArray[np.float64]

RAYS = 4_000_000
"""Rays of a thorough check."""


@dataclass(frozen=True, eq=False)
class Suspect:
    """A lens that shall be checked.

    Attributes
    ----------
    session : Session
        Its task.
    control_points : ndarray, shape (n_u, n_v)
        Heights of its control points.
    iterations : int
        Iterations before it.
    seconds : float
        Run time before it.
    irradiance : ndarray, shape (n_y, n_x), optional
        The optimiser's own image, to compare with.
    """

    session: "Session"
    control_points: Array
    iterations: int = 0
    seconds: float = 0.0
    irradiance: Array | None = None


class Checking(QObject):
    """One check at a time. Another one, or leaving it, ends it within a moment.

    Parameters
    ----------
    parent : QObject
        The owner.

    Attributes
    ----------
    came_on : Signal(Suspect, float)
        The part of its check that is done.
    checked : Signal(Suspect, Validation, float or None)
        What the check says, and the relative L2 difference to the optimiser's own image.
    failed : Signal(Suspect, str)
        Why it says nothing.
    """

    came_on = Signal(object, float)
    checked = Signal(object, object, object)
    failed = Signal(object, str)

    _stepped = Signal(object, float)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._latest = Latest("check", self)
        self._latest.answered.connect(lambda suspect, found: self.checked.emit(suspect, *found))
        self._latest.failed.connect(self.failed)
        self._stepped.connect(self._tell)

    @property
    def busy(self) -> bool:
        """Whether a check is under way that was not left."""
        return self._latest.busy

    def begin(self, suspect: Suspect, rays: int = RAYS, threads: int = 0) -> None:
        """Check a lens with so many rays, in so many threads; 0 for as many as there are cores."""
        self._latest.ask(suspect, partial(self._check, suspect, rays, threads or None))

    def leave(self) -> None:
        """Tell nothing more of the check that is under way."""
        self._latest.forget()

    def close(self) -> None:
        """Leave the check and wait for the thread; safe to call twice."""
        self._latest.close()

    def _check(
        self, suspect: Suspect, rays: int, threads: int | None, left: Event
    ) -> "tuple[Validation, float | None] | None":
        # Late: what it stands on is slow to import.
        from workbench.analysis.metrics import relative_l2
        from workbench.analysis.validation import validating

        scene, target = suspect.session.scene, suspect.session.target
        steps = validating(scene, target, suspect.control_points, rays, threads=threads)
        while not left.is_set():
            try:
                self._stepped.emit(suspect, next(steps))
            except StopIteration as end:
                found: Validation = end.value
                own = suspect.irradiance
                return found, None if own is None else relative_l2(found.irradiance, own)
        steps.close()
        return None

    def _tell(self, suspect: Suspect, part: float) -> None:
        if self._latest.wants(suspect):
            self.came_on.emit(suspect, part)
