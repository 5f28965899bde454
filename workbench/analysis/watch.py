"""How long work says how far it is."""

from collections.abc import Callable

Watch = Callable[[float], None]
"""Called now and then with the part that is done, from 0 to 1."""


def unwatched(part: float) -> None:
    """Take no notice."""


def part_of(watch: Watch, before: int, count: int, of: int) -> Watch:
    """The watch of work that is ``count`` of so many equal parts, with some before it."""
    return lambda part: watch((before + count * part) / of)
