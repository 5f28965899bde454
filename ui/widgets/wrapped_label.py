"""Words over some lines, which are not broken between a number and its unit."""

import re
from typing import Any

from PySide6.QtWidgets import QLabel

from workbench.units import METRES

_SPACE = "\N{NO-BREAK SPACE}"
_UNIT = rf"(?:%|{'|'.join(('lm', 'lx', 'cd', 'µm', 'nm', 's', *METRES))})(?![a-z])"
_BETWEEN = re.compile(rf"(?<=[\d⁰¹²³⁴⁵⁶⁷⁸⁹])( / | )(?={_UNIT})|(?<=\d) · (?=10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹])")


def kept_together(text: str) -> str:
    """Return a text with no-break spaces between numbers and their units.

    Examples
    --------
    >>> kept_together("50 mm away, 2.5 · 10⁻⁶ / mm²").replace(chr(160), "_")
    '50_mm away, 2.5_·_10⁻⁶_/_mm²'
    """
    return _BETWEEN.sub(lambda found: found[0].replace(" ", _SPACE), text)


class WrappedLabel(QLabel):
    """Label that wraps its text and keeps numbers with their units."""

    def __init__(self, text: str = "", **properties: Any) -> None:
        super().__init__(wordWrap=True, **properties)
        self.setText(text)

    def text(self) -> str:
        """The text as it was set."""
        return self._said

    def setText(self, text: str) -> None:
        """Set the text."""
        self._said = text
        super().setText(kept_together(text))

    def clear(self) -> None:
        """Remove the text."""
        self.setText("")
