"""Filling of layouts, buttons, choices, table, splitter, and a picture beside its form."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, QSize, Qt
from PySide6.QtGui import QAction, QIcon, QKeySequence, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QBoxLayout,
    QComboBox,
    QFrame,
    QGridLayout,
    QHeaderView,
    QLayout,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QSplitter,
    QTableWidget,
    QTableWidgetItem,
    QToolBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

Part = QWidget | QLayout
Item = Part | int | tuple[Part, int]
"""A part, perhaps with its stretch factor, or a stretch."""
Box = TypeVar("Box", bound=QBoxLayout)
Widget = TypeVar("Widget", bound=QWidget)

STRETCH = 1
"""Empty space between the parts of a layout."""


def filled(
    box: Box,
    *items: Item,
    margins: tuple[int, int, int, int] | int | None = None,
    spacing: int | None = None,
) -> Box:
    """Fill a layout with parts and stretches."""
    if margins is not None:
        box.setContentsMargins(*(4 * (margins,) if isinstance(margins, int) else margins))
    if spacing is not None:
        box.setSpacing(spacing)
    for item in items:
        part, factor = item if isinstance(item, tuple) else (item, 0)
        if isinstance(part, int):
            box.addStretch(part)
        elif isinstance(part, QWidget):
            box.addWidget(part, factor)
        else:
            box.addLayout(part, factor)
    return box


def named(widget: Widget, name: str, tip: str = "") -> Widget:
    """Return a widget with an accessible name and a tip."""
    widget.setAccessibleName(name)
    widget.setToolTip(tip)
    return widget


def push_button(text: str, tip: str, act: Callable[[], object], name: str = "") -> QPushButton:
    """Return a button that acts when it is clicked; a sign as its text needs a name."""
    button = named(QPushButton(text), name, tip)
    button.clicked.connect(lambda _: act())
    return button


def tool_button(text: str, tip: str, act: Callable[[], object], name: str = "") -> QToolButton:
    """Return a small button that acts when it is clicked; a sign as its text needs a name."""
    button = named(QToolButton(), name, tip)
    button.setText(text)
    button.clicked.connect(lambda _: act())
    return button


class Chooser(QComboBox):
    """A choice among titled values, which the mouse wheel scrolls past."""

    def __init__(self, titles: Mapping[Any, str]) -> None:
        super().__init__()
        for value, title in titles.items():
            self.addItem(title, value)
        # Long entries must not widen the whole form.
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(4)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def choose(self, value: object) -> None:
        self.setCurrentIndex(self.findData(value))

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()


class Choice(QComboBox):
    """A choice among titled values; hidden where there is only one."""

    def __init__(self, name: str, tip: str = "") -> None:
        super().__init__()
        named(self, name, tip)

    def offer(self, titles: Mapping[Any, str], chosen: object) -> None:
        """Offer titles by values, and choose one of them or else the first, without a signal."""
        with QSignalBlocker(self):
            if titles != {self.itemData(n): self.itemText(n) for n in range(self.count())}:
                self.clear()
                for value, title in titles.items():
                    self.addItem(title, value)
            self.setCurrentIndex(max(self.findData(chosen), 0))
        self.setVisible(len(titles) > 1)


_WIDE = 1.3  # times as wide as high
_IN_A_ROW = 2  # buttons below a form
_HIGH, _OTHER_HIGH = 200, 160  # pixels; a lower picture would be labels alone


def command_button(command: QAction) -> QToolButton:
    """Return a button for a command, with its name."""
    button = QToolButton()
    button.setDefaultAction(command)
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
    button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    return button


def name_extension(bar: QToolBar, name: str) -> None:
    """Name the button for what a toolbar has no room for; the style's icon is dark on dark."""
    for more in bar.findChildren(QToolButton, "qt_toolbar_ext_button"):
        more.setAccessibleName(name)
        more.setIcon(QIcon())
        more.setText("»")


class SideBySide(QWidget):
    """Gives the picture all space that the form does not need; the form scrolls."""

    def __init__(self, picture: QWidget, other: QWidget, buttons: Sequence[QWidget]) -> None:
        super().__init__()
        self._line = QBoxLayout(QBoxLayout.Direction.TopToBottom, self)
        self._line.setContentsMargins(0, 0, 0, 0)
        self._line.setSpacing(0)
        self._line.addWidget(picture, 1)
        beside = QVBoxLayout()
        rows = QGridLayout()
        rows.setContentsMargins(6, 2, 6, 6)
        for number, button in enumerate(buttons):
            rows.addWidget(button, *divmod(number, _IN_A_ROW))
        beside.addWidget(_Scrolled(other, _OTHER_HIGH - rows.sizeHint().height()))
        beside.addLayout(rows)
        self._line.addLayout(beside)
        picture.setMinimumHeight(_HIGH)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        wide = self.width() > _WIDE * self.height()
        directions = QBoxLayout.Direction
        self._line.setDirection(directions.LeftToRight if wide else directions.TopToBottom)


class _Scrolled(QScrollArea):
    def __init__(self, held: QWidget, least: int) -> None:
        super().__init__()
        self._held, self._least = held, least
        self.setWidget(held)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)

    def sizeHint(self) -> QSize:
        bar = self.verticalScrollBar().sizeHint().width()
        return self._held.sizeHint() + QSize(bar, 0)

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        return QSize(least.width(), min(self.sizeHint().height(), self._least))


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
        self.setTabKeyNavigation(False)  # Tab leads on; arrows move within
        self.verticalHeader().hide()
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)

    def fill(self, rows: Sequence[Sequence[str]]) -> None:
        """Show rows of texts in place of those that are there."""
        self.setRowCount(len(rows))
        for number, texts in enumerate(rows):
            self.put(number, texts)

    def put(self, row: int, texts: Sequence[str], tip: str = "", bold: bool = False) -> None:
        """Write texts with a tip; by default each is its own tip, since it may be cut off."""
        font = self.font()
        font.setBold(bold)
        for column, text in enumerate(texts):
            item = QTableWidgetItem(text)
            item.setToolTip(tip or text)
            item.setFont(font)
            self.setItem(row, column, item)

    def add_action(self, text: str, keys: QKeySequence.StandardKey) -> QAction:
        """Add an action of the table that has a key."""
        action = QAction(text, self)
        action.setShortcut(QKeySequence(keys))
        action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        self.addAction(action)
        return action


def scrolled(held: QWidget, *, across: bool = False) -> QScrollArea:
    """Return a frameless area in which a widget scrolls down, and perhaps across."""
    area = QScrollArea(widgetResizable=True)
    area.setWidget(held)
    area.setFrameShape(QFrame.Shape.NoFrame)
    if not across:
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    return area


def side_by_side(parts: Sequence[QWidget], shares: Sequence[int], width: int) -> QSplitter:
    """Return a splitter with parts that have these shares, in percent of a width."""
    splitter = QSplitter(Qt.Orientation.Horizontal)
    splitter.setChildrenCollapsible(False)
    for number, (part, share) in enumerate(zip(parts, shares, strict=True)):
        splitter.addWidget(part)
        splitter.setStretchFactor(number, share)
    splitter.setSizes([share * width // 100 for share in shares])
    return splitter
