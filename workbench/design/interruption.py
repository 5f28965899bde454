"""Ends a run within an iteration, where one takes seconds: before the first lens for instance."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar


class Interrupted(Exception):
    """A run was to end before its next iteration was complete."""


def _never() -> bool:
    return False


_wanted: ContextVar[Callable[[], bool]] = ContextVar("wanted", default=_never)


@contextmanager
def interrupted_when(wanted: Callable[[], bool]) -> Iterator[None]:
    """Let runs of this thread be interrupted as soon as ``wanted`` is true."""
    before = _wanted.set(wanted)
    try:
        yield
    finally:
        _wanted.reset(before)


def check_interruption() -> None:
    """Called now and then by long work.

    Raises
    ------
    Interrupted
        If its run is to end.
    """
    if _wanted.get()():
        raise Interrupted
