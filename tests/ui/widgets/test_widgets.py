"""Widgets: native windows and colours of the theme."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QPushButton

from ui.widgets import theme


def dark_palette():
    return QPalette(QColor("#222"), QColor("#222"))


def contrast(one, other):
    """Of WCAG 2: 1 for equal colours, 21 for black on white."""

    def luminance(colour):
        parts = [getattr(QColor(colour), part)() for part in ("redF", "greenF", "blueF")]
        linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    dark, bright = sorted([luminance(one), luminance(other)])
    return (bright + 0.05) / (dark + 0.05)


@pytest.mark.parametrize(
    ("scheme", "ground", "text"), [("light", "#efefef", "#000"), ("dark", "#323232", "#fff")]
)
def test_coloured_text_has_enough_contrast(scheme, ground, text):
    """On Fusion's own grounds; 4.5 is what WCAG asks of text."""
    assert contrast(theme.COLOURS["refused"][scheme], ground) >= 4.5
    for ground_of_message in (theme.COLOURS["warning"], theme.COLOURS["note"]):
        assert contrast(text, ground_of_message[scheme]) >= 7


@pytest.mark.parametrize(("scheme", "ink"), [("light", "#000"), ("dark", "#fff")])
def test_checked_buttons_have_contrast_and_differ_from_unchecked_ones(
    application, scheme, ink, qtbot
):
    theme.apply(application)
    if scheme == "dark":
        application.styleHints().colorSchemeChanged.emit(Qt.ColorScheme.Dark)
        application.setPalette(dark_palette())
        qtbot.waitUntil(lambda: theme.COLOURS["on"]["dark"] in application.styleSheet())
    assert contrast(ink, theme.COLOURS["on"][scheme]) >= 4.5
    button = QPushButton(checkable=True)
    qtbot.addWidget(button)
    button.resize(80, 30)
    off, on = (_middle(button, checked) for checked in (False, True))
    assert on.blue() - on.red() > 30 > off.blue() - off.red()


def _middle(button, checked):
    button.setChecked(checked)
    return button.grab().toImage().pixelColor(40, 15)
