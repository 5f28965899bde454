"""The language of the window: chosen there, kept, and spoken from the next start on."""

from collections.abc import Callable

from ui.commands.kept_choice import SYSTEM, KeptChoice
from ui.commands.table import LANGUAGE_CHOICES
from ui.words import spoken, spoken_by_system, tr

LANGUAGE = KeptChoice("window/language", LANGUAGE_CHOICES)


def tell_of_language(tell: Callable[[str], object], code: str) -> None:
    """Report that a new language is used after a restart."""
    if (spoken_by_system() if code == SYSTEM else code) != spoken():
        tell(tr("The language changes at the next start."))
