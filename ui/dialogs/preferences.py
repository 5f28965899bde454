"""Preferences of a person, kept in the settings, and their dialog."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QFormLayout, QWidget

from ui.widgets import theme
from ui.widgets.controls import Chooser, named
from ui.widgets.dialog import Buttons, Dialog
from ui.widgets.labels import WrappedLabel
from ui.widgets.native import application
from ui.words import LANGUAGES, later, set_language, tr


@dataclass(frozen=True)
class Preference:
    """A kept choice; `choices` has titles by values, `usual` is the value of a new user."""

    key: str
    title: str
    tip: str
    choices: Mapping[str, str]
    usual: str

    def kept(self, settings: QSettings) -> str:
        kept = str(settings.value(self.key))
        return kept if kept in self.choices else self.usual


_SYSTEM = later({"system": "As the system"})

THEME = Preference(
    "window/theme",
    later("Theme"),
    later("Colours of all windows"),
    {**_SYSTEM, **later({"light": "Light", "dark": "Dark"})},
    "dark",
)
TEXT_SIZE = Preference(
    "window/text_size",
    later("Text size"),
    later("Size of the text in all windows"),
    {str(percent): f"{percent} %" for percent in (90, 100, 110, 125)},
    "100",
)
LANGUAGE = Preference(
    "window/language",
    later("Language"),
    later("Language of the window; the command line is in English"),
    {**_SYSTEM, **LANGUAGES},
    "system",
)
START = Preference(
    "window/start",
    later("At the start"),
    later("What the window shows when the program starts without a file"),
    later({"page": "Start page", "last": "Last design"}),
    "page",
)
CHECK = Preference(
    "run/check",
    later("Finished lenses"),
    later("Whether an independent ray trace checks what a run or live update has finished"),
    later({"check": "Check the result", "none": "No check"}),
    "check",
)
CORES = Preference(
    "run/free_cores",
    later("Free cores"),
    later("Cores that runs leave to the window and to other programs"),
    {str(count): str(count) for count in range(4)},
    "1",
)
PREFERENCES = (THEME, TEXT_SIZE, LANGUAGE, START, CHECK, CORES)


def apply_look(settings: QSettings) -> None:
    """Apply text size, theme and language at the start of the program."""
    theme.set_text_size(application(), int(TEXT_SIZE.kept(settings)) / 100)
    theme.choose(application(), THEME.kept(settings))
    set_language(application(), LANGUAGE.kept(settings))


_COLUMNS = 20  # characters of the longest choice


class PreferencesDialog(Dialog):
    """A choice for each preference, kept at once."""

    def __init__(self, settings: QSettings, window: QWidget) -> None:
        super().__init__(tr("Preferences"), window, Buttons.Close)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._settings = settings
        self.choosers: dict[str, Chooser] = {}
        form = QFormLayout(self)
        for preference in PREFERENCES:
            chooser = Chooser({value: tr(title) for value, title in preference.choices.items()})
            named(chooser, tr(preference.title), tr(preference.tip))
            chooser.setMinimumContentsLength(_COLUMNS)
            chooser.choose(preference.kept(settings))
            chooser.activated.connect(partial(self._keep, preference))
            self.choosers[preference.key] = chooser
            form.addRow(tr(preference.title), chooser)
        form.addRow(WrappedLabel(tr("Text size, language and cores change at the next start.")))
        form.addRow(self.buttons)

    def _keep(self, preference: Preference, _: int) -> None:
        self._settings.setValue(preference.key, self.choosers[preference.key].currentData())
        theme.choose(application(), THEME.kept(self._settings))
