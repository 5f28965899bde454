"""What it costs to see a run: a table of iterations, CPU time and waiting, seen in several ways.

``xvfb-run -a -s '-screen 0 1600x1000x24' python -m tests.soak.hidden_views``

A run that never ends goes on while all docks are open, while the 3D scene is hidden, while the
docks are hidden, and while the window is minimised. These take turns, so that another program that
takes a core for a while slows all of them alike, and ratios hold. Before that, with no run, control
points are dragged.
"""

import argparse
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import numpy as np
from PySide6.QtCore import QEvent, QEventLoop, QObject, QPoint, QPointF, QSettings, Qt, QTimer
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget

import resources
from ui import app
from ui.document.document import Document
from ui.main_window import MainWindow
from ui.views.view import View
from workbench.analysis.benchmark.machine import Machine
from workbench.analysis.benchmark.table import Table, TableColumn
from workbench.analysis.kernels import compile_all
from workbench.files.session import Session, open_design

_SETTLING = 1.0  # seconds after a change of what is shown
_TICK_MS = 5
_DRAG_MS = 16  # from one event of the mouse to the next


@dataclass(frozen=True)
class Turn:
    """A run seen in one way for some seconds.

    Attributes
    ----------
    pace : float
        Iterations a second.
    cost_ms : float
        CPU time of the whole program for each iteration.
    share : float
        Of a core that the window's thread takes.
    waits_ms : ndarray
        How long the event loop let a timer of 5 ms wait each time.
    """

    pace: float
    cost_ms: float
    share: float
    waits_ms: np.ndarray


@dataclass(frozen=True)
class Row:
    """What is told of one way to see a run; ratios are to all docks shown, of the same round."""

    seen: str
    pace: float
    pace_ratio: float
    cost_ms: float
    cost_ratio: float
    share: float
    share_ratio: float
    p99_ms: float
    longest_ms: float


@dataclass(frozen=True)
class DragRow:
    """How control points that are dragged are followed by 3D scene and irradiance."""

    seen: str
    frames: float
    cpu_ms: float
    p99_ms: float
    longest_ms: float


_COLUMNS = (
    TableColumn("seen", "seen of the run"),
    TableColumn("pace", "iterations/s", ".0f"),
    TableColumn("pace_ratio", "times as many", ".2f"),
    TableColumn("cost_ms", "CPU for each, in all (ms)", ".1f"),
    TableColumn("cost_ratio", "times as much", ".2f"),
    TableColumn("share", "CPU of the window's thread", ".1%"),
    TableColumn("share_ratio", "times as much", ".2f"),
    TableColumn("p99_ms", "event loop, 99th percentile (ms)", ".0f"),
    TableColumn("longest_ms", "longest (ms)", ".0f"),
)
_DRAG_COLUMNS = (
    TableColumn("seen", "seen"),
    TableColumn("frames", "pictures/s", ".1f"),
    TableColumn("cpu_ms", "CPU of the window's thread for each (ms)", ".0f"),
    TableColumn("p99_ms", "event loop, 99th percentile (ms)", ".0f"),
    TableColumn("longest_ms", "longest (ms)", ".0f"),
)


class Waits(QObject):
    """Notes how long the event loop lets a timer wait."""

    def __init__(self) -> None:
        super().__init__()
        self.ms: list[float] = []
        self._last = time.perf_counter()
        self._timer = QTimer(self, interval=_TICK_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._note)
        self._timer.start()

    def _note(self) -> None:
        now = time.perf_counter()
        self.ms.append(1000 * (now - self._last))
        self._last = now


def all_docks(window: MainWindow) -> None:
    """Show the 3D scene and every dock; those behind a tab float beside."""
    window.showNormal()
    window.commands["scene_view"].setChecked(True)
    corner = window.geometry().topLeft()
    for dock in window.workspace.docks.values():
        dock.show()
        if window.tabifiedDockWidgets(dock):
            dock.setFloating(True)
            dock.resize(420, 320)
            corner += QPoint(40, 30)
            dock.move(corner)


def scene_hidden(window: MainWindow) -> None:
    """Show all docks, but not the 3D scene."""
    all_docks(window)
    window.commands["scene_view"].setChecked(False)


def docks_hidden(window: MainWindow) -> None:
    """Show the 3D scene, and no dock but the forms."""
    all_docks(window)
    for name, dock in window.workspace.docks.items():
        dock.setVisible(name == "design")


def minimised(window: MainWindow) -> None:
    """Show nothing."""
    all_docks(window)
    window.showMinimized()
    for dock in window.workspace.docks.values():
        if dock.isFloating():  # what a window manager does with a window's own
            dock.hide()


WAYS: dict[str, Callable[[MainWindow], None]] = {
    "all docks": all_docks,
    "all docks, 3D hidden": scene_hidden,
    "3D alone": docks_hidden,
    "minimised": minimised,
}
"""Ways to see a run; the first is what the others are compared with."""


def wait(seconds: float) -> None:
    """Let the event loop run."""
    loop = QEventLoop()
    QTimer.singleShot(int(1000 * seconds), loop.quit)
    loop.exec()


def measure(window: MainWindow, frames: list, seconds: float) -> Turn:
    """See the run for a while as the window shows it."""
    wait(_SETTLING)
    waits, began, iteration = Waits(), time.perf_counter(), frames[-1].snapshot.iteration
    own, all_threads = time.thread_time(), time.process_time()
    wait(seconds)
    taken, done = time.perf_counter() - began, frames[-1].snapshot.iteration - iteration
    own, all_threads = time.thread_time() - own, time.process_time() - all_threads
    waits.deleteLater()
    return Turn(done / taken, 1000 * all_threads / done, own / taken, np.array(waits.ms))


def rows(turns: dict[str, list[Turn]]) -> list[Row]:
    """Medians of all rounds, and of their ratios."""
    first = next(iter(turns.values()))

    def figure(own: list[Turn], name: str) -> tuple[float, float]:
        values = [getattr(turn, name) for turn in own]
        ratios = [value / getattr(turn, name) for value, turn in zip(values, first, strict=True)]
        return median(values), median(ratios)

    made = []
    for seen, own in turns.items():
        waits = np.concatenate([turn.waits_ms for turn in own])
        figures = [part for name in ("pace", "cost_ms", "share") for part in figure(own, name)]
        made.append(Row(seen, *figures, float(np.quantile(waits, 0.99)), float(waits.max())))
    return made


def drag(window: MainWindow, seen: str, seconds: float) -> DragRow:
    """Take hold of the middle of the lens and move it to and fro along the axis."""
    window.commands["sculpt"].trigger()
    view, image = window.loaded.views.scene, window.loaded.views.docked["irradiance"]
    drawn = [count_drawings(each) for each in (view, image)]
    wait(_SETTLING)
    n_u, n_v = window.document.session.scene.optic.net_shape
    ((x, y),) = view.sight.pixels(np.array([view.nets.picture.places[n_u // 2, n_v // 2]]))
    plotter, scale = view._plotter, view.devicePixelRatioF()
    start = QPointF(x / scale, plotter.height() - 1 - y / scale)
    move(plotter, QEvent.Type.MouseMove, start)
    move(plotter, QEvent.Type.MouseButtonPress, start)
    for times in drawn:
        times.clear()
    waits, began, steps, cpu = Waits(), time.perf_counter(), 0, time.thread_time()
    while (taken := time.perf_counter() - began) < seconds:
        steps += 1
        way = QPointF(20 * np.sin(steps / 10), 0)
        move(plotter, QEvent.Type.MouseMove, start + way)
        wait(_DRAG_MS / 1000)
    frames, cpu = min(map(len, drawn)), time.thread_time() - cpu
    move(plotter, QEvent.Type.MouseButtonRelease, start)
    window.document.undo_stack.setIndex(0)
    window.commands["turn"].trigger()
    gaps = np.array(waits.ms)
    waits.deleteLater()
    return DragRow(
        seen,
        frames / taken,
        1000 * cpu / frames,
        float(np.quantile(gaps, 0.99)),
        float(gaps.max()),
    )


def count_drawings(view: View) -> list[float]:
    """When a view draws, from now on."""
    times: list[float] = []
    draw = view._draw

    def drawing(*arguments) -> None:
        draw(*arguments)
        times.append(time.perf_counter())

    view._draw = drawing
    return times


def move(widget: QWidget, kind: QEvent.Type, place: QPointF) -> None:
    """An event of the mouse with its left button held."""
    left, none = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
    button = none if kind is QEvent.Type.MouseMove else left
    held = none if kind is QEvent.Type.MouseButtonRelease else left
    keys = Qt.KeyboardModifier.NoModifier
    event = QMouseEvent(kind, place, widget.mapToGlobal(place), button, held, keys)
    QApplication.sendEvent(widget, event)


def design() -> Session:
    """The flame with 64 × 64 control points and 256 × 256 rays, and a run that never ends."""
    shipped = open_design(resources.path("examples", "flame.json"))
    data = shipped.scene.to_data()
    data["run"] = {"method": "paper", "iterations": 1_000_000}
    data["lens"]["control_points"] = [64, 64]
    data["source"]["rays"] = [256, 256]
    return Session(shipped.scene.from_data(data), shipped.target)


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser("tests.soak.hidden_views")
    parser.add_argument("--seconds", type=float, default=6.0, help="for each turn")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    app._prepare_environment()
    compile_all()  # as the program does behind its window
    QApplication.setQuitOnLastWindowClosed(False)
    app._application()
    with tempfile.TemporaryDirectory() as folder:
        settings = QSettings(str(Path(folder) / "s.ini"), QSettings.Format.IniFormat)
        window = MainWindow(Document(design(), "flame"), settings)
        window.resize(1600, 1000)
        window.show()
        window.build()
        while window.loaded.views.scene.frame is None or window.loaded.views.scene.optic is None:
            wait(0.2)
        dragged = [drag(window, "as opened", options.seconds)]
        all_docks(window)
        dragged.append(drag(window, "all docks", options.seconds))
        frames: list = []
        window.loaded.control.runner.frame_ready.connect(frames.append)
        window.start()
        while not frames:
            wait(0.2)
        turns: dict[str, list[Turn]] = {seen: [] for seen in WAYS}
        for _ in range(options.rounds):
            for seen, show in WAYS.items():
                show(window)
                turns[seen].append(measure(window, frames, options.seconds))
        window.discard_and_close()
        del window
    print(Machine.here().to_markdown())
    print(Table("A run, seen in several ways", _COLUMNS, rows(turns)).to_markdown())
    print(Table("Control points of a net of 64 × 64 dragged", _DRAG_COLUMNS, dragged).to_markdown())


if __name__ == "__main__":
    main()
