"""The colours in which all views show light, kept for the next start."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSettings

from ui.commands.actions import Commands
from ui.commands.table import COLOURS

_KEY = "view/colours"


class ColourMap:
    """One choice for irradiance, target and the screen in three dimensions.

    Parameters
    ----------
    settings : QSettings
        Where the choice is kept.
    commands : Commands
        The one of `COLOURS` that is chosen is checked.
    show : Callable
        Shows light in colours of this name.
    """

    def __init__(
        self, settings: QSettings, commands: Commands, show: Callable[[str], object]
    ) -> None:
        self._settings, self._show = settings, show
        kept = f"colours_{settings.value(_KEY)}"
        if kept in COLOURS:
            commands[kept].setChecked(True)
            show(COLOURS[kept])

    def slots(self) -> dict[str, Callable[[], object]]:
        """What commands do here."""
        return {command: partial(self.choose, name) for command, name in COLOURS.items()}

    def choose(self, name: str) -> None:
        """Show light in other colours, from now on."""
        self._settings.setValue(_KEY, name)
        self._show(name)
