"""Ends long work between two of its steps, such as a run that is before its first lens."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar


class Interrupted(Exception):
    """Work was to end before it was complete."""


def _never() -> bool:
    return False


_wanted: ContextVar[Callable[[], bool]] = ContextVar("wanted", default=_never)


@contextmanager
def interrupted_when(wanted: Callable[[], bool]) -> Iterator[None]:
    """Let the work of this thread be interrupted as soon as ``wanted`` is true."""
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
        If it is to end.
    """
    if _wanted.get()():
        raise Interrupted
