"""Command palette."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QHeaderView,
    QLineEdit,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)
from shiboken6 import isValid

from ui.widgets.controls import filled
from ui.widgets.labels import WrappedLabel
from ui.widgets.search import folded, holds
from ui.words import tr

SEPARATOR = " \N{RIGHTWARDS ARROW} "
"""Between the menu and the command in a name."""

_SHARE, _PALETTE_ROWS = 0.45, 14  # of the window's width, and commands seen at once
_MARGIN = 12  # around a sentence in place of the list
_MOVES = (Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown)


class CommandPalette(QDialog):
    """Popup list of commands and their keys, found by either.

    Enter or a click runs a command, Escape closes. ``with_keys``: lists only those with keys.
    """

    def __init__(
        self, entries: Sequence[tuple[str, QAction]], window: QWidget, *, with_keys: bool = False
    ) -> None:
        super().__init__(window, Qt.WindowType.Popup)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setAccessibleName(tr("Command palette"))
        self._entries = [each for each in entries if not with_keys or _keys_of(each[1])]
        self._field = QLineEdit(placeholderText=tr("Search commands"))
        self._field.setClearButtonEnabled(True)
        self._field.textChanged.connect(self._find)
        self._field.installEventFilter(self)
        self._found = QTreeWidget()
        self._found.setObjectName("commands")  # for the style sheet
        self._found.setColumnCount(2)
        self._found.setHeaderHidden(True)
        self._found.setRootIsDecorated(False)
        self._found.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # typing goes on in the field
        header = self._found.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        self._found.itemClicked.connect(self._do)
        self._nothing = WrappedLabel(
            alignment=Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop
        )
        self._nothing.setTextFormat(Qt.TextFormat.PlainText)  # what is typed may have tags
        self._nothing.setMargin(_MARGIN)
        filled(QVBoxLayout(self), self._field, (self._found, 1), (self._nothing, 1))
        self._find("")
        self._field.setFocus()
        row = self._found.sizeHintForRow(0)
        self.resize(int(_SHARE * window.width()), (_PALETTE_ROWS + 3) * row)
        self.move(window.mapToGlobal(QPoint((window.width() - self.width()) // 2, 2 * row)))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent):
            if event.key() in _MOVES:
                self._found.keyPressEvent(event)
                return True
            if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                self._do(self._found.currentItem())
                return True
        return super().eventFilter(watched, event)

    def _find(self, text: str) -> None:
        words = folded(text).split()
        fitting = [
            (name, number)
            for number, (name, action) in enumerate(self._entries)
            if isValid(action)  # files that were open last come and go meanwhile
            and holds(f"{name} {_keys_of(action)}", words)
        ]
        first = words[0] if words else ""
        fitting.sort(key=lambda entry: _rank(entry[0], first))
        self._found.clear()
        for name, number in fitting:
            action = self._entries[number][1]
            item = QTreeWidgetItem([name, _keys_of(action)])
            item.setData(0, Qt.ItemDataRole.UserRole, number)
            item.setToolTip(0, action.statusTip())
            item.setDisabled(not action.isEnabled())
            self._found.addTopLevelItem(item)
        able = (item for item in self._items() if not item.isDisabled())
        self._found.setCurrentItem(next(able, None))  # type: ignore[arg-type]
        self._nothing.setText(tr("No command found: {words}").format(words=text))
        self._nothing.setVisible(not fitting)
        self._found.setVisible(bool(fitting))

    def _items(self) -> list[QTreeWidgetItem]:
        items = (self._found.topLevelItem(k) for k in range(self._found.topLevelItemCount()))
        return [item for item in items if item is not None]

    def _do(self, item: QTreeWidgetItem | None) -> None:
        if item is not None and not item.isDisabled():
            action = self._entries[item.data(0, Qt.ItemDataRole.UserRole)][1]
            if not isValid(action):
                self._find(self._field.text())
                return
            self.close()  # before the command, which may ask something
            action.trigger()


def _rank(name: str, begin: str) -> tuple[bool, int]:
    *menus, own = folded(name).split(SEPARATOR)
    return not own.startswith(begin), len(menus)


def _keys_of(action: QAction) -> str:
    return action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
