"""The application that all widgets belong to."""

from PySide6.QtWidgets import QApplication


def application() -> QApplication:
    """The one application.

    Raises
    ------
    RuntimeError
        If there is none yet; nothing of a window can be made before it.
    """
    found = QApplication.instance()
    if not isinstance(found, QApplication):
        raise RuntimeError("make the application before its widgets")
    return found
