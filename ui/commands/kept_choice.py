"""Choices stored in the settings: theme, language, colours of light."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QSettings

from ui.commands.actions import Commands

SYSTEM = "system"
"""What counts where nothing was chosen: as the system has it."""


class KeptChoice:
    """A choice among commands, stored in the settings."""

    def __init__(self, key: str, choices: Mapping[str, str]) -> None:
        self._key, self._choices = key, choices

    def kept(self, settings: QSettings) -> str:
        """The stored choice; `SYSTEM` by default."""
        kept = str(settings.value(self._key))
        return kept if kept in self._choices.values() else SYSTEM

    def offer(
        self, settings: QSettings, commands: Commands, follow: Callable[[str], object]
    ) -> None:
        """Connect the commands to the choice; ``follow`` is called with each new choice."""
        choose = partial(self._choose, settings, follow)
        commands.connect({name: partial(choose, value) for name, value in self._choices.items()})
        self.show(settings, commands)

    def show(self, settings: QSettings, commands: Commands) -> None:
        """Check the command of the stored choice, which another window may have changed."""
        kept = self.kept(settings)
        chosen = next(name for name, value in self._choices.items() if value == kept)
        commands[chosen].setChecked(True)

    def _choose(self, settings: QSettings, follow: Callable[[str], object], value: str) -> None:
        settings.setValue(self._key, value)
        follow(value)
