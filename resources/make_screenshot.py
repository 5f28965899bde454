"""Takes the README's pictures of the real window: ``python -m resources.make_screenshot``.

Needs a screen, real or virtual: ``xvfb-run -a -s '-screen 0 1600x1000x24' python -m ...``.
"""

import os
import sys
from collections.abc import Callable

from PySide6.QtCore import QEventLoop, QSettings, QSize, Qt, QTimer
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QApplication, QDialog

import resources
from ui.document.document import Document
from ui.main_window import MainWindow
from ui.widgets import theme
from workbench.files.session import open_design

_SIZE = QSize(1440, 900)
_SETTLING = 5000  # milliseconds in which all views have had their turn


def begin() -> QApplication:
    """An application whose colour scheme can be set."""
    if sys.platform.startswith("linux"):
        os.environ.setdefault("QT_QPA_PLATFORMTHEME", "gnome")  # heeds `setColorScheme`
    application = QApplication(sys.argv[:1])
    theme.apply(application)
    return application


def open_window(example: str, size: QSize) -> MainWindow:
    """A window with its views, and an example in it."""
    path = resources.path("examples", f"{example}.json")
    settings = QSettings("none", "screenshot")
    settings.clear()
    settings.setValue("coach_marks_shown", True)
    window = MainWindow(Document(open_design(path), example), settings)
    window.resize(size)
    window.show()
    window.activateWindow()
    window.commands["reset_layout"].trigger()  # the docks were laid out for another size
    window.build()
    return window


def design(window: MainWindow, command: str = "start") -> None:
    """Run the design and the check of its lens to their ends; ``command`` begins it."""
    assert window.loaded is not None
    control, check = window.loaded.control, window.loaded.runs.check
    done = QEventLoop()
    control.ended.connect(done.quit, Qt.ConnectionType.SingleShotConnection)
    window.commands[command].trigger()
    done.exec()
    for outcome in (check.checked, check.failed):
        outcome.connect(done.quit, Qt.ConnectionType.SingleShotConnection)
    done.exec()
    settle()


def settle(milliseconds: int = _SETTLING) -> None:
    """Let the window draw."""
    loop = QEventLoop()
    QTimer.singleShot(milliseconds, loop.quit)
    loop.exec()


def dialog_of(window: MainWindow, command: str) -> QPixmap:
    """The dialog that a command opens."""
    before = set(window.findChildren(QDialog))
    window.commands[command].trigger()
    settle(500)
    (dialog,) = set(window.findChildren(QDialog)) - before
    picture = dialog.grab()
    dialog.close()
    return picture


def make() -> None:
    """Design the flame in a window, and write ``readme/*.png`` on the way."""
    theme.choose(begin(), "dark")
    window = open_window("flame", _SIZE)
    window.commands["new"].trigger()
    settle()

    def take(name: str, picture: Callable[[], QPixmap] = window.grab) -> None:
        picture().save(str(resources.path("readme", f"{name}.png")))

    take("start")
    window.pages.show_desk()
    design(window)
    take("window")
    for command in ("go_surface", "go_section", "go_history", "sculpt"):
        window.commands[command].trigger()
    settle()
    take("sculpting")
    window.discard_and_close()


if __name__ == "__main__":
    make()
