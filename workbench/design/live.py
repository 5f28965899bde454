"""The next lens for a task that somebody is editing: soon, then better and better.

Most edits are small, and the lens that is there is not far from the one that is wanted. One trace
tells its error in the new light, and what a lens by transport is worth is known from the last one
for this target:

- where its error is less, the run goes on from it: its first step is there several times sooner
  than transport;
- otherwise the light is sent anew by transport. From there the error is lower after the same time
  than from a lens whose light falls far beside the target.

Measured on the photograph (192² control points, 256² pixels, two busy cores; the screen moved by
1, 3 and 10 %): the lens that is there has 3.3, 6.0 and 13 % in its new light, which is seen after
0.06 s. A second later it has 2.7, 3.7 and 8.2 %. A lens by transport has 5.0 % after half a second,
whatever the edit was, and 3.3 % another half second later.
"""

import math
from collections.abc import Callable, Generator
from dataclasses import replace

import numpy as np

from workbench.arrays import Array
from workbench.design.lens_state import LensState
from workbench.design.loss import relative_error
from workbench.design.run import run
from workbench.design.session import Session, asked_of_the_lens
from workbench.design.snapshot import History, Snapshot
from workbench.errors import RunFailed
from workbench.geometry.faces import NO_LOCKS, ControlHeights, Locks
from workbench.scene import Scene

Generate = Callable[[Scene, Array, ControlHeights | None, Locks], Generator[Snapshot, None, str]]

# Relative error of a lens by transport where none was made for this target yet.
_BY_TRANSPORT = 0.06


class LiveDesign:
    """Designs the lenses of tasks each of which is an edit of the one before.

    Parameters
    ----------
    generate : callable, optional
        Makes the snapshots of a run; `workbench.design.run.run` by default.

    Examples
    --------
    >>> from resources import path
    >>> from workbench.files.session import open_design
    >>> task = open_design(path("examples", "tophat.json"))
    >>> lenses = LiveDesign().snapshots(task)
    >>> next(lenses).iteration, next(lenses).iteration
    (0, 1)
    >>> lenses.close()
    """

    def __init__(self, generate: Generate = run) -> None:
        self._generate = generate
        self._last: Session | None = None  # with the best lens that was made here
        self._by_transport: tuple[Array, float] | None = None  # a target, and the error for it

    def snapshots(self, session: Session, goes_on: bool = False) -> Generator[Snapshot, None, str]:
        """Design the lens of a session.

        Parameters
        ----------
        session : Session
            The task after the edit, with the lens as it stands, if there is one.
        goes_on : bool
            Begin with the best lens that was made here last, rather than with the session's.

        Yields
        ------
        Snapshot
            As from `workbench.design.run.run`, without stages. The first one is the lens that is
            there in its new light.

        Returns
        -------
        str
            Why there are no more.

        Raises
        ------
        Refused
            If the scene cannot be run here.
        RunFailed
            If the run cannot go on.
        """
        history = History()
        steps = self._steps(session, self._near(session) if goes_on else session.heights)
        try:
            while True:
                snapshot = next(steps)
                history.add(snapshot)
                if snapshot.best:
                    self._last = replace(session, result=history.result())
                yield snapshot
        except StopIteration as end:
            ended: str = end.value
        finally:
            steps.close()
        return ended

    def _near(self, session: Session) -> ControlHeights | None:
        if self._last is None:
            return session.heights
        near = self._last.with_scene(session.scene, session.target).heights
        return session.heights if near is None else near

    def _steps(
        self, session: Session, start: ControlHeights | None
    ) -> Generator[Snapshot, None, str]:
        scene, target, locked = session.scene, session.target, session.locked
        scene = scene.model_copy(update={"run": scene.run.model_copy(update={"stages": ()})})
        locks = any(mask.any() for mask in locked.values())
        present: Snapshot | None = None
        if start is not None:
            steps = self._generate(scene, target, start, locked)
            try:
                present = self._first(steps)
                if present is not None:
                    yield present
                if locks or (present is not None and self._is_near(present.state, target)):
                    return (yield from steps)
            finally:
                steps.close()
        return (yield from self._anew(scene, target, present))

    def _first(self, steps: Generator[Snapshot, None, str]) -> Snapshot | None:
        """The lens that is there; None where none of its light comes to the screen."""
        try:
            return next(steps)
        except RunFailed:
            return None

    def _is_near(self, state: LensState, target: Array) -> bool:
        known = self._by_transport
        most = known[1] if known is not None and known[0] is target else _BY_TRANSPORT
        return relative_error(state, target) <= most

    def _anew(
        self, scene: Scene, target: Array, present: Snapshot | None
    ) -> Generator[Snapshot, None, str]:
        """A run from transport; the undesigned lens is left out where one has been seen.

        It is no measure of what is best, either: for an even target it is better than the first
        lens by transport, and where bending costs much it can be so for long.
        """
        spent = 0.0 if present is None else present.seconds
        lowest = math.inf if present is None else present.merit
        steps = self._generate(scene, target, None, NO_LOCKS)
        try:
            while True:
                snapshot = next(steps)
                if snapshot.iteration == 1:
                    self._by_transport = target, relative_error(snapshot.state, target)
                if present is None:
                    yield snapshot
                elif snapshot.iteration:
                    best = snapshot.merit < lowest
                    lowest = min(lowest, snapshot.merit)
                    yield replace(snapshot, best=best, seconds=spent + snapshot.seconds)
        except StopIteration as end:
            ended: str = end.value
        finally:
            steps.close()
        return ended


def asks_for_another_lens(before: Session, after: Session) -> bool:
    """Whether an edit asks for another lens.

    One that only says how to search for it does not, and neither does another unit.
    """
    unit = after.scene.unit
    scene = before.scene if before.scene.unit == unit else before.scene.in_unit(unit)
    return _wanted(scene) != _wanted(after.scene) or not np.array_equal(before.target, after.target)


def _wanted(scene: Scene) -> tuple[object, ...]:
    """What tells which lens is the best one."""
    run = scene.run
    shop = run.smoothness, run.min_radius, run.min_tool_radius
    return asked_of_the_lens(scene), *shop
