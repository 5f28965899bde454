"""Which runs a session keeps to be compared, and what they are called."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

from ui.document.undo_steps import distinct_bytes
from ui.words import tr
from workbench.design.snapshot import STOPPED, Result
from workbench.files.header import MOST_RUNS
from workbench.files.session import KeptRun, Session
from workbench.scene import Scene

_BUDGET = 64 << 20  # bytes of all kept runs
_RUN, _FOLLOWED = "Run", "Followed"
_NUMBERED = re.compile(rf"({_RUN}|{_FOLLOWED}) (\d+): ")


def with_run(
    session: Session, result: Result, budget: int = _BUDGET
) -> tuple[Session, list[KeptRun]]:
    """Return the session with a result and its kept run, and the displaced runs."""
    return _with_kept(session, result, session.runs, _RUN, budget)


def with_followed(session: Session, result: Result) -> tuple[Session, list[KeptRun]]:
    """The session with a lens of live update, which is kept like a run.

    It replaces an unfinished lens of live update without a name of its own. An unfinished lens
    never displaces other runs.
    """
    others = tuple(run for run in session.runs if not _is_passing(run))
    kept, displaced = _with_kept(session, result, others, _FOLLOWED, _BUDGET)
    if displaced and result.ended == STOPPED:
        return replace(session, result=result, runs=others), []
    return kept, displaced


def _with_kept(
    session: Session, result: Result, others: Sequence[KeptRun], kind: str, budget: int
) -> tuple[Session, list[KeptRun]]:
    session = replace(session, result=result)
    if not result.iterations:
        return replace(session, runs=tuple(others)), []
    name = f"{kind} {_next_number(others)}: {_description(session.scene)}"
    runs = [*others, KeptRun(name, session.scene, session.target, result)]
    displaced = []
    while len(runs) > 1 and (len(runs) > MOST_RUNS or distinct_bytes(*runs) > budget):
        nameless = [run for run in runs[:-1] if not is_named(run)]
        followed = [run for run in nameless if run.name.startswith(_FOLLOWED)]
        oldest = [*followed, *nameless, runs[0]][0]
        runs.remove(oldest)
        displaced.append(oldest)
    return replace(session, runs=tuple(runs)), displaced


def _is_passing(run: KeptRun) -> bool:
    return run.name.startswith(_FOLLOWED) and not is_named(run) and run.result.ended == STOPPED


def restored(session: Session, run: KeptRun) -> Session:
    """Return the session with task and lens of a kept run."""
    again = session.with_scene(run.scene, run.target)  # for the locks, which hang on the net
    return replace(again, result=run.result, start=None)


def renamed(session: Session, run: KeptRun, name: str) -> Session:
    """The session with another name for a kept run."""
    other = replace(run, name=name)
    return replace(session, runs=tuple(other if each is run else each for each in session.runs))


def without(session: Session, runs: Iterable[KeptRun]) -> Session:
    """The session without some of its kept runs."""
    gone = {id(run) for run in runs}
    return replace(session, runs=tuple(run for run in session.runs if id(run) not in gone))


def is_named(run: KeptRun) -> bool:
    """Whether a person gave a run its name."""
    number = _NUMBERED.match(run.name)
    return number is None or run.name != number[0] + _description(run.scene)


def called(run: KeptRun) -> str:
    """Name of a run in the language of the window; a name given by the user stays."""
    number = _NUMBERED.match(run.name)
    if number is None or is_named(run):
        return run.name
    text = {
        _RUN: tr("Run {number}: {description}"),
        _FOLLOWED: tr("Live update {number}: {description}"),
    }[number[1]]
    return text.format(number=number[2], description=_description(run.scene))


def _next_number(runs: Iterable[KeptRun]) -> int:
    numbers = (_NUMBERED.match(run.name) for run in runs)
    return 1 + max((int(number[2]) for number in numbers if number), default=0)


def _description(scene: Scene) -> str:
    n_u, n_v = scene.optic.net_shape
    return f"{scene.run.method}, {n_u} × {n_v}"
