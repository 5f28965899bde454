"""Photographs every dock and dialog: ``python -m resources.contact_sheets FOLDER``.

One sheet for each of three sizes of the window, light and dark, to be looked at after changes of
the window. Needs a screen of 2560 × 1440 pixels, real or virtual.
"""

import sys
from collections.abc import Iterator
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPixmap

from resources.make_screenshot import begin, design, dialog_of, open_window, settle
from ui.commands.table import PANES
from ui.main_window import MainWindow
from ui.tour import STOPS, Bubble

_SIZES = (QSize(1280, 800), QSize(1600, 1000), QSize(2560, 1440))
_SCHEMES = {"light": Qt.ColorScheme.Light, "dark": Qt.ColorScheme.Dark}
_DIALOGS = ("gallery", "palette", "shortcuts")
_GAP = 12
_ITERATIONS = 10  # enough for curves


def make(folder: Path) -> None:
    """Write ``SCHEME-WIDTH.png`` for each."""
    application = begin()
    window = open_window("flame", _SIZES[0])
    scene = window.document.session.scene
    run = scene.run.model_copy(update={"iterations": _ITERATIONS})
    window.document.edit(scene.model_copy(update={"run": run}), "iterations", "")
    design(window)
    for name, scheme in _SCHEMES.items():
        application.styleHints().setColorScheme(scheme)
        for size in _SIZES:
            window.commands["reset_layout"].trigger()
            window.resize(size)
            settle()
            pictures = [window.grab(), *_panes(window), *_dialogs(window), *_tour(window)]
            _sheet(pictures, size.width()).save(str(folder / f"{name}-{size.width()}.png"))
    window.discard_and_close()


def _panes(window: MainWindow) -> Iterator[QPixmap]:
    for name in PANES:
        window.commands[f"go_{name}"].trigger()
        settle(1000)
        if name != "scene":
            yield window.workspace.docks[name].grab()
    window.messages.warn("A message with something to do.", ("Do it", window.messages.clear))
    settle()
    yield window.grab()  # with all of them
    window.messages.clear()
    window.commands["reset_layout"].trigger()


def _dialogs(window: MainWindow) -> Iterator[QPixmap]:
    for command in _DIALOGS:
        yield dialog_of(window, command)


def _tour(window: MainWindow) -> Iterator[QPixmap]:
    window.commands["tour"].trigger()
    bubble = window.findChild(Bubble)
    for _ in STOPS:
        settle(300)
        yield bubble.grab()
        bubble.on.click()


def _sheet(pictures: list[QPixmap], width: int) -> QPixmap:
    """Pictures in rows, from left to right."""
    places, x, y, row = [], 0, 0, 0
    for picture in pictures:
        if x and x + picture.width() > width:
            x, y, row = 0, y + row + _GAP, 0
        places.append((x, y))
        x, row = x + picture.width() + _GAP, max(row, picture.height())
    sheet = QPixmap(width, y + row)
    sheet.fill(QColor("#808080"))
    painter = QPainter(sheet)
    for place, picture in zip(places, pictures, strict=True):
        painter.drawPixmap(*place, picture)
    painter.end()
    return sheet


if __name__ == "__main__":
    make(Path(sys.argv[1]))
