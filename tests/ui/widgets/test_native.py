"""Native windows within the window: menus over what lies beside them, and what uncovers them."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget


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
