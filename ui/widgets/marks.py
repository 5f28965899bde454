"""Marks beside sentences: good, to be looked at, bad, or a note."""

from typing import Literal

from PySide6.QtSvgWidgets import QSvgWidget

import resources

Sign = Literal["good", "attention", "bad", "note"]

_MARK = 16  # pixels


class Mark(QSvgWidget):
    """A tick on a disc, an exclamation mark on a triangle, a cross on an octagon, or an i.

    Their colours have a contrast of 3:1 at least to both grounds, and to white on them.
    """

    def __init__(self, sign: Sign) -> None:
        super().__init__()
        self.setFixedSize(_MARK, _MARK)
        self.show_sign(sign)

    def show_sign(self, sign: Sign) -> None:
        self.sign = sign
        self.load(str(resources.path("icons", f"mark-{sign}.svg")))
