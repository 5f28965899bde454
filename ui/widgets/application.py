"""The Qt application."""

from PySide6.QtWidgets import QApplication


def application() -> QApplication:
    """Return the application; raise RuntimeError if there is none yet."""
    found = QApplication.instance()
    if not isinstance(found, QApplication):
        raise RuntimeError("make the application before its widgets")
    return found
