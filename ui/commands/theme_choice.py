"""Light, dark, or as the system is: chosen in the window, kept for the next start."""

from PySide6.QtWidgets import QApplication

from ui.commands.kept_choice import KeptChoice
from ui.commands.table import THEMES
from ui.widgets import theme

THEME = KeptChoice("window/theme", THEMES)


def choose_theme(name: str) -> None:
    """Apply a theme to all windows."""
    application = QApplication.instance()
    if isinstance(application, QApplication):
        theme.choose(application, name)
