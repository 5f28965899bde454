"""Mean error of a lens over what is uncertain of its set-up, and compromises."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

from workbench.arrays import Array
from workbench.design.design_run import DesignRun
from workbench.design.levels import as_compared
from workbench.design.loss import relative_error
from workbench.design.session import Session, result_of
from workbench.errors import Refused
from workbench.messages import Message
from workbench.progress import Steps, of_equal, within
from workbench.scene import Scene
from workbench.scene.making.uncertainty import SHARES, Uncertainty


class ExpectedError(NamedTuple):
    """Relative L2 errors of the first image over cases of a set-up."""

    exact: float  # of the set-up as the scene says
    mean: float  # root of the mean square over all cases
    worst: float  # of the cases
    cases: int

    def to_data(self) -> dict[str, float]:
        """The figures by name, for JSON."""
        return self._asdict()


class Compromise(NamedTuple):
    """A lens whose run knew a part of the uncertainty, in the whole of it."""

    share: float  # of the standard deviations
    error: ExpectedError
    session: Session

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        return {"share": self.share, **self.error.to_data()}


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


def compromising(
    session: Session, shares: Sequence[float] = SHARES, iterations: int | None = None
) -> Steps[tuple[Compromise, ...]]:
    """Design lenses for parts of the scene's uncertainty in steps, each from the one before.

    `shares`: 0 gives the lens for the exact set-up, 1 that for the whole uncertainty. Raises
    `Refused` if nothing is uncertain, or the scene cannot be run.
    """
    scene, target, start = session.scene, session.target, session.heights
    if scene.uncertainty == Uncertainty():
        nothing = Message("nothing is uncertain; state standard deviations, such as of distance")
        raise Refused("uncertainty", nothing)
    found = []
    for number, share in enumerate(shares):
        part = scene.altered(uncertainty=scene.uncertainty.known(share))
        run = DesignRun(replace(session, scene=part, result=None, start=start, runs=()), iterations)
        yield from within(_progress(run), partial(of_equal, len(shares), number))
        start = result_of(run.session).state.heights
        found.append(Compromise(share, expected_error(scene, target, start), run.session))
    return tuple(found)


def _progress(run: DesignRun) -> Steps[None]:
    for snapshot in run:
        yield snapshot.iteration / max(snapshot.iterations, 1)
