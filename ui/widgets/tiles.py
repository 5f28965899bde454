"""Tiles with a picture, a title and a sentence, of which one is chosen by a click or a key."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QImage,
    QKeyEvent,
    QPainter,
    QPainterPath,
    QPen,
    QResizeEvent,
    QTextDocument,
    QWheelEvent,
)
from PySide6.QtWidgets import (
    QFrame,
    QListView,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
)

from ui.widgets import theme

_GAP, _INSIDE, _ROUND = 8, 8, 6  # pixels between tiles, around texts, of corners
_KEYS = Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space
_BY_KEY = (
    Qt.FocusReason.TabFocusReason,
    Qt.FocusReason.BacktabFocusReason,
    Qt.FocusReason.ShortcutFocusReason,
)
_Index = QModelIndex | QPersistentModelIndex


@dataclass(frozen=True)
class Tile:
    """What a tile shows; its picture is made when it is painted first."""

    title: str
    about: str
    picture: Callable[[], QImage] = QImage


@dataclass(frozen=True)
class Shape:
    """Least width of tiles, height of a picture for its width, and whether a sentence is below."""

    width: int
    picture: float
    with_about: bool = True


class Tiles(QListWidget):
    """As many tiles in a line as fit; as high as they need, since the page around it scrolls."""

    chosen = Signal(int)
    come_to = Signal(QRect)  # of the current tile, by a key

    def __init__(self, name: str, shape: Shape) -> None:
        super().__init__()
        self._shape = shape
        self.setAccessibleName(name)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.viewport().setAutoFillBackground(False)
        self.viewport().setCursor(Qt.CursorShape.PointingHandCursor)
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setMovement(QListView.Movement.Static)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMouseTracking(True)
        self._painter = _Painter(self, shape)
        self.setItemDelegate(self._painter)
        self.itemClicked.connect(lambda item: self.chosen.emit(self.row(item)))

    def put(self, tiles: Sequence[Tile]) -> None:
        """Show tiles."""
        self.clear()
        for tile in tiles:
            item = QListWidgetItem(tile.title)
            item.setToolTip(tile.about)
            item.setData(Qt.ItemDataRole.AccessibleDescriptionRole, tile.about)
            item.setData(Qt.ItemDataRole.UserRole, tile.picture)
            self.addItem(item)
        self._lay_out()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._lay_out()

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        if event.reason() in _BY_KEY:  # else the page would scroll away under a pressed button
            self.setCurrentRow(max(self.currentRow(), 0))
            self.come_to.emit(self.visualItemRect(self.currentItem()))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in _KEYS:
            self.chosen.emit(self.currentRow())
        elif event.key() == Qt.Key.Key_Escape:
            event.ignore()
        else:
            super().keyPressEvent(event)
            self.come_to.emit(self.visualItemRect(self.currentItem()))

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()

    def _lay_out(self) -> None:
        columns = max(self.width() // self._shape.width, 1)
        wide = (self.width() - 1) // columns  # Qt lets none fill the line to its end
        indexes = (self.model().index(row, 0) for row in range(self.count()))
        words = [self._painter.words(index, wide - _GAP).size().height() for index in indexes]
        texts = math.ceil(max(words, default=0.0))
        high = round(self._shape.picture * (wide - _GAP)) + texts + _GAP
        self.setGridSize(QSize(wide, high))
        self.setFixedHeight(-(-self.count() // columns) * high)


class _Painter(QStyledItemDelegate):
    def __init__(self, view: Tiles, shape: Shape) -> None:
        super().__init__(view)
        self._view, self._shape = view, shape
        self._fitted: dict[Callable[[], QImage], QImage] = {}

    def sizeHint(self, option: QStyleOptionViewItem, index: _Index) -> QSize:
        return self._view.gridSize()

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: _Index) -> None:
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        palette = self._view.palette()
        here = QRect(option.rect.topLeft(), self._view.gridSize()).adjusted(0, 0, -_GAP, -_GAP)
        outline = QPainterPath()
        outline.addRoundedRect(here, _ROUND, _ROUND)
        over = bool(option.state & QStyle.StateFlag.State_MouseOver)
        painter.fillPath(outline, palette.midlight() if over else palette.base())
        painter.setClipPath(outline)
        above = QRect(
            here.topLeft(), QSize(here.width(), round(self._shape.picture * here.width()))
        )
        painter.fillRect(above, Qt.GlobalColor.black)
        picture = self._picture(index.data(Qt.ItemDataRole.UserRole), above.size())
        place = QRectF(above)
        place.setSize(picture.deviceIndependentSize())
        place.moveCenter(QRectF(above).center())
        painter.drawImage(place, picture)
        painter.translate(above.bottomLeft())
        document = self.words(index, here.width())
        document.drawContents(painter, QRectF(0, 0, *here.size().toTuple()))
        painter.restore()
        if option.state & QStyle.StateFlag.State_HasFocus:
            painter.setPen(QPen(palette.highlight(), 2))
            painter.drawPath(outline)

    def words(self, index: _Index, width: int) -> QTextDocument:
        """Title and sentence of a tile of a width in pixels."""
        palette = self._view.palette()
        text, about = palette.text().color().name(), theme.muted(palette).name()
        words = f"<b style='color:{text}'>{escape(index.data())}</b>"
        if self._shape.with_about:
            sentence = escape(index.data(Qt.ItemDataRole.ToolTipRole))
            words += f"<br><span style='color:{about}'>{sentence}</span>"
        document = QTextDocument(documentMargin=_INSIDE)
        document.setDefaultFont(self._view.font())
        document.setDefaultStyleSheet("b { font-weight: 600 }")
        document.setHtml(words)
        document.setTextWidth(width)
        return document

    def _picture(self, make: Callable[[], QImage], size: QSize) -> QImage:
        """A picture as large as fits, made once for each size."""
        ratio = self._view.devicePixelRatioF()
        held = self._fitted.get(make, QImage())
        if held.width() != size.width() * ratio and held.height() != size.height() * ratio:
            fitted = Qt.AspectRatioMode.KeepAspectRatio
            smooth = Qt.TransformationMode.SmoothTransformation
            held = make().scaled(size * ratio, fitted, smooth)
            held.setDevicePixelRatio(ratio)
            self._fitted[make] = held
        return held
