"""Widgets: native windows and colours of the theme."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QPushButton, QWidget

from ui.widgets import theme


@pytest.fixture
def built(display, window, qtbot):
    """A window with its views, and a 3D scene that has been drawn."""
    window.build()
    window.messages.clear()
    qtbot.waitUntil(lambda: window.loaded.views.scene.isVisible())
    qtbot.wait(200)  # until all is painted
    return window


def seen(window):
    """What the display shows of the window, without the 3D scene."""
    picture = window.screen().grabWindow(window.winId()).toImage()
    scene = window.loaded.views.scene
    corner = scene.mapTo(window, scene.rect().topLeft())
    return picture, [
        # The frame around the scene, and the gaps between docks beside it.
        (corner.x() - 1, corner.y() + 5),
        (corner.x() - 4, corner.y() + 5),
        (corner.x() + scene.width(), corner.y() + 5),
        (corner.x() + 5, corner.y() - 1),
        (corner.x() + 5, corner.y() + scene.height()),
    ]


def test_area_uncovered_by_another_window_is_painted_again(built, qtbot):
    before, places = seen(built)
    cover = QWidget(None, Qt.WindowType.FramelessWindowHint | Qt.WindowType.ToolTip)
    qtbot.addWidget(cover)
    cover.setStyleSheet("background: #ff0000")
    cover.setGeometry(built.frameGeometry())
    with qtbot.waitExposed(cover):
        cover.show()
    qtbot.waitUntil(lambda: seen(built)[0].pixelColor(*places[0]).name() == "#ff0000")
    cover.close()

    def as_before():
        now, _ = seen(built)
        assert [now.pixel(*place) for place in places] == [before.pixel(*at) for at in places]

    qtbot.waitUntil(as_before)


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
