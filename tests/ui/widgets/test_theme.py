"""Light and dark, also when the system changes its mind while the window is open."""

import re

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QCheckBox, QPushButton, QTableWidget, QTableWidgetItem

from ui.widgets import theme


def dark_palette():
    return QPalette(QColor("#222"), QColor("#222"))


def test_colours_follow_the_palette_which_comes_after_the_signal(application, qtbot):
    theme.apply(application)
    light = application.styleSheet()
    application.styleHints().colorSchemeChanged.emit(Qt.ColorScheme.Dark)
    application.setPalette(dark_palette())
    qtbot.waitUntil(lambda: application.styleSheet() != light)
    assert theme._REFUSED["light"] in light
    assert theme._REFUSED["dark"] in application.styleSheet()


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
    assert contrast(theme._REFUSED[scheme], ground) >= 4.5
    for ground_of_message in (theme._WARNING, theme._NOTE):
        assert contrast(text, ground_of_message[scheme]) >= 7


@pytest.mark.parametrize(("scheme", "ink"), [("light", "#000"), ("dark", "#fff")])
def test_checked_buttons_have_contrast_and_differ_from_unchecked_ones(
    application, scheme, ink, qtbot
):
    theme.apply(application)
    if scheme == "dark":
        application.styleHints().colorSchemeChanged.emit(Qt.ColorScheme.Dark)
        application.setPalette(dark_palette())
        qtbot.waitUntil(lambda: theme._ON["dark"] in application.styleSheet())
    assert contrast(ink, theme._ON[scheme]) >= 4.5
    button = QPushButton(checkable=True)
    qtbot.addWidget(button)
    button.resize(80, 30)
    off, on = (_middle(button, checked) for checked in (False, True))
    assert on.blue() - on.red() > 30 > off.blue() - off.red()


def _middle(button, checked):
    button.setChecked(checked)
    return button.grab().toImage().pixelColor(40, 15)


def _most_contrast(widget, area, ground):
    """Of a pixel of a part of a widget with the colour that is behind it."""
    image = widget.grab(area).toImage()
    pixels = ((x, y) for x in range(image.width()) for y in range(image.height()))
    return max(contrast(image.pixelColor(*pixel), ground) for pixel in pixels)


def test_boxes_that_are_not_ticked_are_seen_in_the_dark(application, qtbot):
    """3 is what WCAG asks of what is not text."""
    theme.apply(application)
    application.setPalette(theme._palette("dark"))
    theme._colour(application)
    box, table = QCheckBox(), QTableWidget(1, 1, showGrid=False)
    for widget in (box, table):
        qtbot.addWidget(widget)
    item = QTableWidgetItem()
    item.setCheckState(Qt.CheckState.Unchecked)
    table.setItem(0, 0, item)
    window, base = (theme._GROUNDS["dark"][k] for k in (0, 1))
    assert _most_contrast(box, box.rect(), window) >= 3
    cells = table.viewport()
    assert _most_contrast(cells, table.visualItemRect(item).adjusted(1, 1, -1, -1), base) >= 3
    box.setChecked(True)
    assert box.sizeHint() == QCheckBox().sizeHint()  # a tick moves nothing


@pytest.mark.parametrize("name", ["dock-close", "dock-float"])
@pytest.mark.parametrize("ground", ["#efefef", "#323232"])
def test_buttons_of_docks_are_seen_on_both_grounds(name, ground):
    """3 is what WCAG asks of what is not text."""
    (ink,) = re.findall('stroke="(#[0-9a-f]{6})"', theme._icon_file(name).read_text())
    assert contrast(ink, ground) >= 3
