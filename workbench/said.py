"""A sentence with values in it, which can be said in another language later."""

from collections.abc import Mapping
from typing import Any, Self


class Said(str):
    """A sentence that remembers its words and its values.

    It is the English sentence; the window translates the words and puts the values in again.

    `**values`: by their names; ``optic`` and ``receiver`` are what these are called.

    Examples
    --------
    >>> said = Said("The {optic} turns it by {most:.0f}° at most.", optic="lens", most=48.2)
    >>> said
    'The lens turns it by 48° at most.'
    >>> said.words
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
