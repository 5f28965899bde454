"""What the second freeform face of a lens gained, for the log of its run."""

from collections.abc import Callable, Generator
from contextlib import closing

from workbench.design.endings import GAINED, NO_IMAGE
from workbench.design.room import Room
from workbench.design.step import Step
from workbench.errors import RunFailed
from workbench.progress import check_interruption
from workbench.said import Said

Steps = Generator[Step, None, str]

# The exit face alone is followed for so many iterations: they cost a third of those of two faces.
_ITERATIONS = 15


def with_gain(both: Steps, room: Room, steps: Callable[[Room], Steps]) -> Steps:
    """Pass on the steps of two faces, and say at the end how the exit face alone would do.

    `both`: steps from the first lens of two faces on; `room`: theirs; `steps`: makes steps in a
    room: that of the undesigned lens, then those from the first lens on. Returns why ``both``
    ended, and the errors of both after as many iterations.
    """
    losses: list[float] = []
    while True:
        try:
            step = next(both)
        except StopIteration as end:
            ended: str = end.value
            break
        losses.append(step.state.loss)
        yield step
    losses = losses[: 1 + _ITERATIONS]
    alone: list[float] = []
    try:
        with closing(steps(room.alone())) as one:
            next(one)  # undesigned
            for step, _ in zip(one, losses, strict=False):
                check_interruption()
                alone.append(step.state.loss)
    except RunFailed:
        return Said(NO_IMAGE, ended=ended)
    if not alone or min(alone) == 0:
        return ended
    return Said(
        GAINED,
        ended=ended,
        iterations=len(losses) - 1,
        times=min(losses) / min(alone),
    )
