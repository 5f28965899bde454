"""The image panel: one view of light or surface at a time, or two with a handle between them."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import pairwise

from PySide6.QtCore import QPoint, QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QKeyEvent, QMouseEvent, QRegion, QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QMenu,
    QStyle,
    QToolBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.commands.panes import PANES
from ui.widgets.controls import filled, name_extension
from ui.words import tr

_HANDLE = 7  # pixels, of the handle between two views
_PINNED = "pinned"
_STEP = 0.05  # of the width, for an arrow key
_OVER = 8, 8, 8, 40  # pixels around what lies over the views: their controls are free
_FRAME = 2  # pixels around the panel, highlighted when it has the keyboard


class ImagePanel(QFrame):
    """Views of one design in the same place, chosen by buttons above them.

    `over`: what lies over the views, such as messages.
    """

    chosen = Signal(str)

    def __init__(self, over: QWidget) -> None:
        super().__init__()
        self.setObjectName("centre")  # for the style sheet
        self._views = _Swipe(self)  # first: the keyboard comes to them before the buttons
        self._modes = self._one_of_views(self.choose)
        self._bar = _Modes(list(self._modes.values()))
        self._compare = QToolButton(self)
        self._compare.setToolTip(
            tr("Show a second image; drag the handle between them, or press arrows on it")
        )
        self._compare.setCheckable(True)
        self._compare.setAutoRaise(True)
        self._compare.setPopupMode(QToolButton.ToolButtonPopupMode.MenuButtonPopup)
        self._seconds = self._one_of_views(self.compare_with)
        menu = QMenu(self)
        menu.addActions(list(self._seconds.values()))
        self._compare.setMenu(menu)
        self._compare.toggled.connect(self._show)
        name_extension(self._bar, tr("More images"))
        self.name, self._second = "irradiance", "target"
        self._offer_pinned(False)
        box = QVBoxLayout()
        box.setSpacing(0)
        box.addLayout(filled(QHBoxLayout(), (self._bar, 1), self._compare, margins=0, spacing=0))
        box.addWidget(self._views, 1)
        # One over the other: a message that comes or goes leaves the picture as it is.
        layout = QGridLayout(self)
        layout.setContentsMargins(*4 * [_FRAME])
        layout.addLayout(box, 0, 0)
        corner = filled(QVBoxLayout(), over, margins=_OVER)
        layout.addLayout(corner, 0, 0, Qt.AlignmentFlag.AlignBottom | Qt.AlignmentFlag.AlignRight)
        self._show()

    @property
    def compared(self) -> str:
        """Name of the view to the right of the handle; empty if there is one view alone."""
        return self._second if self._compare.isChecked() else ""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all views."""
        return tuple(self._modes)

    def put(self, views: Mapping[str, QWidget]) -> None:
        """Show views in place of the words that stand for them while they are loaded."""
        self._views.put(views)
        for before, after in pairwise([self._compare, *views.values()]):
            QWidget.setTabOrder(before, after)
        self._show()

    def choose(self, name: str) -> None:
        """Show a view; the one to the right of the handle where it is that already."""
        if name == self.compared:
            return
        self.name = name
        self._show()
        self.chosen.emit(name)

    def compare_with(self, name: str) -> None:
        """Show a second view to the right of the first, with a handle between."""
        if name == self.name:
            self.name = self._second
        self._second = name
        self._compare.setChecked(True)
        self._show()

    def follow_pin(self, pinned: bool) -> None:
        """Compare with the image that is pinned; show none that is no longer pinned."""
        self._offer_pinned(pinned)
        if pinned:
            self.compare_with(_PINNED)
            return
        if self.compared == _PINNED:
            self._compare.setChecked(False)
        if self._second == _PINNED:
            self._second = "target"
        if self.name == _PINNED:
            self.choose("irradiance")

    def _offer_pinned(self, offered: bool) -> None:
        for actions in (self._modes, self._seconds):
            actions[_PINNED].setVisible(offered)

    def rename(self, name: str, title: str) -> None:
        """Give the buttons of a view another title."""
        for actions in (self._modes, self._seconds):
            actions[name].setText(title)
        self._show()

    def _one_of_views(self, choose: Callable[[str], None]) -> dict[str, QAction]:
        """Actions by the names of the views, of which one is checked."""
        group = QActionGroup(self)
        actions = {n: group.addAction(tr(pane.title)) for n, pane in PANES.items() if pane.image}
        for name, action in actions.items():
            action.setCheckable(True)
            action.triggered.connect(partial(choose, name))
        return actions

    def _show(self) -> None:
        if self._second == self.name:
            self._second = next(name for name in self._modes if name != self.name)
        self._modes[self.name].setChecked(True)
        self._bar.keep_in_sight()
        second = self._seconds[self._second]
        second.setChecked(True)
        words = tr("Compare: {image}").format(image=second.text()) if self.compared else ""
        self._compare.setText(words or tr("Compare"))
        self._views.show_views(self.name, self.compared)


class _Modes(QToolBar):
    """One button for each view; where space is short, that of the shown view is among the first."""

    def __init__(self, modes: list[QAction]) -> None:
        super().__init__(tr("Image"))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        self._modes = modes
        self.addActions(modes)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._arrange()

    def keep_in_sight(self) -> None:
        """Show the button of the chosen view; buttons stay where they are if it is there."""
        if any(each.isChecked() and self.widgetForAction(each).isHidden() for each in self._modes):
            self._arrange()

    def _arrange(self) -> None:
        order = self._order()
        if self.actions() != order:
            self.addActions(order)  # moves those that are there

    def _order(self) -> list[QAction]:
        """All in their order, but the chosen one before those that there is no space for.

        By widths alone: to lay the bar out within its own resizing would not end.
        """
        kept = [each for each in self._modes if each.isVisible()]
        if self._needed(kept) > self.width():
            more = self.style().pixelMetric(QStyle.PixelMetric.PM_ToolBarExtensionExtent)
            while len(kept) > 1 and self._needed(kept) + more > self.width():
                kept.remove([each for each in kept if not each.isChecked()][-1])
        return [*kept, *(each for each in self._modes if each not in kept)]

    def _needed(self, modes: Sequence[QAction]) -> int:
        """Pixels that buttons take with what is around them."""
        metric, metrics = self.style().pixelMetric, QStyle.PixelMetric
        around = metric(metrics.PM_ToolBarItemMargin) + metric(metrics.PM_ToolBarFrameWidth)
        gap = metric(metrics.PM_ToolBarItemSpacing)
        widths = [self.widgetForAction(each).sizeHint().width() + gap for each in modes]
        return 2 * around + sum(widths)


class _Swipe(QWidget):
    """Views of the same size in the same place; the second is seen to the right of a handle."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        loading = QLabel(tr("Loading…"), alignment=Qt.AlignmentFlag.AlignCenter, parent=self)
        self._views: dict[str, QWidget] = {}
        self.first: QWidget = loading
        self._second: QWidget | None = None
        self._loading = loading
        self._handle = _Handle(self)
        self._handle.moved.connect(self._move)
        self._part = 0.5

    def put(self, views: Mapping[str, QWidget]) -> None:
        self._views = dict(views)
        for view in self._views.values():
            view.hide()
            view.setParent(self)
        self._loading.hide()

    def show_views(self, first: str, second: str) -> None:
        self.first = self._views.get(first, self._loading)
        self._second = self._views.get(second) if second else None
        for view in self._views.values():
            view.clearMask()
            if view not in (self.first, self._second):
                view.hide()
        self._place()
        self.first.show()
        if self._second is not None:
            self._second.show()
            self._second.raise_()
            self._handle.raise_()
        self._handle.setVisible(self._second is not None)
        self.updateGeometry()

    def minimumSizeHint(self) -> QSize:
        shown = (self.first, self._second or self.first)
        return shown[0].minimumSizeHint().expandedTo(shown[1].minimumSizeHint())

    def sizeHint(self) -> QSize:
        return self.first.sizeHint()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place()

    def _move(self, part: float) -> None:
        self._part = min(max(part, 0.0), 1.0)
        self._place()

    def _place(self) -> None:
        self.first.setGeometry(self.rect())
        if self._second is None:
            return
        left = round(self._part * self.width())
        self._second.setGeometry(self.rect())
        self._second.setMask(QRegion(left, 0, max(self.width() - left, 1), max(self.height(), 1)))
        self._handle.setGeometry(left - _HANDLE // 2, 0, _HANDLE, self.height())


class _Handle(QFrame):
    """A bar that is dragged across its parent, or moved by the arrow keys."""

    moved = Signal(float)  # part of the parent's width to the left of it

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._across = parent
        self.setObjectName("handle")  # for the style sheet
        self.setCursor(Qt.CursorShape.SplitHCursor)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("Handle between two images"))
        self.hide()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._go(self.mapToParent(event.position().toPoint()))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        by = {Qt.Key.Key_Left: -_STEP, Qt.Key.Key_Right: _STEP}.get(Qt.Key(event.key()))
        if by is None:
            super().keyPressEvent(event)
        else:
            self._go(self.geometry().center() + QPoint(round(by * self._across.width()), 0))

    def _go(self, place: QPoint) -> None:
        self.moved.emit(place.x() / max(self._across.width(), 1))
