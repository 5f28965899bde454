"""A flat button with a menu of choices, for a plot that has no room for a row of them."""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu, QToolButton


class MenuButton(QToolButton):
    """Opens its menu by a click or a key.

    Parameters
    ----------
    text, tip : str
        What it is called, and what it is for.

    Attributes
    ----------
    chosen : Signal()
        Something in the menu is chosen.
    """

    chosen = Signal()

    def __init__(self, text: str, tip: str) -> None:
        super().__init__()
        self.setText(f"{text} ▾")  # the style's own arrow lies below the line
        self.setAccessibleName(text)
        self.setToolTip(tip)
        self.setAutoRaise(True)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setMenu(QMenu(self))

    def add_choice(self, texts: Sequence[str]) -> QActionGroup:
        """Add texts of which one is chosen, the first to begin with."""
        group = QActionGroup(self)
        for text in texts:
            group.addAction(self.add_toggle(text, on=not group.actions()))
        return group

    def add_toggle(self, text: str, on: bool) -> QAction:
        """Add a text that is on or off."""
        action = self.menu().addAction(text)
        action.setCheckable(True)
        action.setChecked(on)
        action.triggered.connect(self.chosen)
        return action


def chosen_of(group: QActionGroup) -> int:
    """Which one of a group is chosen."""
    return group.actions().index(group.checkedAction())


def choose(group: QActionGroup, number: int) -> None:
    """Choose one of a group without telling."""
    group.actions()[number].setChecked(True)
