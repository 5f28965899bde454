"""Mean error of a lens over what is uncertain of its set-up."""

import math
from collections.abc import Mapping
from typing import NamedTuple

from workbench.arrays import Array
from workbench.design.levels import as_compared
from workbench.design.loss import relative_error
from workbench.scene import Scene


class ExpectedError(NamedTuple):
    """Relative L2 errors of the first image over cases of a set-up."""

    exact: float  # of the set-up as the scene says
    mean: float  # root of the mean square over all cases
    worst: float  # of the cases
    cases: int

    def to_data(self) -> dict[str, float]:
        """The figures by name, for JSON."""
        return self._asdict()


def expected_error(scene: Scene, target: Array, heights: Mapping[str, Array]) -> ExpectedError:
    """Evaluate a lens in all cases of `Uncertainty.cases`, as a run sees it.

    `target` (n_y, n_x): in any scale; `heights` (n_u, n_v): control heights by face.
    """
    errors, mean = [], 0.0
    for case, probability in scene.uncertainty.cases(scene):
        error = relative_error(as_compared(case, target, heights), target)
        errors.append(error)
        mean += probability * error**2
    return ExpectedError(errors[0], math.sqrt(mean), max(errors), len(errors))
