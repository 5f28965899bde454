"""What a run needs, all of it known before the first stage begins: nothing is designed in vain."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from workbench.design.heights import Mask
from workbench.design.limits import HeightLimits, bounded
from workbench.design.parametrisation import check_memory
from workbench.errors import Refused
from workbench.geometry.body import check_body
from workbench.geometry.surface import ControlNet
from workbench.optics.plan import device_of
from workbench.scene import BoxFilter, PaperRun, Scene

Array = npt.NDArray[np.float64]


def check_parts(
    parts: Sequence[Scene], first: int, start: Array | None, locked: Mask | None
) -> None:
    """Refuse a run that could not be carried to its end.

    Parameters
    ----------
    parts : sequence of Scene
        As `Scene.parts` gives them; the last is the scene itself.
    first : int
        Number of the part that the run begins with.
    start, locked
        As for `workbench.design.run.run`.

    Raises
    ------
    Refused
        With the path of the field, in its stage if it is one.
    """
    finished = parts[-1]
    for stage, part in enumerate(parts[first:], first):
        try:
            device_of(part)
            if isinstance(part.run, PaperRun):
                _check_filter(part)
                check_memory(part)
            if locked is not None:
                _check_net(part, finished)
        except Refused as refused:
            if part is finished:
                raise
            path = refused.path.removeprefix("lens.").removeprefix("run.")
            raise Refused(f"run.stages[{stage}].{path}", refused.reason) from None
    if locked is not None and start is not None:
        limits = HeightLimits.of(bounded(finished), ControlNet.of(finished.lens))
        check_body(finished, np.where(locked, start, start.clip(limits.lower, limits.upper)))


def _check_filter(scene: Scene) -> None:
    if isinstance(scene.filter, BoxFilter):
        raise Refused(
            "filter.kind",
            "'box' is constant within a pixel and gives the paper's method no gradient; 'gaussian'",
        )


def _check_net(part: Scene, finished: Scene) -> None:
    """Refuse another net than that of the finished lens, which the locks are about."""
    if ControlNet.of(part.lens) != ControlNet.of(finished.lens):
        raise Refused(
            "lens.control_points",
            f"{list(part.lens.control_points)} are not the control points of the finished lens "
            "that are locked; leave the stage's net out or unlock them",
        )
