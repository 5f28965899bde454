"""Pictures from the clipboard become the target, and the receiver takes their aspect."""

import pytest
from PySide6.QtCore import QStandardPaths
from PySide6.QtGui import QColor, QGuiApplication, QImage


@pytest.fixture(autouse=True)
def test_folders():
    QStandardPaths.setTestModeEnabled(True)
    yield
    QStandardPaths.setTestModeEnabled(False)
    QGuiApplication.clipboard().clear()


def wide_picture():
    image = QImage(60, 20, QImage.Format.Format_RGB32)
    image.fill(QColor("white"))
    image.setPixelColor(0, 0, QColor("black"))
    return image


def test_a_copied_picture_becomes_the_target_as_one_step(window):
    before = window.document.session
    QGuiApplication.clipboard().setImage(wide_picture())
    window.commands["paste_picture"].trigger()
    session = window.document.session
    assert session.scene.target.tone == "srgb" and session.picture is not None
    assert (session.target != before.target).any()
    window.commands["undo"].trigger()
    assert window.document.session is before


def test_the_screen_takes_the_aspect_of_the_picture(window):
    QGuiApplication.clipboard().setImage(wide_picture())
    window.commands["paste_picture"].trigger()
    before = window.document.session.scene.receiver
    window.commands["picture_aspect"].trigger()
    screen = window.document.session.scene.receiver
    assert screen.half_width == pytest.approx((before.half_width[0], before.half_width[0] / 3))
    assert screen.pixels == (before.pixels[0], round(before.pixels[0] / 3))
    window.commands["undo"].trigger()
    assert window.document.session.scene.receiver == before
