"""Perturbed lenses, traced until all are done or somebody has seen enough."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from ui.threads.background import Task

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.analysis.tolerance_fields import Tolerances
    from workbench.analysis.tolerances import Perturbed


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

    def add(self, each: "Perturbed") -> None:
        """Take another lens; the first is the one that is not off."""
        if self.nominal is None:
            self.nominal = each
        else:
            self.others.append(each)


def trace_sample(sample: Sample, rays: int, task: Task) -> None:
    """Trace lenses, each with so many rays at least; meant for a thread. Reports each of them."""
    # Late: what it stands on is slow to import.
    from workbench.analysis.tolerances import perturbed

    session, heights = sample.frame.session, sample.frame.state.heights
    for each in perturbed(
        session.scene, session.target, heights, sample.within, sample.wanted, rays, sample.seed
    ):
        if task.stopped:
            break
        task.report(each)
