"""The pages of the manual, which are Markdown in ``manual/``, in the order of their list."""

import re
from dataclasses import dataclass
from pathlib import Path

from resources import path

FIRST = "index.md"
"""Lists all pages."""

_LINK = re.compile(r"\]\(([\w-]+\.md)\)")


@dataclass(frozen=True)
class Page:
    """A page of the manual.

    Attributes
    ----------
    file : Path
        Where it lies.
    text : str
        Markdown, whose first line is the title.
    """

    file: Path
    text: str

    @property
    def title(self) -> str:
        """What lists call it."""
        return self.text.partition("\n")[0].removeprefix("# ")

    def holds(self, words: str) -> bool:
        """Whether each of some words is in it, in small letters or capitals."""
        text = self.text.casefold()
        return all(word in text for word in words.casefold().split())


def pages() -> list[Page]:
    """All pages, the list of them first.

    Returns
    -------
    list of Page
        In the order in which the list links to them.
    """
    first = _page(FIRST)
    return [first, *map(_page, dict.fromkeys(_LINK.findall(first.text)))]


def _page(name: str) -> Page:
    file = path("manual", name)
    return Page(file, file.read_text("utf-8"))
