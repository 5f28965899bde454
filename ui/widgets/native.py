"""Windows within the window."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget


def make_native(widget: QWidget) -> None:
    """Give a widget a window of its own.

    The 3D scene needs one, and lies then above all that Qt paints in the window around it; so does
    whatever shall be seen over the scene.
    """
    widget.setAttribute(Qt.WidgetAttribute.WA_DontCreateNativeAncestors)
    widget.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)
