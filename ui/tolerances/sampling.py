"""Traces perturbed lenses in a thread, until all are done or somebody has seen enough."""

from dataclasses import dataclass, field
from threading import Event
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ui.threads.background import Background

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.analysis.tolerances import Perturbed, Tolerances


@dataclass(eq=False)
class Sample:
    """Lenses that are off, as far as they are traced.

    Attributes
    ----------
    frame : Frame
        The lens as designed, and its task.
    within : Tolerances
        How far they may be off.
    wanted : int
        How many are asked for.
    seed : int
        The same seed gives the same lenses.
    nominal : Perturbed, optional
        The trace of the lens that is not off; None until it is there.
    others : list of Perturbed
        Those that are.
    """

    frame: "Frame"
    within: "Tolerances"
    wanted: int
    seed: int
    nominal: "Perturbed | None" = None
    others: "list[Perturbed]" = field(default_factory=list)

    @property
    def shown(self) -> bool:
        """Whether there is anything to tell of."""
        return bool(self.others)


class Sampling(QObject):
    """One sample at a time; leaving it keeps the lenses that are traced.

    Attributes
    ----------
    came_on : Signal(Sample)
        One more lens is traced.
    ended : Signal(Sample)
        No more will be.
    failed : Signal(str)
        Why there is none.
    """

    came_on = Signal(object)
    ended = Signal(object)
    failed = Signal(str)

    _stepped = Signal(object, object)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._left = Event()
        self._background = Background("sample of tolerances", self)
        self._background.done.connect(self.ended)
        self._background.failed.connect(self.failed)
        self._stepped.connect(self._take)

    @property
    def busy(self) -> bool:
        """Whether lenses are being traced."""
        return self._background.busy

    @property
    def left(self) -> bool:
        """Whether the sample under way was left."""
        return self.busy and self._left.is_set()

    def begin(self, sample: Sample, rays: int) -> None:
        """Trace lenses, each with so many rays at least; no sample may be under way."""
        self._left = left = Event()
        session, heights = sample.frame.session, sample.frame.snapshot.control_points

        def work() -> Sample:
            # Late: what it stands on is slow to import.
            from workbench.analysis.tolerances import perturbed

            for each in perturbed(
                session.scene,
                session.target,
                heights,
                sample.within,
                sample.wanted,
                rays,
                sample.seed,
            ):
                if left.is_set():
                    break
                self._stepped.emit(sample, each)
            return sample

        self._background.begin(work)

    def leave(self) -> None:
        """Trace no more than the lens under way."""
        self._left.set()

    def close(self) -> None:
        """Leave the sample and wait for the thread; safe to call twice."""
        self.leave()
        self._background.close()

    def _take(self, sample: Sample, each: "Perturbed") -> None:
        if sample.nominal is None:
            sample.nominal = each
        else:
            sample.others.append(each)
        self.came_on.emit(sample)
