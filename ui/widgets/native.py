"""Windows within the window."""

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QWidget


def make_native(widget: QWidget) -> None:
    """Give a widget a window of its own.

    The 3D scene needs one, and lies then above all that Qt paints in the window around it; so does
    whatever shall be seen over the scene. What lies beside it does not: menus over a native dock
    would count as belonging to no window.
    """
    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_DontCreateNativeWidgetSiblings)
    widget.setAttribute(Qt.WidgetAttribute.WA_DontCreateNativeAncestors)
    widget.setAttribute(Qt.WidgetAttribute.WA_NativeWindow)


class Uncovered(QObject):
    """Paints a window again where menus, dialogs and other windows have lain over it.

    Qt leaves that to a compositor in a window with OpenGL anywhere in it, also where OpenGL draws
    into a native window of its own. Without a compositor remains of other windows would stay.

    Parameters
    ----------
    window : QWidget
        A window; it owns this.
    """

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        window.winId()  # there is a handle from here on
        window.windowHandle().installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Paint what the display has lost; nothing is filtered out."""
        if isinstance(event, QPaintEvent):
            self._window.update(event.region())
        return False
