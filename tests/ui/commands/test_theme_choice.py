"""Light and dark chosen in the window, for all windows and for the next start."""

import pytest
from PySide6.QtGui import QPalette

from ui.commands.theme_choice import THEME
from ui.widgets import theme


@pytest.fixture
def coloured(application):
    theme.apply(application)
    yield application
    theme.choose(application, "system")


@pytest.mark.parametrize(("name", "dark"), [("dark", True), ("light", False)])
def test_a_chosen_theme_colours_the_windows_and_is_kept(coloured, window, settings, name, dark):
    window.commands[f"theme_{name}"].trigger()
    assert theme.is_dark(coloured.palette()) is dark
    assert theme._REFUSED[name] in coloured.styleSheet()
    assert THEME.kept(settings) == name


def test_the_theme_of_the_system_comes_back(coloured, window, settings):
    ground = coloured.palette().color(QPalette.ColorRole.Window)
    window.commands["theme_dark"].trigger()
    assert coloured.palette().color(QPalette.ColorRole.Window) != ground
    window.commands["theme_system"].trigger()
    assert coloured.palette().color(QPalette.ColorRole.Window) == ground
    assert THEME.kept(settings) == "system"
