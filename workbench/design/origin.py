"""Which task a lens was designed for."""

from collections.abc import Callable, Iterator
from operator import attrgetter
from typing import Any

import numpy as np

from workbench.design.session import KeptRun, Session, task_of
from workbench.said import Said

_MOST = 3  # differences between two tasks that are named
_ABSENT = Said("absent")


def origin(session: Session, called: Callable[[KeptRun], str] = attrgetter("name")) -> Said:
    """What the lens of a session was designed for, to be read after "the lens, ".

    The lens is looked for among the kept runs. Run settings are no part of a task: they say how to
    search, not what for.

    `session`: whose lens; `called`: names a kept run. Returns for another task, with the name of
    the run and what differs.
    """
    heights = session.heights
    if heights is None:
        return Said("not designed yet")
    found = [run for run in session.runs if run.result.state.heights == heights]
    if any(_is_of(session, run) for run in found):
        return Said("designed for this task")
    if found:
        differ = _differences(found[-1], session)
        some = {f"field_{number}": said for number, said in enumerate(differ[:_MOST])}
        more = ", …" if len(differ) > _MOST else ""
        return Said(
            "designed for another task ({run}): {differences}",
            run=called(found[-1]),
            differences=Said(", ".join(f"{{{name}}}" for name in some) + more, **some),
        )
    if session.result is not None and session.result.iterations:
        return Said("designed for this task")
    return Said("not designed for this task")


def _is_of(session: Session, run: KeptRun) -> bool:
    same_target = np.array_equal(run.target, session.target)
    return same_target and task_of(run.scene) == task_of(session.scene)


def _differences(run: KeptRun, session: Session) -> list[Said]:
    """Fields of the run's task whose values are others now."""
    then, now = (
        {path: value for path, value in _fields(each.scene.to_data(), "") if path[:4] != "run."}
        for each in (run, session)
    )
    changed = [
        Said(
            "{path} {then}, now {now}",
            path=path,
            then=then.get(path, _ABSENT),
            now=now.get(path, _ABSENT),
        )
        for path in (*then, *(now.keys() - then.keys()))
        if then.get(path) != now.get(path)
    ]
    return changed or [Said("another target image")]


def _fields(part: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Paths and values of plain data, as deep as there are names."""
    if isinstance(part, dict):
        for name, value in part.items():
            yield from _fields(value, f"{path}.{name}" if path else name)
    elif isinstance(part, list) and any(isinstance(each, dict) for each in part):
        for number, each in enumerate(part):
            yield from _fields(each, f"{path}[{number}]")
    else:
        yield path, part
