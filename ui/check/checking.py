"""Independent traces of lenses, for threads."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ui.threads.background import Task
from workbench.arrays import Array
from workbench.design.session import verified_error as verified_error  # to be had from here, too

if TYPE_CHECKING:
    from workbench.analysis.validation_figures import Validation
    from workbench.files.session import Session
    from workbench.geometry.faces import ControlHeights

RAYS = 4_000_000
"""Rays of a thorough check."""

ACCURACY = 1e-3
"""Relative error of the image by cells in a thorough check."""


@dataclass(frozen=True, eq=False)
class CheckedLens:
    """A lens that shall be checked.

    Attributes
    ----------
    session : Session
        Its task.
    heights : ControlHeights
        Its control heights.
    iterations : int
        Iterations before it.
    seconds : float
        Run time before it.
    irradiance : ndarray, shape (n_y, n_x), optional
        The optimiser's own image, to compare with.
    further : tuple of ndarray, shape (n_y, n_x)
        Its own images at the receivers of further images.
    """

    session: "Session"
    heights: "ControlHeights"
    iterations: int = 0
    seconds: float = 0.0
    irradiance: Array | None = None
    further: tuple[Array, ...] = ()


def check(
    lens: CheckedLens, rays: int, threads: int | None, accuracy: float, task: Task
) -> "tuple[Validation, float | None] | None":
    """Check a lens; meant for a thread. Reports the part that is done.

    Parameters
    ----------
    lens : CheckedLens
        The lens.
    rays : int
        How many are traced.
    threads : int, optional
        How many trace them; by default as many as there are cores.
    accuracy : float
        Relative error that the image by cells may have.
    task : Task
        Ends the check within a moment.

    Returns
    -------
    found : Validation
        What the check says.
    difference : float or None
        Relative L2 difference to the optimiser's own image.
    """
    # Late: what it stands on is slow to import.
    from workbench.analysis.metrics import relative_l2
    from workbench.analysis.validation import validating

    scene, target = lens.session.scene, lens.session.target
    steps = validating(scene, target, lens.heights, rays, threads=threads, accuracy=accuracy)
    found = task.follow(steps, task.report)
    if found is None:
        return None
    own = lens.irradiance
    return found, None if own is None else relative_l2(found.irradiance, own)
