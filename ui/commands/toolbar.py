"""Toolbar whose buttons have names beside their icons, as many as its width holds."""

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import QMainWindow, QToolBar, QToolButton

from ui.widgets.controls import name_extension
from ui.words import tr

Group = Sequence[QAction]


class Toolbar(QToolBar):
    """Groups of commands; ``named_first`` returns the groups in the order in which they get names.

    The first of these groups always has names. A wider window names one group after the other.
    """

    def __init__(
        self, window: QMainWindow, groups: Sequence[Group], named_first: Sequence[Group]
    ) -> None:
        super().__init__(tr("Toolbar"), window)
        self.setObjectName("toolbar")
        self.setMovable(False)
        for number, group in enumerate(groups):
            if number:
                self.addSeparator()
            self.addActions(list(group))
        name_extension(self, tr("More commands"))
        self._groups = [[self.widgetForAction(each) for each in group] for group in named_first]
        self._texts: list[str] = []

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.name_buttons()

    def follow_texts(self) -> None:
        """Name the buttons again if a command has another text."""
        texts = [action.iconText() for action in self.actions()]
        if texts != self._texts:
            self._texts = texts
            self.name_buttons()

    def name_buttons(self) -> None:
        """Show the names of as many groups as there is room for."""
        styles = Qt.ToolButtonStyle
        first, *others = self._groups
        _set_style(first, styles.ToolButtonTextBesideIcon)
        for group in others:
            _set_style(group, styles.ToolButtonIconOnly)
        for group in others:
            _set_style(group, styles.ToolButtonTextBesideIcon)
            if self.sizeHint().width() > self.width():
                _set_style(group, styles.ToolButtonIconOnly)
                return


def _set_style(buttons: Sequence[object], style: Qt.ToolButtonStyle) -> None:
    for button in buttons:
        if isinstance(button, QToolButton):
            button.setToolButtonStyle(style)
