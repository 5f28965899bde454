"""The two ways in which the engine says no, and how they quote what is wrong."""

from collections.abc import Iterator
from contextlib import contextmanager

LONGEST_QUOTE = 60
"""Most characters of a value or name that a sentence quotes."""


class Refused(Exception):
    """Input that cannot be used, said in one sentence.

    Parameters
    ----------
    path : str
        What is refused: a field of the scene (``lens.control_points[0]``) or a file.
    reason : str
        The offending value, what is wrong with it and what is allowed.
    """

    # Not a ValueError: pydantic would wrap it and lose the path.
    def __init__(self, path: str, reason: str) -> None:
        super().__init__(f"{path}: {reason}")
        self.path = path
        self.reason = reason


@contextmanager
def refused_within(whole: str) -> Iterator[None]:
    """Give refusals of a part's fields their paths from the whole: ``whole`` stands before them."""
    try:
        yield
    except Refused as refused:
        raise Refused(f"{whole}.{refused.path}", refused.reason) from None


class RunFailed(Exception):
    """A design run that cannot go on, said in one sentence."""


def visible(text: str) -> str:
    """Text without what a terminal obeys or no encoding has: names of files come from strangers."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)


def shown(value: object) -> str:
    """A value as a sentence can hold it: on one line, and short."""
    text = repr(value)
    return text if len(text) <= LONGEST_QUOTE else text[: LONGEST_QUOTE - 3] + "..."
