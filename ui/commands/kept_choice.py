"""A choice among commands that outlives the window: which theme, which language."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QSettings

from ui.commands.actions import Commands

SYSTEM = "system"
"""What counts where nothing was chosen: as the system has it."""


class KeptChoice:
    """What was chosen, in the settings, and the commands that choose it.

    Parameters
    ----------
    key : str
        Of the settings.
    choices : mapping of str to str
        What each command chooses; `SYSTEM` is one of them.
    """

    def __init__(self, key: str, choices: Mapping[str, str]) -> None:
        self._key, self._choices = key, choices

    def kept(self, settings: QSettings) -> str:
        """What was chosen last; `SYSTEM` if nothing was."""
        kept = str(settings.value(self._key))
        return kept if kept in self._choices.values() else SYSTEM

    def offer(
        self, settings: QSettings, commands: Commands, follow: Callable[[str], object]
    ) -> None:
        """Have the commands choose.

        Parameters
        ----------
        settings : QSettings
            Where the choice is kept.
        commands : Commands
            The one that is chosen is checked.
        follow : callable
            Gets what is chosen.
        """
        choose = partial(self._choose, settings, follow)
        commands.connect({name: partial(choose, value) for name, value in self._choices.items()})
        self.show(settings, commands)

    def show(self, settings: QSettings, commands: Commands) -> None:
        """Check the command that was chosen; another window may have done so."""
        kept = self.kept(settings)
        chosen = next(name for name, value in self._choices.items() if value == kept)
        commands[chosen].setChecked(True)

    def _choose(self, settings: QSettings, follow: Callable[[str], object], value: str) -> None:
        settings.setValue(self._key, value)
        follow(value)
