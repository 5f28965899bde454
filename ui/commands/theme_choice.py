"""Light, dark, or as the system is: chosen in the window, kept for the next start."""

from functools import partial

from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication

from ui.commands.actions import Commands
from ui.commands.table import THEMES
from ui.widgets import theme

_KEY = "window/theme"


def kept_theme(settings: QSettings) -> str:
    """The theme that was chosen last; "system" if none was."""
    kept = str(settings.value(_KEY))
    return kept if kept in THEMES.values() else "system"


def offer_themes(settings: QSettings, commands: Commands) -> None:
    """Have the commands of `THEMES` choose one.

    Parameters
    ----------
    settings : QSettings
        Where the choice is kept.
    commands : Commands
        The one that is on is checked.
    """
    commands.connect(
        {command: partial(_choose, settings, name) for command, name in THEMES.items()}
    )
    show_theme(settings, commands)


def show_theme(settings: QSettings, commands: Commands) -> None:
    """Check the theme that is on; another window may have chosen it."""
    commands[f"theme_{kept_theme(settings)}"].setChecked(True)


def _choose(settings: QSettings, name: str) -> None:
    settings.setValue(_KEY, name)
    application = QApplication.instance()
    if isinstance(application, QApplication):
        theme.choose(application, name)
