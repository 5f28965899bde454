"""Exceptions of the engine, and quotes of invalid values."""

from collections.abc import Iterator
from contextlib import contextmanager

LONGEST_QUOTE = 60
"""Most characters of a value or name that a sentence quotes."""


class Refused(Exception):
    """Input that cannot be used; its text is one sentence.

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
    """Prefix the paths of refusals in the block with ``whole``."""
    try:
        yield
    except Refused as refused:
        raise Refused(f"{whole}.{refused.path}", refused.reason) from None


class RunFailed(Exception):
    """A design run that cannot continue; the message is one sentence."""


def visible(text: str) -> str:
    """Escape characters that a terminal would interpret or cannot encode, as in names of files."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)


def shown(value: object) -> str:
    """Return a value as short text on one line."""
    text = repr(value)
    return text if len(text) <= LONGEST_QUOTE else text[: LONGEST_QUOTE - 3] + "..."
