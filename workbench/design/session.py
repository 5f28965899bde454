"""What a person works on: a design task, the lens found for it, and what belongs to both."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from workbench.design.snapshot import Result
from workbench.errors import Refused
from workbench.scene import Scene

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

LONGEST_NAME = 100
"""Most characters in the name of a kept run."""


@dataclass(frozen=True, eq=False)
class KeptRun:
    """A finished run, kept to be compared with others.

    Attributes
    ----------
    name : str
        What a person calls it; 1 to `LONGEST_NAME` characters.
    scene : Scene
        The task that it was given, with an absolute ``target.image``.
    target : ndarray, shape (n_y, n_x)
        The wished image of that task.
    result : Result
        The lens that it found.

    Raises
    ------
    Refused
        If the name is empty or too long.
    """

    name: str
    scene: Scene
    target: Array
    result: Result

    def __post_init__(self) -> None:
        if not 1 <= len(self.name) <= LONGEST_NAME:
            raise Refused(
                "name", f"it has {len(self.name)} characters; 1 to {LONGEST_NAME} are needed"
            )


@dataclass(frozen=True, eq=False)
class Session:
    """A design: what is wished, and the lens found for it.

    Attributes
    ----------
    scene : Scene
        The design task, with an absolute ``target.image``.
    target : ndarray, shape (n_y, n_x)
        The wished image before normalisation and filtering, row 0 at +y.
    result : Result, optional
        The best lens so far; None before the first run.
    locked : ndarray of bool, shape (n_u, n_v), optional
        Control points of the finished lens whose heights a run leaves as they are; read-only.
    runs : tuple of KeptRun
        Runs kept to be compared, the oldest first.
    view : mapping, optional
        What the window looked like, as a JSON object; it means nothing to the engine.
    """

    scene: Scene
    target: Array
    result: Result | None = None
    locked: Mask | None = None
    runs: tuple[KeptRun, ...] = ()
    view: Mapping[str, Any] | None = None

    def with_scene(self, scene: Scene, target: Array) -> "Session":
        """The session after an edit; what belongs to this task as well stays.

        Run settings say how to search, not what for, so changing them leaves the result. Locks
        stay as long as the control points that they are about.
        """
        same_task = scene.model_copy(update={"run": self.scene.run}) == self.scene
        keep = same_task and np.array_equal(target, self.target)
        return replace(
            self,
            scene=scene,
            target=target,
            result=self.result if keep else None,
            locked=self.locked if _net(scene) == _net(self.scene) else None,
        )


def _net(scene: Scene) -> tuple[object, ...]:
    return scene.lens.control_points, scene.lens.degree
