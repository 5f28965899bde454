"""Takes the README's picture of the real window: ``python -m resources.make_screenshot``.

Needs a screen, real or virtual: ``xvfb-run -a -s '-screen 0 1600x1000x24' python -m ...``.
"""

import sys

from PySide6.QtCore import QEventLoop, QSettings, QSize, QTimer
from PySide6.QtWidgets import QApplication

import resources
from ui import theme
from ui.document import Document
from ui.main_window import MainWindow
from workbench.files.session import open_design

_SIZE = QSize(1440, 900)
_EXAMPLE = "flame"


def make() -> None:
    """Design the example in a window and write ``readme/window.png``."""
    application = QApplication(sys.argv[:1])
    theme.apply(application)
    example = resources.path("examples", f"{_EXAMPLE}.json")
    window = MainWindow(Document(open_design(example), _EXAMPLE), QSettings("none", "screenshot"))
    window.resize(_SIZE)
    window.show()
    window.build()
    assert window.control is not None
    done = QEventLoop()
    window.control.ended.connect(lambda: QTimer.singleShot(1000, done.quit))
    window.start()
    done.exec()
    window.grab().save(str(resources.path("readme", "window.png")))
    window.discard_and_close()


if __name__ == "__main__":
    make()
