"""Flat button with a menu of choices."""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QMenu, QToolButton


class MenuButton(QToolButton):
    """Button that opens its menu by a click or a key."""

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
        """Add exclusive choices; the first is checked."""
        group = QActionGroup(self)
        for text in texts:
            group.addAction(self.add_toggle(text, on=not group.actions()))
        return group

    def add_toggle(self, text: str, on: bool) -> QAction:
        """Add a checkable choice."""
        action = self.menu().addAction(text)
        action.setCheckable(True)
        action.setChecked(on)
        action.triggered.connect(self.chosen)
        return action


def chosen_of(group: QActionGroup) -> int:
    """Index of the checked action of a group."""
    return group.actions().index(group.checkedAction())


def choose(group: QActionGroup, number: int) -> None:
    """Check an action of a group without a signal."""
    group.actions()[number].setChecked(True)
