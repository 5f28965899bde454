"""Table of all keys of the window."""

from collections.abc import Sequence

from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLineEdit,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ui.words import tr

_COLUMNS, _ROWS = 70, 24  # characters and lines seen at once


class Shortcuts(QDialog):
    """Searchable table of keys, beside the window."""

    def __init__(self, entries: Sequence[tuple[str, QAction]], window: QWidget) -> None:
        super().__init__(window)
        self.setWindowTitle(tr("Keyboard shortcuts"))
        self._field = QLineEdit(placeholderText=tr("Find by a part of the name, or by the key"))
        self._field.setAccessibleName(tr("Find a shortcut"))
        self._field.setClearButtonEnabled(True)
        self._field.textChanged.connect(self._find)
        self._table = QTreeWidget()
        self._table.setObjectName("commands")  # for the style sheet
        self._table.setAccessibleName(tr("Keyboard shortcuts"))
        self._table.setHeaderLabels([tr("Command"), tr("Key")])
        self._table.setRootIsDecorated(False)
        self._table.setAlternatingRowColors(True)
        self._table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        for name, action in entries:
            keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            if keys:
                item = QTreeWidgetItem([name, keys])
                item.setToolTip(0, action.statusTip())
                self._table.addTopLevelItem(item)
        header = self._table.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        for widget in (self._field, self._table, buttons):
            column.addWidget(widget)
        font = self.fontMetrics()
        wanted = font.averageCharWidth() * _COLUMNS, font.lineSpacing() * _ROWS
        self.resize(min(wanted[0], window.width()), min(wanted[1], window.height()))

    def _find(self, text: str) -> None:
        words = text.lower().split()
        for number in range(self._table.topLevelItemCount()):
            item = self._table.topLevelItem(number)
            if item is not None:
                listed = f"{item.text(0)} {item.text(1)}".lower()
                item.setHidden(not all(word in listed for word in words))
