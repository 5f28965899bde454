"""Snapshots of a run, the result that they add up to, its pace and why it ended."""

from collections import deque
from collections.abc import Generator
from dataclasses import dataclass, replace
from itertools import pairwise
from statistics import median
from typing import Any, Self

import numpy as np

from workbench.arrays import Array
from workbench.design.lens_state import LensState
from workbench.errors import RunFailed
from workbench.messages import Message
from workbench.progress import Interrupted

DONE = "all iterations are done"
LOCKED = "all control points are locked"
STOPPED = "stopped"
MET = "goal met: error {error} of at most {goal}"
SMALL = "converged: error below {error:g} %"
LOWEST = "converged: no step makes the image better"
SLOW = "converged: less than {gain:g} % better in {patience} iterations"
FLAT = "converged: error less than {points:g} percentage points lower in {patience} iterations"
OTHERWISE_WORSE = "converged: in the light of other points of the source the image gets worse"
IN_VAIN = "{ended}; no iteration made the lens better"
NO_IMAGE = "{ended}; the exit face alone makes no image"
GAINED = (
    "{ended}; after {iterations} iterations the error of both faces was {times:.2g} times that "
    "of the exit face behind a flat entrance"
)
FAILED = "failed: {why}"

CONVERGED = (SMALL, LOWEST, SLOW, FLAT, OTHERWISE_WORSE)
ENDINGS = (DONE, LOCKED, STOPPED, MET, *CONVERGED, IN_VAIN, NO_IMAGE, GAINED)
"""All but failures, whose reasons are without number."""


def has_converged(ended: str) -> bool:
    """Whether a run ended because nothing got better."""
    if not isinstance(ended, Message):
        return False
    return ended.words in CONVERGED or has_converged(ended.values.get("ended", ""))


@dataclass(frozen=True)
class Snapshot:
    """The lens and its image after some iterations.

    Attributes
    ----------
    state : LensState
        The lens, with the net of the whole design, and its light.
    iteration : int
        Steps taken so far; 0 is the lens before the first.
    iterations : int
        Steps that the run will take at most.
    seconds : float
        Run time up to here.
    merit : float
        What the best lens of a stage has least of: its loss, and what else the scene
        asks of it.
    best : bool
        Whether this is the best lens of its stage so far.
    stage : int
        Number of the stage, an index of `Scene.stage_scenes`.
    stages : int
        How many stages the run has, the scene itself included.
    notes : tuple of str
        What was chosen for the trace of this lens, and what was left out.
    judged : bool
        Whether it is the lens of a run that is best in light that it was not fitted to, once more.
    """

    state: LensState
    iteration: int
    iterations: int
    seconds: float
    merit: float
    best: bool
    stage: int = 0
    stages: int = 1
    notes: tuple[str, ...] = ()
    judged: bool = False


@dataclass(frozen=True)
class Result:
    """The best lens of a run, and how the run went.

    Attributes
    ----------
    state : LensState
        The best lens and its light.
    losses : ndarray, shape (iterations,)
        Loss after each iteration.
    stage_starts : tuple of int
        Numbers of losses before each stage but the first began.
    seconds : float
        Run time.
    stages_left : int
        Stages that were still to come for this lens; 0 for one of the scene itself. Counted from
        the end, since stages may be put before a run that is done.
    seconds_at : ndarray, shape (iterations,), optional
        Run time at the end of each iteration; None where it was not kept.
    ended : str
        Why the run ended, as `History.follow` says it; empty where it was not kept.
    """

    state: LensState
    losses: Array
    seconds: float
    stage_starts: tuple[int, ...] = ()
    stages_left: int = 0
    seconds_at: Array | None = None
    ended: str = ""

    @property
    def iterations(self) -> int:
        """Iterations taken."""
        return len(self.losses)

    def with_state(self, **changes: Any) -> Self:
        """The result with some fields of its lens's state changed."""
        return replace(self, state=replace(self.state, **changes))

    def times(self) -> Array:
        """Run time at the end of each iteration; evenly spread where it was not kept."""
        if self.seconds_at is not None:
            return self.seconds_at
        count = self.iterations
        return np.linspace(self.seconds / max(count, 1), self.seconds, count)


class History:
    """Gathers the snapshots of a run, one after the other, into a `Result`.

    `earlier`: the result that this run continues; its losses and seconds are counted in.
    """

    def __init__(self, earlier: Result | None = None) -> None:
        self._earlier = earlier
        self._losses: list[float] = []
        self._seconds_at: list[float] = []
        self._best: Snapshot | None = None
        self._last: Snapshot | None = None
        self._stage_starts: list[int] = []
        self._ended = ""

    def follow(self, run: Generator[Snapshot, None, str]) -> Generator[Snapshot, None, None]:
        """Take in the snapshots of a run as they pass, and at last why there are no more.

        That is what the run returns, and whether it was in vain; "stopped" if this generator is
        closed or interrupted before; "failed: …" with the exception, which goes on to the caller.
        """
        try:
            while True:
                snapshot = next(run)
                self.add(snapshot)
                yield snapshot
        except StopIteration as end:
            self._ended = end.value
            if self._losses and self._best is not None and self._best.iteration == 0:
                self._ended = Message(IN_VAIN, ended=self._ended)
        except Interrupted:
            self._ended = Message(STOPPED)
        except (GeneratorExit, KeyboardInterrupt):
            self._ended = Message(STOPPED)
            raise
        except Exception as error:
            why = error.args[0] if isinstance(error, RunFailed) else str(error)
            self._ended = Message(FAILED, why=why)
            raise
        finally:
            run.close()

    def add(self, snapshot: Snapshot) -> None:
        """Take in the next snapshot."""
        if snapshot.judged and self._best is not None:
            self._best, self._last = replace(self._best, state=snapshot.state), snapshot
            return
        if self._last is not None and snapshot.stage != self._last.stage:
            self._stage_starts.append(len(self._losses))
        if snapshot.iteration > 0:
            self._losses.append(snapshot.state.loss)
            self._seconds_at.append(snapshot.seconds)
        if snapshot.best:
            self._best = snapshot
        self._last = snapshot

    def losses(self) -> Array:
        """Loss after each iteration so far, those of the continued run first."""
        new = np.array(self._losses, dtype=np.float64)
        return new if self._earlier is None else np.concatenate([self._earlier.losses, new])

    def times(self) -> Array:
        """Run time at the end of each of these iterations, that of the continued run included."""
        new = np.array(self._seconds_at, dtype=np.float64)
        if self._earlier is None:
            return new
        return np.concatenate([self._earlier.times(), self._earlier.seconds + new])

    def stage_starts(self) -> tuple[int, ...]:
        """Numbers of losses before each stage but the first began, the continued run included."""
        if self._earlier is None:
            return tuple(self._stage_starts)
        before = self._earlier.iterations
        resumed = () if self._last is None else (before,)
        return (
            *self._earlier.stage_starts,
            *resumed,
            *(before + start for start in self._stage_starts),
        )

    def result(self) -> Result | None:
        """The best lens so far; None before the first snapshot."""
        return None if self._best is None else self.ended_with(self._best)

    def ended_with(self, snapshot: Snapshot) -> Result:
        """The result if this were the best lens of all so far."""
        seconds = 0.0 if self._last is None else self._last.seconds
        return Result(
            state=snapshot.state,
            losses=self.losses(),
            seconds=seconds + (self._earlier.seconds if self._earlier else 0.0),
            stage_starts=self.stage_starts(),
            stages_left=snapshot.stages - 1 - snapshot.stage,
            seconds_at=self.times(),
            ended=self._ended,
        )


_SPAN = 4.0  # seconds of run time that count as recent
# Steps that show a pace. The first design and the first step, in which kernels are compiled, do not
# count, and one slow step among others does not count: of a run of 33 s the time left was first
# given as 75 minutes.
_STEPS = 3


class Pace:
    """Pace of the measured steps of the last seconds of run time; pauses do not count."""

    def __init__(self) -> None:
        self._seen: deque[tuple[float, int]] = deque()

    def note(self, seconds: float, iteration: int) -> None:
        """Take note of how far a run is; another run begins anew."""
        seen = self._seen
        if seen and (iteration < seen[-1][1] or seconds < seen[-1][0]):
            seen.clear()
        if iteration == 0 or (seen and iteration == seen[-1][1]):
            return
        seen.append((seconds, iteration))
        while len(seen) > 1 + _STEPS and seconds - seen[1][0] >= _SPAN:
            seen.popleft()

    @property
    def rate(self) -> float | None:
        """Iterations a second; None until enough steps have been measured."""
        seen = list(self._seen)
        if not seen or seen[-1][1] - seen[0][1] < _STEPS:
            return None
        step = median(
            each
            for (began, first), (ended, last) in pairwise(seen)
            for each in [(ended - began) / (last - first)] * (last - first)
        )
        return 1 / step if step > 0 else None

    def left(self, iterations: int) -> float | None:
        """Seconds that so many more iterations take at this pace; None until it is known."""
        rate = self.rate
        return None if rate is None else iterations / rate
