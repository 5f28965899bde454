"""Traces of a lens to screens elsewhere, for threads."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ui.threads.background import Task
from ui.threads.cores import other_cores
from workbench.errors import RunFailed

if TYPE_CHECKING:
    from workbench.analysis.validation_figures import Validation
    from workbench.files.session import Session
    from workbench.geometry.faces import ControlHeights


@dataclass(frozen=True, eq=False)
class FocusRequest:
    """What the light of a lens is like on screens elsewhere.

    Attributes
    ----------
    session : Session
        Its task.
    heights : ControlHeights
        Its control heights.
    traces : tuple of (float, int)
        One after the other: z of the screen, and rays.
    """

    session: "Session"
    heights: "ControlHeights"
    traces: tuple[tuple[float, int], ...]


def trace_through_focus(request: FocusRequest, task: Task) -> None:
    """Answer a request; meant for a thread.

    Reports for each screen its z and what the light is like there, a `Validation` or None for no
    light.
    """
    for z, rays in request.traces:
        found = _trace(request, z, rays, task)
        if task.stopped:
            return
        task.report((z, found))


def _trace(request: FocusRequest, z: float, rays: int, task: Task) -> "Validation | None":
    """The light on a screen; None if there is none, or nobody wants to know any more."""
    # Late: what it stands on is slow to import.
    from workbench.analysis.validation import validating

    session = request.session.of_image(0)  # about whose screen the light is followed
    steps = validating(
        session.scene,
        session.target,
        request.heights,
        rays,
        screen_z=z,
        threads=other_cores(),
    )
    try:
        return task.follow(steps)
    except RunFailed:
        return None
