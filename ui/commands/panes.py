"""Panes of the window (title, key, initial position), and moving the focus between them."""

from dataclasses import dataclass

from PySide6.QtCore import Qt


@dataclass(frozen=True)
class Pane:
    """A dock, or the centre."""

    title: str
    area: Qt.DockWidgetArea | None
    key: str = ""
    behind: str = ""
    right_of: str = ""
    shown: bool = True


_LEFT = Qt.DockWidgetArea.LeftDockWidgetArea
_RIGHT = Qt.DockWidgetArea.RightDockWidgetArea
_TOP = Qt.DockWidgetArea.TopDockWidgetArea

PANES = {
    "design": Pane("Design", _LEFT, "1"),
    "scene": Pane("3D scene", None, "2"),
    "irradiance": Pane("Irradiance", _TOP, "3"),
    "target": Pane("Target", _TOP, right_of="irradiance"),
    "error": Pane("Irradiance − target", _TOP, "4", right_of="target"),
    "derivative": Pane("Derivative", _TOP, behind="error", shown=False),
    "surface": Pane("Surface", _TOP, "5", behind="error", shown=False),
    "manufacture": Pane("Manufacture", _TOP, behind="error", shown=False),
    "tolerances": Pane("Tolerances", _TOP, behind="error", shown=False),
    "focus": Pane("Through focus", _TOP, behind="error", shown=False),
    "photo": Pane("Predicted photo", _TOP, behind="error", shown=False),
    "check": Pane("Check", _TOP, behind="error", shown=False),
    "loss": Pane("Loss", _RIGHT, "6"),
    "section": Pane("Cross-section", _RIGHT, "7", behind="loss", shown=False),
    "light": Pane("Light account", _RIGHT, behind="loss"),
    "runs": Pane("Runs", _RIGHT, behind="loss"),
    "history": Pane("History", _LEFT, "8", behind="design", shown=False),
    "log": Pane("Log", _RIGHT, "9", behind="loss", shown=False),
}
"""By name, in the order in which menus list them and the focus goes.

What a dock holds is made where its libraries are loaded: see `Workspace.put_views`, which
refuses a table and widgets that do not agree.
"""
