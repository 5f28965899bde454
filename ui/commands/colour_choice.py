"""The colours in which all views show light, kept for the next start."""

from PySide6.QtCore import QSettings

from ui.commands.actions import Commands
from ui.commands.table import COLOURS

_KEY = "view/colours"


def keep_colours(settings: QSettings, commands: Commands) -> None:
    """Restore the stored colours of light, and store later choices of the user.

    Colours of a design are its own: they are shown, not stored.
    """
    kept = f"colours_{settings.value(_KEY)}"
    if kept in COLOURS:
        commands[kept].setChecked(True)
    for command, name in COLOURS.items():
        commands[command].triggered.connect(lambda _, name=name: settings.setValue(_KEY, name))
