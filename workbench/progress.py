"""Progress reporting and cancellation."""

from collections.abc import Callable, Generator, Iterator
from contextlib import closing, contextmanager
from contextvars import ContextVar
from typing import Generic, TypeVar

T = TypeVar("T")
Step = TypeVar("Step")

Steps = Generator[float, None, T]
"""Work in steps: it yields the fraction that is done, up to 1, and returns its result."""

Progress = Callable[[float], None]
"""Called now and then with the fraction that is done, from 0 to 1."""


def no_progress(step: object) -> None:
    """Report nothing."""


def fraction_of(progress: Progress, before: int, count: int, of: int) -> Progress:
    """Return the progress of ``count`` of ``of`` equal parts, after ``before`` parts."""
    return lambda part: progress((before + count * part) / of)


class Followed(Generic[Step, T]):
    """Iterates steps, and has their ``result`` once they have ended.

    Examples
    --------
    >>> def steps():
    ...     yield 0.5
    ...     return "done"
    >>> followed = Followed(steps())
    >>> [*followed], followed.result
    ([0.5], 'done')
    """

    result: T

    def __init__(self, steps: Generator[Step, None, T]) -> None:
        self._steps = steps

    def __iter__(self) -> Iterator[Step]:
        self.result = yield from self._steps


def finished(
    steps: Generator[Step, None, T], progress: Callable[[Step], object] = no_progress
) -> T:
    """Run steps to their end, report what they yield, and return their result."""
    with closing(steps):
        followed = Followed(steps)
        for step in followed:
            progress(step)
        return followed.result


def of_equal(pieces: int, done: int, fraction: float) -> float:
    """Return the fraction that is done after ``done`` pieces and a fraction of the next one."""
    return (done + fraction) / pieces


def within(steps: Steps[T], fraction: Callable[[float], float]) -> Steps[T]:
    """Run steps within larger work; ``fraction`` maps their progress to that of the whole."""
    with closing(steps):
        followed = Followed(steps)
        for done in followed:
            yield fraction(done)
        return followed.result


class Interrupted(Exception):
    """The work was stopped before its end."""


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
    """Stop work of this thread soon once the answer is true; its partial result is wanted."""
    with _answered(_asked_to_end, asked_to_end):
        yield


@contextmanager
def given_up_when(given_up: Callable[[], bool]) -> Iterator[None]:
    """Stop work of this thread at once when the answer is true; its result is not wanted."""
    with _answered(_given_up, given_up):
        yield


def check_interruption() -> None:
    """Raise `Interrupted` if work with a partial result is to stop; long work calls this often."""
    if _asked_to_end.get()():
        raise Interrupted
    check_given_up()


def check_given_up() -> None:
    """Raise `Interrupted` if work without a partial result is to stop; it calls this often."""
    if _given_up.get()():
        raise Interrupted
