"""Ends long work between two of its steps, such as a run that is before its first lens."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar


class Interrupted(Exception):
    """Work was to end before it was complete."""


def _never() -> bool:
    return False


Question = ContextVar[Callable[[], bool]]
_asked_to_end: Question = ContextVar("asked_to_end", default=_never)
_given_up: Question = ContextVar("given_up", default=_never)


@contextmanager
def _answered(question: Question, answer: Callable[[], bool]) -> Iterator[None]:
    before = question.set(answer)
    try:
        yield
    finally:
        question.reset(before)


@contextmanager
def interrupted_when(asked_to_end: Callable[[], bool]) -> Iterator[None]:
    """Let the work of this thread end soon once that is true; what it has by then is wanted."""
    with _answered(_asked_to_end, asked_to_end):
        yield


@contextmanager
def given_up_when(given_up: Callable[[], bool]) -> Iterator[None]:
    """Let the work of this thread end at once when that is true: the rest of it is not wanted."""
    with _answered(_given_up, given_up):
        yield


def check_interruption() -> None:
    """Called now and then by long work that can do without the rest of it.

    Raises `Interrupted` if it is to end.
    """
    if _asked_to_end.get()():
        raise Interrupted
    check_given_up()


def check_given_up() -> None:
    """Called now and then by long work without whose end there is nothing to show.

    Raises `Interrupted` if it is not wanted any more.
    """
    if _given_up.get()():
        raise Interrupted
