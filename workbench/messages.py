"""A translatable message with values."""

from collections.abc import Mapping
from typing import Any, Self


class Message(str):
    """English text that keeps its words and values, so that the window can translate it.

    Examples
    --------
    >>> message = Message("The {optic} turns it by {most:.0f}° at most.", optic="lens", most=48.2)
    >>> message
    'The lens turns it by 48° at most.'
    >>> message.words
    'The {optic} turns it by {most:.0f}° at most.'
    """

    words: str
    values: Mapping[str, Any]

    def __new__(cls, words: str, **values: Any) -> Self:
        """Put the values into the words."""
        made = super().__new__(cls, words.format(**values))
        made.words, made.values = words, values
        return made

    def __getnewargs_ex__(self) -> tuple[tuple[str], dict[str, Any]]:
        return (self.words,), dict(self.values)
