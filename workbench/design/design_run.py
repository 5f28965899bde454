"""A run of a session: what it yields on the way, and the session that it leaves."""

from collections.abc import Generator
from dataclasses import replace

from workbench.design.session import Session
from workbench.design.snapshot import History, Snapshot
from workbench.scene import Scene


class DesignRun:
    """Improves the lens of a session; iterate over it to see one snapshot after the other.

    Leaving the loop ends the run, and not asking for the next snapshot pauses it. Another loop goes
    on from the best lens so far.

    Parameters
    ----------
    session : Session
        What to design. A lens that is there is gone on from, and its locked control points stay.
    iterations : int, optional
        Upper limit in place of the scene's.

    Attributes
    ----------
    history : History
        What the last loop has seen.

    Raises
    ------
    Refused
        If there are more or fewer iterations than a scene may have. In the loop, if the scene
        cannot be run.
    RunFailed
        In the loop, if the run cannot go on; the best lens up to then stays.

    Examples
    --------
    >>> from workbench import DesignRun, load
    >>> from resources import path
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=2)
    >>> [snapshot.iteration for snapshot in run]
    [0, 1, 2]
    >>> run.session.result.ended
    'all iterations are done'
    """

    def __init__(self, session: Session, iterations: int | None = None) -> None:
        if iterations is not None:
            session = replace(session, scene=_with_iterations(session.scene, iterations))
        self._first, self.history = session, History(session.result)

    @property
    def session(self) -> Session:
        """The session with the best lens so far; as it was before the first snapshot."""
        result = self.history.result()
        return self._first if result is None else replace(self._first, result=result)

    def __iter__(self) -> Generator[Snapshot, None, None]:
        from workbench.design.run import run  # late: torch takes seconds to import

        session = self._first = self.session
        self.history = History(session.result)
        start, locked = session.heights, session.locked
        yield from self.history.follow(run(session.scene, session.target, start, locked))


def _with_iterations(scene: Scene, iterations: int) -> Scene:
    data = scene.to_data()
    data["run"]["iterations"] = iterations
    return Scene.from_data(data).with_contents_of(scene)
