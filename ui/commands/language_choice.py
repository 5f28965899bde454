"""The language of the window: chosen there, kept, and spoken from the next start on."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSettings

from ui.commands.actions import Commands
from ui.commands.table import LANGUAGE_CHOICES
from ui.words import spoken, spoken_by_system, tr

_KEY = "window/language"


def kept_language(settings: QSettings) -> str:
    """The language that was chosen last; "system" if none was."""
    kept = str(settings.value(_KEY))
    return kept if kept in LANGUAGE_CHOICES.values() else "system"


def offer_languages(settings: QSettings, commands: Commands, tell: Callable[[str], object]) -> None:
    """Have the commands of `LANGUAGE_CHOICES` choose one.

    Parameters
    ----------
    settings : QSettings
        Where the choice is kept.
    commands : Commands
        The one that is chosen is checked.
    tell : callable
        Gets a sentence where the choice counts only later.
    """
    commands.connect(
        {
            command: partial(_choose, settings, code, tell)
            for command, code in LANGUAGE_CHOICES.items()
        }
    )
    show_language(settings, commands)


def show_language(settings: QSettings, commands: Commands) -> None:
    """Check the language that is chosen; another window may have done so."""
    commands[f"language_{kept_language(settings)}"].setChecked(True)


def _choose(settings: QSettings, code: str, tell: Callable[[str], object]) -> None:
    settings.setValue(_KEY, code)
    if (spoken_by_system() if code == "system" else code) != spoken():
        tell(tr("The language changes at the next start."))
