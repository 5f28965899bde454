"""Photographs every dock and dialog: ``python -m resources.contact_sheets FOLDER``.

Sheets for each of three sizes of the window, light and dark, to be looked at after changes of the
window: as it begins, with a lens that was designed and checked, and what pops up over it. Needs a
screen of 2560 × 1440 pixels, real or virtual.
"""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

from PySide6.QtCore import QEventLoop, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPixmap
from PySide6.QtWidgets import QApplication

from resources import contact_parts as parts
from resources.make_screenshot import begin, design, open_window, settle
from ui.main_window import MainWindow

_SIZES = (QSize(1280, 800), QSize(1600, 1000), QSize(2560, 1440))
_SCHEMES = {"light": Qt.ColorScheme.Light, "dark": Qt.ColorScheme.Dark}
_GAP = 12
_ITERATIONS = 10  # enough for curves
_SAMPLING = 20_000  # milliseconds: enough lenses for a distribution

Part = Callable[[MainWindow], Iterator[QPixmap]]


def make(folder: Path) -> None:
    """Write ``SCHEME-WIDTH-PART.png`` for each."""
    application = begin()
    window = open_window("flame", _SIZES[0])
    settle()
    _photograph(application, window, folder, {"begun": parts.docks})
    _work(window)
    over = {"curve": parts.curve, "tools": parts.tools, "menus": parts.menus}
    asked = {"dialogs": parts.dialogs, "tour": parts.tour}
    _photograph(application, window, folder, {"docks": parts.docks, **over, **asked})
    _photograph(application, window, folder, {"forms": parts.forms})
    window.discard_and_close()


def _work(window: MainWindow) -> None:
    """Two runs, a check, a sample of tolerances, and a line across the image."""
    loaded, scene = window.loaded, window.document.session.scene
    assert loaded is not None
    run = scene.run.model_copy(update={"iterations": _ITERATIONS})
    window.document.edit(scene.model_copy(update={"run": run}), "iterations", "")
    for _ in range(2):
        design(window)
    checked = QEventLoop()
    loaded.check.checked.connect(checked.quit)
    window.commands["check"].trigger()
    checked.exec()
    start = loaded.tolerances.begin
    start.click()
    settle(_SAMPLING)
    start.click()


def _photograph(
    application: QApplication, window: MainWindow, folder: Path, wanted: dict[str, Part]
) -> None:
    for name, scheme in _SCHEMES.items():
        application.styleHints().setColorScheme(scheme)
        for size in _SIZES:
            window.resize(size)
            settle(500)
            window.commands["reset_layout"].trigger()
            settle()
            for part, pictures in wanted.items():
                sheet = _sheet(list(pictures(window)), size.width())
                sheet.save(str(folder / f"{name}-{size.width()}-{part}.png"))


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
