"""What it is like to be followed: a table of waiting for lenses, and of memory after many edits.

``xvfb-run -a -s '-screen 0 1600x1000x24' python -m tests.soak.live_design letter photo``

The screen of an example is moved a little, to and fro. Each edit is made when the lens for the one
before is as good as asked for, or after some seconds. Then it is dragged: an edit every 16 ms, and
lenses are counted. With ``--edits 500`` memory is told after every hundredth edit.
"""

import argparse
import math
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PySide6.QtCore import QSettings
from PySide6.QtWidgets import QApplication

import resources
from tests.soak.hidden_views import Waits, wait
from ui import app
from ui.document.document import Document
from ui.main_window import MainWindow
from workbench.analysis.benchmark.machine import Machine
from workbench.analysis.benchmark.table import Table, TableColumn
from workbench.analysis.kernels import compile_all
from workbench.design.loss import relative_error
from workbench.files.session import open_design

_TURN = 0.002  # seconds of the event loop between two looks
_DRAG = 0.016  # seconds from one event of a drag to the next


@dataclass(frozen=True)
class Row:
    """How the lens of an example follows the edits of one kind."""

    edits: str
    count: int
    first: float
    first_worst: float
    error: float
    good: str
    p99_ms: float
    longest_ms: float


@dataclass(frozen=True)
class DragRow:
    """How many lenses are seen while a value is dragged."""

    example: str
    lenses: float
    rest: float
    p99_ms: float
    longest_ms: float


_COLUMNS = (
    TableColumn("edits", "edits"),
    TableColumn("count", "number", "d"),
    TableColumn("first", "first lens, median (s)", ".2f"),
    TableColumn("first_worst", "at worst (s)", ".2f"),
    TableColumn("error", "its error, median", ".1%"),
    TableColumn("good", "good enough, median (s)"),
    TableColumn("p99_ms", "event loop, 99th percentile (ms)", ".0f"),
    TableColumn("longest_ms", "longest (ms)", ".0f"),
)
_DRAG_COLUMNS = (
    TableColumn("example", "dragged"),
    TableColumn("lenses", "tasks with a lens seen, each second", ".1f"),
    TableColumn("rest", "lens of the last task after letting go (s)", ".2f"),
    TableColumn("p99_ms", "event loop, 99th percentile (ms)", ".0f"),
    TableColumn("longest_ms", "longest (ms)", ".0f"),
)


class Desk:
    """A window whose screen is moved, and the lenses that follow."""

    def __init__(self, window: MainWindow) -> None:
        self.window, self.document = window, window.document
        self.frames: list = []
        window.loaded.control.runner.frame_ready.connect(self._note)

    def _note(self, frame) -> None:
        if frame.snapshot.iteration:
            error = relative_error(frame.state, frame.session.target)
            self.frames.append((time.perf_counter(), frame.session.scene.receiver.z, error))

    def move(self, z: float, key: str = "") -> float:
        """Move the screen; when that was."""
        began = time.perf_counter()
        scene = self.document.session.scene
        screen = scene.receiver.moved_to(z)
        self.document.edit(scene.with_receiver(screen), "move the screen", key)
        return began

    def lens(self, z: float, most: float, patience: float) -> tuple[float, float] | None:
        """When there was a lens of a task with at most some error, and its error."""
        give_up = time.perf_counter() + patience
        while time.perf_counter() < give_up:
            for at, its_z, error in self.frames:
                if its_z == z and error <= most:
                    return at, error
            wait(_TURN)
        return None

    def rest(self) -> None:
        """Wait until nothing is designed."""
        while self.window.loaded.follow.text:
            wait(0.1)


def edits(desk: Desk, name: str, moves: list[float], most: float, patience: float) -> Row:
    """Move the screen from place to place."""
    first, errors, good = [], [], []
    waits = Waits()
    for z in moves:
        desk.frames.clear()
        began = desk.move(z)
        found = desk.lens(z, np.inf, 60.0)
        if found is None:
            raise SystemExit(f"{name}: no lens within a minute")
        first.append(found[0] - began)
        errors.append(found[1])
        found = desk.lens(z, most, patience)
        good.append(np.inf if found is None else found[0] - began)
    ms = np.array(waits.ms)
    waits.deleteLater()
    middle = float(np.median(good))
    return Row(
        f"{name}, screen moved by {abs(moves[1] / moves[0] - 1):.0%}",
        len(moves),
        float(np.median(first)),
        max(first),
        float(np.median(errors)),
        f"{most:.0%}: " + (f"{middle:.2f}" if np.isfinite(middle) else f"not within {patience:g}"),
        float(np.quantile(ms, 0.99)),
        float(ms.max()),
    )


def drag(desk: Desk, name: str, z: float, seconds: float) -> DragRow:
    """Move the screen to and fro without a rest, as one step."""
    desk.rest()
    desk.frames.clear()
    waits, began, last = Waits(), time.perf_counter(), z
    while (taken := time.perf_counter() - began) < seconds:
        last = z * (1 + 0.05 * math.sin(2 * taken))
        desk.move(last, "drag")
        wait(_DRAG)
    let_go, seen = time.perf_counter(), {its_z for _, its_z, _ in desk.frames}
    found = desk.lens(last, np.inf, 60.0)
    ms = np.array(waits.ms)
    waits.deleteLater()
    rest = np.inf if found is None else found[0] - let_go
    return DragRow(name, len(seen) / seconds, rest, float(np.quantile(ms, 0.99)), float(ms.max()))


def memory() -> float:
    """Of this process now, MB."""
    text = Path("/proc/self/status").read_text("ascii")
    return int(text.split("VmRSS:")[1].split()[0]) / 1024


def many(desk: Desk, count: int, z: float) -> list[str]:
    """Edit again and again, as soon as there is a lens; the memory after every hundredth."""
    reported = []
    for number in range(count + 1):
        if number % 100 == 0:
            reported.append(f"{number} edits: {memory():.0f} MB")
        place = z * (1 + 0.01 * (number % 7))
        desk.frames.clear()
        desk.move(place)
        desk.lens(place, np.inf, 60.0)
    return reported


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser("tests.soak.live_design")
    parser.add_argument("examples", nargs="*", default=["letter", "photo"])
    parser.add_argument("--moves", type=int, default=12, help="for each kind of edit")
    parser.add_argument("--most", type=float, default=0.02, help="error that is good enough")
    parser.add_argument("--seconds", type=float, default=6.0, help="to wait for that, and to drag")
    parser.add_argument("--edits", type=int, default=0, help="to tell the memory after")
    options = parser.parse_args()
    app._prepare_environment()
    compile_all()
    QApplication.setQuitOnLastWindowClosed(False)
    app._application()
    rows, drags, reported = [], [], []
    for name in options.examples:
        with tempfile.TemporaryDirectory() as folder:
            settings = QSettings(str(Path(folder) / "s.ini"), QSettings.Format.IniFormat)
            session = open_design(resources.path("examples", f"{name}.json"))
            window = MainWindow(Document(session, name), settings)
            window.resize(1600, 1000)
            window.show()
            window.build()
            desk, z = Desk(window), session.scene.receiver.z
            while window.loaded.views.scene.frame is None:
                wait(0.2)
            desk.rest()
            for part in (0.01, 0.1):
                moves = [z * (1 + part * (number % 2)) for number in range(options.moves)]
                rows.append(edits(desk, name, moves[1:], options.most, options.seconds))
            drags.append(drag(desk, name, z, options.seconds))
            if options.edits:
                desk.rest()
                reported += [f"{name}, {line}" for line in many(desk, options.edits, z)]
            window.discard_and_close()
            del window, desk
    print(Machine.here().to_markdown())
    print(Table("Edits followed by lenses", _COLUMNS, rows).to_markdown())
    print(Table("A value dragged", _DRAG_COLUMNS, drags).to_markdown())
    print("\n".join(reported))


if __name__ == "__main__":
    main()
