"""How long work says how far it is, and is left."""

from collections.abc import Callable, Generator
from contextlib import closing
from typing import TypeVar

T = TypeVar("T")
Step = TypeVar("Step")

Steps = Generator[float, None, T]
"""Work step by step: it yields the part that is done, up to 1, and returns what it has found."""

Watch = Callable[[float], None]
"""Called now and then with the part that is done, from 0 to 1."""


def unwatched(step: object) -> None:
    """Take no notice."""


def fraction_of(watch: Watch, before: int, count: int, of: int) -> Watch:
    """The watch of work that is ``count`` of so many equal parts, with some before it."""
    return lambda part: watch((before + count * part) / of)


def finished(steps: Generator[Step, None, T], watch: Callable[[Step], object] = unwatched) -> T:
    """Take steps to their end; those that yield the part of them that is done can be watched."""
    with closing(steps):
        while True:
            try:
                watch(next(steps))
            except StopIteration as end:
                found: T = end.value
                return found


def of_equal(pieces: int, done: int, fraction: float) -> float:
    """The part of equal pieces that is done after some of them and a part of the next."""
    return (done + fraction) / pieces


def within(steps: Steps[T], fraction: Callable[[float], float]) -> Steps[T]:
    """Take steps that yield the part of them that is done, as steps of something larger.

    `steps`: the steps; closed when these are left; `fraction`: what part of the whole is done when
    that part of the steps is.
    """
    with closing(steps):
        while True:
            try:
                done = next(steps)
            except StopIteration as end:
                found: T = end.value
                return found
            yield fraction(done)
