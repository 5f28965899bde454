"""Choices stored in the settings: theme, language, colours of light."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication

from ui.commands.actions import Commands
from ui.commands.table import COLOURS, LANGUAGE_CHOICES, THEMES
from ui.widgets import theme
from ui.words import current_language, system_language, tr

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
        """Check the command of the stored choice, which may come from another window."""
        kept = self.kept(settings)
        chosen = next(name for name, value in self._choices.items() if value == kept)
        commands[chosen].setChecked(True)

    def _choose(self, settings: QSettings, follow: Callable[[str], object], value: str) -> None:
        settings.setValue(self._key, value)
        follow(value)


LANGUAGE = KeptChoice("window/language", LANGUAGE_CHOICES)


def tell_of_language(tell: Callable[[str], object], code: str) -> None:
    """Report that a new language is used after a restart."""
    if (system_language() if code == SYSTEM else code) != current_language():
        tell(tr("The language changes at the next start."))


THEME = KeptChoice("window/theme", THEMES)


def choose_theme(name: str) -> None:
    """Apply a theme to all windows."""
    application = QApplication.instance()
    if isinstance(application, QApplication):
        theme.choose(application, name)


_COLOURS_KEY = "view/colours"


def keep_colours(settings: QSettings, commands: Commands) -> None:
    """Restore the stored colours of light, and store choices of the user, not those of a design."""
    kept = f"colours_{settings.value(_COLOURS_KEY)}"
    if kept in COLOURS:
        commands[kept].setChecked(True)
    for command, name in COLOURS.items():
        commands[command].triggered.connect(
            lambda _, name=name: settings.setValue(_COLOURS_KEY, name)
        )
