"""Where forms and views stand in the window, before and after the views are there."""

from collections.abc import Mapping

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt, QTimer
from PySide6.QtGui import QUndoStack
from PySide6.QtWidgets import (
    QDockWidget,
    QGridLayout,
    QLabel,
    QMainWindow,
    QStackedWidget,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QUndoView,
    QWidget,
)

from ui.log_view import LogView
from ui.message_bar import MessageBar
from ui.panels.forms import Forms

_LEFT = Qt.DockWidgetArea.LeftDockWidgetArea
_RIGHT = Qt.DockWidgetArea.RightDockWidgetArea
_BOTTOM = Qt.DockWidgetArea.BottomDockWidgetArea

# Until they are asked for.
_HIDDEN = (
    "history",
    "target",
    "derivative",
    "surface",
    "focus",
    "check",
    "manufacture",
    "tolerances",
    "section",
    "log",
)

# Shares of the window for forms, images and what stands below the 3D scene.
_FORMS_SHARE = 0.25
_IMAGES_SHARE = 0.27
_BELOW_SHARE = 0.24


class Workspace:
    """Docks around the 3D scene; the views come later, because their libraries load slowly.

    Parameters
    ----------
    window : QMainWindow
        Gets docks and a central widget.
    forms : Forms
        Stands at the left.
    messages : MessageBar
        Lies over the 3D scene, at its top.
    steps : QUndoStack
        What was done, listed in a dock; a click goes back or forth to that step.
    log : LogView
        Stands behind the loss.
    """

    def __init__(
        self,
        window: QMainWindow,
        forms: Forms,
        messages: MessageBar,
        steps: QUndoStack,
        log: LogView,
    ) -> None:
        self._window = window
        self._stage = QStackedWidget()
        self._curtain = QLabel("Loading the 3D scene…", alignment=Qt.AlignmentFlag.AlignCenter)
        self._stage.addWidget(self._curtain)
        centre = QWidget()
        # One over the other: a message that comes or goes leaves the picture as it is.
        over = QGridLayout(centre)
        over.setContentsMargins(0, 0, 0, 0)
        over.addWidget(self._stage, 0, 0)
        over.addWidget(messages, 0, 0, Qt.AlignmentFlag.AlignTop)
        window.setCentralWidget(centre)
        window.setCorner(Qt.Corner.BottomLeftCorner, _LEFT)
        window.setCorner(Qt.Corner.BottomRightCorner, _RIGHT)
        self.docks = {
            "design": self._dock("design", "Design", _LEFT),
            "history": self._dock("history", "History", _LEFT),
            "irradiance": self._dock("irradiance", "Irradiance", _RIGHT),
            "target": self._dock("target", "Target", _RIGHT),
            "error": self._dock("error", "Irradiance − target", _RIGHT),
            "derivative": self._dock("derivative", "Derivative", _RIGHT),
            "surface": self._dock("surface", "Surface", _RIGHT),
            "manufacture": self._dock("manufacture", "Manufacture", _RIGHT),
            "tolerances": self._dock("tolerances", "Tolerances", _RIGHT),
            "focus": self._dock("focus", "Through focus", _RIGHT),
            "check": self._dock("check", "Check", _RIGHT),
            "loss": self._dock("loss", "Loss", _BOTTOM),
            "section": self._dock("section", "Cross-section", _BOTTOM),
            "log": self._dock("log", "Log", _BOTTOM),
            "light": self._dock("light", "Light account", _BOTTOM),
            "runs": self._dock("runs", "Runs", _BOTTOM),
        }
        self.docks["design"].setWidget(forms)
        self.history = QUndoView(steps)
        self.history.setEmptyLabel("As opened")
        self.history.setItemDelegate(_Capitalised(self.history))
        self.history.setToolTip("A click goes back or forth to that step")
        self.docks["history"].setWidget(self.history)
        self.docks["log"].setWidget(log)
        for name in self.docks.keys() - {"design", "history", "log"}:
            curtain = QLabel("Loading…", alignment=Qt.AlignmentFlag.AlignCenter)
            self.docks[name].setWidget(curtain)
        window.splitDockWidget(
            self.docks["irradiance"], self.docks["target"], Qt.Orientation.Horizontal
        )
        # Tabs of docks that are shown leave bars behind, which lie about until Qt deletes them.
        for name in (*_HIDDEN, "runs"):
            self.docks[name].hide()
        window.tabifyDockWidget(self.docks["design"], self.docks["history"])
        for name in ("derivative", "surface", "manufacture", "tolerances", "focus", "check"):
            window.tabifyDockWidget(self.docks["error"], self.docks[name])
        for name in ("section", "log"):
            window.tabifyDockWidget(self.docks["loss"], self.docks[name])
        window.tabifyDockWidget(self.docks["light"], self.docks["runs"])
        self.docks["runs"].show()
        self.docks["light"].raise_()
        # A dock that comes between others gets no more than it cannot do without.
        shown = self.docks["target"].toggleViewAction().toggled
        shown.connect(lambda shown: QTimer.singleShot(0, window, self._share) if shown else None)

    def arrange(self) -> None:
        """Share the window out among the docks."""
        docks, width, height = self.docks, self._window.width(), self._window.height()
        self._window.resizeDocks(
            [docks["design"], docks["irradiance"]],
            [int(_FORMS_SHARE * width), int(_IMAGES_SHARE * width)],
            Qt.Orientation.Horizontal,
        )
        self._window.resizeDocks(
            [docks["irradiance"], docks["error"]], [1, 1], Qt.Orientation.Vertical
        )
        self._window.resizeDocks(
            [docks["loss"]], [int(_BELOW_SHARE * height)], Qt.Orientation.Vertical
        )
        self._window.resizeDocks([docks["loss"], docks["light"]], [3, 2], Qt.Orientation.Horizontal)

    def raise_curtain(self, scene_view: QWidget, others: Mapping[str, QWidget]) -> None:
        """Put the views where the placeholders stand."""
        self._stage.addWidget(scene_view)
        self._stage.setCurrentWidget(scene_view)
        for name, view in others.items():
            placeholder = self.docks[name].widget()
            self.docks[name].setWidget(view)
            placeholder.deleteLater()
        self._curtain.setText("The 3D scene is hidden. View > 3D scene shows it again.")

    def show_dock(self, name: str) -> None:
        """Show a dock in front of those that share its place."""
        self.docks[name].show()
        self.docks[name].raise_()

    def show_scene_view(self, shown: bool) -> None:
        """Show the 3D scene, or nothing in its place (which costs nothing while a run goes on)."""
        self._stage.setCurrentIndex(1 if shown else 0)

    def _share(self) -> None:
        """Give both images of light as much room, where the target has hardly any."""
        images = [self.docks["irradiance"], self.docks["target"]]
        widths = [image.width() for image in images]
        if widths[1] < widths[0] / 2:
            half = sum(widths) // 2  # less would make both as narrow as they can be
            self._window.resizeDocks(images, [half, half], Qt.Orientation.Horizontal)

    def _dock(self, name: str, title: str, area: Qt.DockWidgetArea) -> QDockWidget:
        dock = QDockWidget(title, self._window)
        dock.setObjectName(name)
        self._window.addDockWidget(area, dock)
        # Qt shows a tab of the menu's choice behind the other.
        dock.toggleViewAction().triggered.connect(lambda shown: dock.raise_() if shown else None)
        return dock


class _Capitalised(QStyledItemDelegate):
    """Begins each line with a capital; the undo menu has the same texts amid a sentence."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        text = option.text
        option.text = text[:1].upper() + text[1:]
