"""Contrast of texts, and rings around what has the keyboard, by WCAG 2.2."""

import itertools
import re

import pytest
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QApplication

import resources
from ui.views.image_overlays import _BACKING
from ui.widgets import theme

ROLES = QPalette.ColorRole
GROUNDS = ROLES.Window, ROLES.Base, ROLES.Button, ROLES.ToolTipBase, ROLES.AlternateBase


@pytest.fixture(params=["dark", "light"])
def scheme(request):
    return request.param


@pytest.fixture
def palette(scheme):
    return theme._palette(scheme)


def luminance(colour):
    red, green, blue, _ = colour.getRgbF()
    linear = [
        v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in (red, green, blue)
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    assert QColor(one).alpha() == QColor(other).alpha() == 255
    low, high = sorted(luminance(QColor(each)) for each in (one, other))
    return (high + 0.05) / (low + 0.05)


def test_texts_are_readable_on_every_ground(palette, scheme):
    grounds = [palette.color(role) for role in GROUNDS]
    own = [
        theme.COLOURS["raised"],
        theme.COLOURS["note"],
        theme.COLOURS["warning"],
        theme.COLOURS["on"],
    ]
    text = palette.color(ROLES.Text)
    for ground in (*grounds, palette.color(ROLES.Midlight), *(each[scheme] for each in own)):
        assert contrast(text, ground) >= 4.5
    disabled = palette.color(QPalette.ColorGroup.Disabled, ROLES.WindowText)
    quiet = [palette.color(ROLES.PlaceholderText), theme.COLOURS["muted"][scheme], disabled]
    for colour, ground in itertools.product(
        [
            *quiet,
            theme.COLOURS["refused"][scheme],
            theme.COLOURS["link"][scheme],
            palette.color(ROLES.LinkVisited),
        ],
        grounds,
    ):
        assert contrast(colour, ground) >= 4.5, (QColor(colour).name(), ground.name())
    assert contrast(palette.color(ROLES.HighlightedText), palette.color(ROLES.Highlight)) >= 4.5


def test_texts_over_images_are_readable_on_black_and_white(palette):
    part = _BACKING / 255
    for image in (0.0, 1.0):
        ground = [
            part * own + (1 - part) * image for own in palette.color(ROLES.Window).getRgbF()[:3]
        ]
        assert contrast(palette.color(ROLES.WindowText), QColor.fromRgbF(*ground)) >= 4.5


def test_rings_and_marks_stand_out(palette, scheme):
    for ground in (palette.color(ROLES.Window), palette.color(ROLES.Base)):
        assert contrast(theme.COLOURS["link"][scheme], ground) >= 3
        assert contrast(theme._HIGHLIGHT, ground) >= 3
        for mark in resources.path("icons").glob("mark-*.svg"):
            (colour,) = re.findall('fill="(#.*?)"', mark.read_text())
            assert contrast(colour, ground) >= 3


def test_a_tool_button_with_the_keyboard_has_a_ring(scheme, qtbot):
    application = QApplication.instance()
    theme.choose(application, scheme)
    assert f"border: 1px solid {theme.COLOURS['link'][scheme]}" in application.styleSheet()
    theme.choose(application, "system")
