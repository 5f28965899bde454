"""Which runs a session keeps to be compared, and what they are called."""

import re
from collections.abc import Iterable
from dataclasses import replace

from ui.document.memory import distinct_bytes
from ui.words import tr
from workbench.design.snapshot import Result
from workbench.files.header import MOST_RUNS
from workbench.files.session import KeptRun, Session
from workbench.scene import Scene

_BUDGET = 64 << 20  # bytes of all kept runs
_NUMBER = re.compile(r"Run (\d+): ")
_FOLLOWED = "Followed: "


def with_run(
    session: Session, result: Result, budget: int = _BUDGET
) -> tuple[Session, list[KeptRun]]:
    """The session after a run, which is kept.

    Parameters
    ----------
    session : Session
        What was designed.
    result : Result
        The lens that the run found.
    budget : int
        Bytes that all kept runs may take.

    Returns
    -------
    session : Session
        With the result, and with the run after the earlier ones. A run without an iteration has
        no course to compare and is not kept.
    given_way : list of KeptRun
        Those that had to make room: the oldest that nobody named, then the oldest. The latest
        always stays.
    """
    session = replace(session, result=result)
    if not result.iterations:
        return session, []
    name = f"Run {_next_number(session.runs)}: {_description(session.scene)}"
    runs = [*session.runs, KeptRun(name, session.scene, session.target, result)]
    given_way = []
    while len(runs) > 1 and (len(runs) > MOST_RUNS or distinct_bytes(*runs) > budget):
        nameless = (run for run in runs[:-1] if not is_named(run))
        oldest = next(nameless, runs[0])
        runs.remove(oldest)
        given_way.append(oldest)
    return replace(session, runs=tuple(runs)), given_way


def with_followed(session: Session, result: Result, budget: int = _BUDGET) -> Session:
    """The session with a lens that has followed an edit.

    It is kept as one run, which takes the place of the one that followed before, unless a person
    has named that. It takes no room from other runs: where there is none, it is not kept.
    """
    session = replace(session, result=result)
    name = f"{_FOLLOWED}{_description(session.scene)}"
    others = [run for run in session.runs if not run.name.startswith(_FOLLOWED) or is_named(run)]
    runs = [*others, KeptRun(name, session.scene, session.target, result)]
    if not result.iterations or len(runs) > MOST_RUNS or distinct_bytes(*runs) > budget:
        runs = others
    return replace(session, runs=tuple(runs))


def restored(session: Session, run: KeptRun) -> Session:
    """The session with a kept run's task and lens in place of its own."""
    again = session.with_scene(run.scene, run.target)  # for the locks, which hang on the net
    return replace(again, result=run.result, start=None)


def renamed(session: Session, run: KeptRun, name: str) -> Session:
    """The session with another name for a kept run.

    Raises
    ------
    Refused
        If the name is empty or too long.
    """
    other = replace(run, name=name)
    return replace(session, runs=tuple(other if each is run else each for each in session.runs))


def without(session: Session, runs: Iterable[KeptRun]) -> Session:
    """The session without some of its kept runs."""
    gone = {id(run) for run in runs}
    return replace(session, runs=tuple(run for run in session.runs if id(run) not in gone))


def is_named(run: KeptRun) -> bool:
    """Whether a person gave a run its name."""
    number = _NUMBER.match(run.name)
    given = _FOLLOWED if number is None else number[0]
    return run.name != given + _description(run.scene)


def called(run: KeptRun) -> str:
    """What a run is called in the language of the window; files keep the program's name in English.

    A name that a person gave stays as it is.
    """
    if is_named(run):
        return run.name
    number, description = _NUMBER.match(run.name), _description(run.scene)
    if number is None:
        return tr("Followed: {description}").format(description=description)
    return tr("Run {number}: {description}").format(number=number[1], description=description)


def _next_number(runs: Iterable[KeptRun]) -> int:
    numbers = (_NUMBER.match(run.name) for run in runs)
    return 1 + max((int(number[1]) for number in numbers if number), default=0)


def _description(scene: Scene) -> str:
    n_u, n_v = scene.optic.net_shape
    return f"{scene.run.method}, {n_u} × {n_v}"
