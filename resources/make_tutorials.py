"""Does the tutorials of the manual in the real window, and takes their pictures on the way.

Needs a screen, real or virtual: ``xvfb-run -a -s '-screen 0 1600x1000x24' python -m
resources.make_tutorials``; some minutes. A name, such as ``led``, does one tutorial alone.
"""

import sys
import time
from collections.abc import Callable

from PySide6.QtCore import QSize, QTimer
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QApplication, QLabel

import resources
from resources.make_screenshot import begin, design, open_window, settle
from ui.main_window import MainWindow
from ui.manufacture.cutter import CutterDialog
from ui.manufacture.plan import PlanDialog
from ui.widgets import theme
from workbench.jobs import Job
from workbench.jobs.lenses import BeamShaper, Experiment, LedRectangle, StreetLight, SunPlate
from workbench.jobs.prospect import Prospect

_SIZE = QSize(1280, 800)
_PATIENCE = 300.0  # seconds
_WAITING = ("Computed when", "Tracing", "Computing")


def until(condition: Callable[[], object], what: str) -> None:
    """Let the window work until a condition holds."""
    give_up = time.monotonic() + _PATIENCE
    while not condition():
        assert time.monotonic() < give_up, f"waited in vain for {what}"
        settle(50)


def take(name: str, picture: QPixmap) -> None:
    """Write a picture of the manual."""
    picture.save(str(resources.path("manual", "images", f"{name}.png")))


def choose(window: MainWindow, kind: type[Job], picture: str) -> None:
    """Choose a job on the start page, see what can be expected of it, and begin it."""
    window.commands["new"].trigger()
    page = window.start_page
    found: list[Prospect] = []
    page.job.estimate.estimated.connect(found.append)
    page.show_job(kind)
    until(lambda: any(each.picture is not None for each in found), "the estimate")
    settle(500)
    take(picture, page.grab())
    page.job.begin()
    until(lambda: not window.pages.at_start, "the window")


def show(window: MainWindow, *commands: str) -> None:
    """Give commands one after the other, and wait for what is computed of the lens that rests."""
    for command in commands:
        window.commands[command].trigger()
        settle(1500)
    until(lambda: not any(map(_waits, window.findChildren(QLabel))), "what is computed")
    settle()


def _waits(label: QLabel) -> bool:
    return label.isVisible() and label.text().startswith(_WAITING)


def sun_plate(window: MainWindow) -> None:
    """A plate for the sun, from the picture to the program of the milling machine."""
    window.commands["new"].trigger()
    settle(1000)
    take("sun-plate-start", window.grab())
    choose(window, SunPlate, "sun-plate-job")
    design(window)
    take("sun-plate-lens", window.grab())
    show(window, "workspace_check")
    take("sun-plate-check", window.grab())
    show(window, "workspace_make")
    take("sun-plate-make", window.grab())
    window.commands["plan"].trigger()
    (plan,) = window.findChildren(PlanDialog)
    until(plan.use.isEnabled, "the plans")
    take("sun-plate-plan", plan.grab())
    plan.use.click()
    design(window, "continue")
    take("sun-plate-made", window.grab())
    pictures: list[QPixmap] = []

    def look() -> None:
        (dialog,) = window.findChildren(CutterDialog)
        until(dialog.look.isEnabled, "the cut")
        dialog.trace()
        until(dialog.look.isEnabled, "light through the cut")
        pictures.append(dialog.grab())
        dialog.reject()

    QTimer.singleShot(500, look)
    window.commands["cut"].trigger()
    take("sun-plate-cut", pictures[0])


def led(window: MainWindow) -> None:
    """An LED before one face, and before two."""
    choose(window, LedRectangle, "led-job")
    design(window)
    show(window, "go_light")
    take("led-one-face", window.grab())
    show(window, "second_face")
    design(window)
    show(window, "go_runs")
    take("led-two-faces", window.grab())


def beam_shaper(window: MainWindow) -> None:
    """A laser beam made even."""
    choose(window, BeamShaper, "beam-job")
    design(window)
    take("beam-lens", window.grab())
    show(window, "go_section", "go_focus")
    take("beam-section", window.grab())


def street(window: MainWindow) -> None:
    """The far field of a lamp that was measured."""
    choose(window, StreetLight, "street-job")
    design(window)
    take("street-lens", window.grab())


def paper(window: MainWindow) -> None:
    """A design of the paper, and how its image answers to a control point."""
    choose(window, Experiment, "paper-job")
    design(window)
    take("paper-lens", window.grab())


TUTORIALS = {
    "sun-plate": sun_plate,
    "led": led,
    "beam-shaper": beam_shaper,
    "street": street,
    "paper": paper,
}


def make(names: list[str]) -> None:
    """Do some tutorials, or all."""
    theme.choose(begin(), "dark")
    resources.path("manual", "images").mkdir(exist_ok=True)
    for name in names or TUTORIALS:
        window = open_window("tophat", _SIZE)
        if window.commands["follow"].isChecked():
            window.commands["follow"].trigger()
        TUTORIALS[name](window)
        window.discard_and_close()
        QApplication.processEvents()


if __name__ == "__main__":
    make(sys.argv[1:])
