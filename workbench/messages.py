"""A translatable message with values, and capitals of texts."""

import unicodedata
from collections.abc import Mapping
from typing import Any, Self


class Stated(float):
    """A number of a message that is one of the field whose value is refused."""


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

    def times(self, factor: float) -> "Message":
        """Return the message for a field that is shown as a multiple: see `Stated`."""
        values = {
            name: factor * value if isinstance(value, Stated) else value
            for name, value in self.values.items()
        }
        return Message(self.words, **values)

    def __getnewargs_ex__(self) -> tuple[tuple[str], dict[str, Any]]:
        return (self.words,), dict(self.values)


def capitalised(text: str) -> str:
    """Capitalise a text; symbols such as λ stay small."""
    if not (text and unicodedata.name(text[0], "").startswith("LATIN")):
        return text
    return text[0].upper() + text[1:]
