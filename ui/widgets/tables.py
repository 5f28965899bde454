"""Tables of texts that are read, and two parts side by side."""

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QSplitter,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)


class Table(QTableWidget):
    """A table without grid, whose rows are selected and have two shades in turn."""

    def __init__(self, name: str, columns: int = 0) -> None:
        super().__init__(0, columns)
        self.setAccessibleName(name)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setFrameShape(QTableWidget.Shape.NoFrame)
        self.verticalHeader().hide()
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)

    def put(self, row: int, texts: Sequence[str], column: int = 0) -> None:
        """Write texts from a column on; each is its own tip, since it may be cut off."""
        for place, text in enumerate(texts, column):
            item = QTableWidgetItem(text)
            item.setToolTip(text)
            self.setItem(row, place, item)

    def add_action(self, text: str, keys: QKeySequence.StandardKey) -> QAction:
        """Add an action of the table that has a key."""
        action = QAction(text, self)
        action.setShortcut(QKeySequence(keys))
        action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        self.addAction(action)
        return action


def side_by_side(parts: Sequence[QWidget], shares: Sequence[int], width: int) -> QSplitter:
    """Return a splitter with parts that have these shares, in percent of a width."""
    splitter = QSplitter(Qt.Orientation.Horizontal)
    splitter.setChildrenCollapsible(False)
    for number, (part, share) in enumerate(zip(parts, shares, strict=True)):
        splitter.addWidget(part)
        splitter.setStretchFactor(number, share)
    splitter.setSizes([share * width // 100 for share in shares])
    return splitter
