"""Preferences are kept for a person, and what starts later follows them."""

import pytest

from ui import app
from ui.dialogs.preferences import (
    CHECK,
    CORES,
    LANGUAGE,
    PREFERENCES,
    START,
    TEXT_SIZE,
    THEME,
    PreferencesDialog,
    apply_look,
)
from ui.files.actions import RecentFiles
from ui.widgets import theme
from ui.words import set_language, tr


@pytest.fixture
def dialog(window):
    window.commands["preferences"].trigger()
    dialog = window.findChild(PreferencesDialog)
    yield dialog
    dialog.reject()


def choose(dialog, preference, value):
    chooser = dialog.choosers[preference.key]
    chooser.setCurrentIndex(chooser.findData(value))
    chooser.activated.emit(chooser.currentIndex())


def test_each_shows_what_is_kept(dialog, settings):
    assert {each.key: dialog.choosers[each.key].currentData() for each in PREFERENCES} == {
        each.key: each.usual for each in PREFERENCES
    }


def test_a_choice_is_kept_at_once(application, dialog, settings):
    for preference, value in (
        (LANGUAGE, "fr"),
        (TEXT_SIZE, "110"),
        (START, "last"),
        (CHECK, "none"),
        (CORES, "0"),
    ):
        assert preference.kept(settings) != value
        choose(dialog, preference, value)
        assert preference.kept(settings) == value


def test_a_theme_is_applied_at_once(application, dialog, settings):
    for name, dark in (("light", False), ("dark", True)):
        choose(dialog, THEME, name)
        assert theme.is_dark(application.palette()) is dark


def test_a_value_of_no_choice_is_the_usual_one(settings):
    settings.setValue(THEME.key, "purple")
    assert THEME.kept(settings) == "dark"


def test_the_start_applies_text_size_theme_and_language(application, settings):
    before = application.font()
    for preference, value in ((TEXT_SIZE, "125"), (THEME, "light"), (LANGUAGE, "de")):
        settings.setValue(preference.key, value)
    try:
        apply_look(settings)
        assert application.font().pointSizeF() == pytest.approx(1.25 * 9.75)
        assert not theme.is_dark(application.palette())
        assert tr("Preferences") == "Einstellungen"
    finally:
        application.setFont(before)
        set_language(application, "en")


def test_the_program_begins_with_the_last_design_that_is_still_there(settings, tmp_path):
    there, gone = tmp_path / "there.freeform", tmp_path / "gone.freeform"
    there.touch()
    for path in (there, gone):
        RecentFiles(settings).add(path)
    assert app._last_design(settings) is None
    settings.setValue(START.key, "last")
    assert app._last_design(settings) == there
    there.unlink()
    assert app._last_design(settings) is None
