"""Whether a run, cells and random rays say the same of a task.

The image of a run may be off: then the check says so (`Validation.beside_run`).
"""

import json
from typing import Any

import numpy as np

from tests.stress.random_tasks import TaskDraw, random_task
from workbench.analysis.validation import validate
from workbench.analysis.validation_figures import Validation
from workbench.design.run import run
from workbench.design.snapshot import Snapshot
from workbench.errors import Refused, RunFailed
from workbench.optics.account import Account
from workbench.scene import Scene

RAYS, ACCURACY = 50_000, 2e-3
# The few beams by which a run sees a small net may be off by so much of all light.
_SHARE_OF_RUN = 0.03
# Light that rounding in float32 may gain.
_ROUNDING = 1e-4


def disagreements(
    seed: int, number: int, draw: type[TaskDraw] = TaskDraw, accuracy: float = ACCURACY
) -> tuple[bool, list[str]]:
    """Whether a task could be traced, and in what its traces contradict each other."""
    data, scene = random_task(seed, number, draw)
    if scene is None:
        return False, []
    try:
        found = contradictions(scene, accuracy=accuracy)
    except (Refused, RunFailed) as failure:
        assert str(failure).strip()
        return False, []
    return True, [f"task {number} of seed {seed}: {each}\n{json.dumps(data)}" for each in found]


def contradictions(
    scene: Scene, rays: int = RAYS, accuracy: float = ACCURACY, share_of_run: float = _SHARE_OF_RUN
) -> list[str]:
    """In what a run of a scene, cells and random rays contradict each other."""
    target = _target(scene)
    *_, last = run(scene, target)
    found = validate(scene, target, last.state.heights, rays, accuracy=accuracy)
    return list(filter(None, _differences(last, found, share_of_run)))


def _target(scene: Scene) -> np.ndarray[Any, Any]:
    """A bright rectangle with a darker corner: not symmetric."""
    n_x, n_y = scene.receiver.pixels
    target = np.zeros((n_y, n_x))
    target[n_y // 4 : n_y - n_y // 4, n_x // 4 : n_x - n_x // 4] = 1
    target[n_y // 4 : n_y // 2, n_x // 4 : n_x // 2] = 0.4
    return target


def _differences(last: Snapshot, found: Validation, share_of_run: float) -> list[str | None]:
    by_check = (found.by_cells or found).efficiency
    apart = last.state.account.efficiency - by_check
    far = abs(apart) > share_of_run
    return [
        found.contradiction,
        f"the run is off by {apart:.4f} of all light: {by_check:.4f}" if far else None,
        _impossible("run", last.state.account),
        _impossible("check", found.account),
    ]


def _impossible(whose: str, account: Account) -> str | None:
    """A share below 0 or above 1, or light that is gained or lost in the sum."""
    data = account.to_data()
    emitted = data.pop("emitted")
    shares = np.array(list(data.values())) / emitted
    if shares.min() < -_ROUNDING or shares.max() > 1 + _ROUNDING:
        return (
            f"the account of the {whose} has a share from {shares.min():.4g} to {shares.max():.4g}"
        )
    if abs(shares.sum() - 1) > _ROUNDING:
        return f"the shares of the {whose} add up to {shares.sum():.6g}"
    return None
