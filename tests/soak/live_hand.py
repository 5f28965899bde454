"""A lens that follows the mouse: ``python -m tests.soak.live_hand FOLDER``.

The real program runs on a screen of its own and is used by mouse and keyboard from outside: the
index of the lens is typed into its field again and again; then the source is dragged in the 3D
scene, an event every 16 ms, while lenses follow. Printed are tables of waiting for lenses, how
long the event loop lets a timer wait, and memory. The folder gets pictures, to be looked at.
"""

import argparse
import json
import math
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtWidgets import QApplication

import resources
from tests.soak.hand import Hand, SeenWidgets, middle
from tests.soak.screen import Screen, virtual_screen
from ui import app
from ui.main_window import MainWindow
from workbench.analysis.benchmark.examples import Table, TableColumn
from workbench.analysis.benchmark.machine import Machine
from workbench.design.loss import relative_error

_TICK_MS = 5
_EXAMPLE = "flame-point"
_FIELD = "Index"
_LOOK_MS, _REPORT_MS = 100, 500
_EVENT = 0.016  # seconds from one event of the mouse to the next
_CIRCLE = 40  # pixels, the diameter of the way of the mouse
_TURN = 64  # events for one round
_PATIENCE = 300.0  # seconds, on a machine that does much else


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


class Watch(QObject):
    """Writes down what happens in the program, one JSON object a line, each with its time.

    Edits and lenses carry index and place of the source as the name of their task.
    """

    def __init__(self, file: Path, application: QApplication) -> None:
        super().__init__(application)
        self._file, self._waits = file.open("a", buffering=1), Waits()
        self._measure, self._seen = (
            _flag(file),
            SeenWidgets(file.with_name("seen.json"), application),
        )
        self._window: Any = None
        self._look = QTimer(self, interval=_LOOK_MS)
        self._look.timeout.connect(self._find)
        self._look.start()
        self._tell = QTimer(self, interval=_REPORT_MS)
        self._tell.timeout.connect(self._tell_waits)

    def _find(self) -> None:
        """Wait until the design is on show, and follow it from then on."""
        tops = (top for top in QApplication.topLevelWidgets() if isinstance(top, MainWindow))
        window = next(tops, None)
        if window is None or window.loaded is None or window.loaded.views.scene.handles is None:
            return
        self._look.stop()
        self._window = window
        window.document.edited.connect(self._note_edit)
        window.loaded.control.runner.frame_ready.connect(self._note_lens)
        self._waits.ms.clear()
        self._tell.start()

    def _note_edit(self, _: Any, after: Any) -> None:
        self._write("edit", task=_task(after.scene))

    def _note_lens(self, frame: Any) -> None:
        error = relative_error(frame.state, frame.session.target)
        step = frame.snapshot.iteration
        self._write("lens", task=_task(frame.session.scene), error=error, step=step)

    def _tell_waits(self) -> None:
        waits, self._waits.ms = self._waits.ms, []
        at_source = self._place_of_source()
        self._write("waits", ms=waits, text=self._window.loaded.follow.text, at_source=at_source)
        if self._measure.exists():
            self._seen.stop()

    def _place_of_source(self) -> list[int] | None:
        """Where on the screen the source is seen."""
        view = self._window.loaded.views.scene
        source, ratio = view.source, view.devicePixelRatioF()
        if view.sight is None or source is None or source.place is None:
            return None
        ((x, y),) = view.sight.pixels(np.array([source.place])) / ratio
        plotter = view._plotter
        corner = plotter.mapToGlobal(QPoint(round(x), plotter.height() - 1 - round(y)))
        return [round(ratio * corner.x()), round(ratio * corner.y())]

    def _write(self, kind: str, **what: Any) -> None:
        self._file.write(json.dumps({"kind": kind, "at": time.monotonic(), **what}) + "\n")


def _flag(file: Path) -> Path:
    """A file that is there as soon as waiting is measured."""
    return file.with_name("measured")


def _task(scene: Any) -> str:
    return f"{scene.optic.index:.6g} {scene.source.place}"


class ReportedEvents:
    """What the program has written down so far."""

    def __init__(self, file: Path) -> None:
        self.file, self._read = file, 0
        self.lines: list[dict[str, Any]] = []

    def look(self) -> list[dict[str, Any]]:
        """All lines."""
        if self.file.exists():
            with self.file.open() as file:
                file.seek(self._read)
                for line in iter(file.readline, ""):
                    if not line.endswith("\n"):
                        break
                    self._read += len(line)
                    self.lines.append(json.loads(line))
        return self.lines

    def since(self, begun: float, kind: str) -> list[dict[str, Any]]:
        """Lines of a kind since some time."""
        return [each for each in self.look() if each["kind"] == kind and each["at"] >= begun]

    def waits(self, begun: float) -> tuple[float, float]:
        """99th percentile and maximum of how long the event loop let a timer wait, ms."""
        ms = np.concatenate([each["ms"] for each in self.since(begun, "waits")])
        return float(np.quantile(ms, 0.99)), float(ms.max())


@dataclass(frozen=True)
class Row:
    """How lenses follow one kind of edit."""

    edits: str
    count: int
    first: float
    worst: float
    error: float
    good: float | None
    lenses: float | None
    p99_ms: float
    longest_ms: float


_COLUMNS = (
    TableColumn("edits", "edits"),
    TableColumn("count", "number", "d"),
    TableColumn("first", "first lens, median (s)", ".2f"),
    TableColumn("worst", "at worst (s)", ".2f"),
    TableColumn("error", "its error, median", ".1%"),
    TableColumn("good", "2 %, median (s)", ".2f"),
    TableColumn("lenses", "tasks with a lens, each second", ".1f"),
    TableColumn("p99_ms", "event loop, 99th percentile (ms)", ".0f"),
    TableColumn("longest_ms", "longest (ms)", ".0f"),
)
_GOOD = 0.02


def type_indices(hand: Hand, reported: ReportedEvents, count: int, seconds: float) -> Row:
    """Type indices, each when the lens for the one before is good, or after some seconds."""
    field = hand.wait(_FIELD, kind="NumberEditor")
    before, place = float(field["text"]), middle(field["place"])
    _flag(reported.file).touch()
    time.sleep(2 * _REPORT_MS / 1000)
    begun = time.monotonic()
    first, errors, good = [], [], []
    for number in range(count):
        asked = time.monotonic()
        hand.click_at(*place, times=3)
        hand.type(f"{before * (1 + 0.002 * (number + 1)):.6g}")
        edit = hand.until(lambda at=asked: reported.since(at, "edit"), "edit")[-1]

        def lenses(most: float, edit: Any = edit) -> list[dict[str, Any]]:
            return [
                each
                for each in reported.since(edit["at"], "lens")
                if each["task"] == edit["task"] and each["step"] and each["error"] <= most
            ]

        lens = hand.until(lambda: lenses(math.inf), "lens", _PATIENCE)[0]
        first.append(lens["at"] - edit["at"])
        errors.append(lens["error"])
        give_up = time.monotonic() + seconds
        while not (found := lenses(_GOOD)) and time.monotonic() < give_up:
            time.sleep(0.05)
        good.append(found[0]["at"] - edit["at"] if found else math.inf)
    time.sleep(2 * _REPORT_MS / 1000)
    return Row(
        "index typed",
        count,
        float(np.median(first)),
        max(first),
        float(np.median(errors)),
        float(np.median(good)) if np.isfinite(np.median(good)) else None,
        None,
        *reported.waits(begun),
    )


def drag_source(hand: Hand, screen: Screen, reported: ReportedEvents, seconds: float) -> Row:
    """Drag the source round and round in the 3D scene."""
    x, y = reported.since(0.0, "waits")[-1]["at_source"]
    screen.do("mousemove", x, y)
    time.sleep(0.3)
    screen.do("mousedown", 1)
    begun = time.monotonic()
    pictured = False
    while (taken := time.monotonic() - begun) < seconds:
        if not pictured and taken > seconds / 2:
            hand.picture("dragged")
            pictured = True
        way: list[Any] = []
        for step in range(_TURN):
            angle = 2 * math.pi * (step + 1) / _TURN
            to = x + _CIRCLE * (1 - math.cos(angle)) / 2, y + _CIRCLE * math.sin(angle) / 2
            way += ["mousemove", round(to[0]), round(to[1]), "sleep", _EVENT]
        screen.do(*way)
    screen.do("mouseup", 1)
    let_go = time.monotonic()
    time.sleep(2 * _REPORT_MS / 1000)
    edits = reported.since(begun, "edit")
    last = edits[-1]

    def of_last() -> list[dict[str, Any]]:
        lenses = reported.since(last["at"], "lens")
        return [each for each in lenses if each["task"] == last["task"] and each["step"]]

    lens = hand.until(of_last, "lens of the last task", _PATIENCE)[0]
    errors: dict[str, float] = {}  # of the first lens of each task
    for each in reported.since(begun, "lens"):
        if each["step"]:
            errors.setdefault(each["task"], each["error"])
    seen_tasks = {each["task"] for each in reported.since(begun, "lens") if each["at"] < let_go}
    rest = max(lens["at"] - let_go, 0.0)
    return Row(
        "source dragged; first lens after letting go",
        len(edits),
        rest,
        rest,
        float(np.median(list(errors.values()))),
        None,
        len(seen_tasks) / (let_go - begun),
        *reported.waits(begun),
    )


def memory(process: int) -> float:
    """Of a process now, MB."""
    text = Path(f"/proc/{process}/status").read_text("ascii")
    return int(text.split("VmRSS:")[1].split()[0]) / 1024


def rest(hand: Hand, reported: ReportedEvents) -> None:
    """Wait until nothing follows any more."""

    def still() -> bool:
        words = reported.since(time.monotonic() - 2.5 * _REPORT_MS / 1000, "waits")
        return len(words) > 1 and not any(each["text"] for each in words)

    hand.until(still, "a rest", _PATIENCE)


def use(hand: Hand, screen: Screen, reported: ReportedEvents, options: argparse.Namespace) -> None:
    """Edit by keyboard, then by mouse; print what that was like."""
    hand.until(lambda: reported.since(0.0, "waits"), "the program", _PATIENCE)
    hand.fill_screen("Freeform")
    hand.focus("Freeform")
    rest(hand, reported)
    hand.picture("opened")
    rows = [type_indices(hand, reported, options.moves, options.patience)]
    rest(hand, reported)
    hand.picture("typed")
    hand.press("alt+m")
    time.sleep(1.0)
    hand.picture("tool")
    memories, edits, begun = [f"0 edits: {memory(hand.program.pid):.0f} MB"], 0, time.monotonic()
    while True:
        rows.append(drag_source(hand, screen, reported, options.seconds))
        edits = len(reported.since(begun, "edit"))
        memories.append(f"{edits} edits: {memory(hand.program.pid):.0f} MB")
        if edits >= options.edits:
            break
    rest(hand, reported)
    hand.picture("rested")
    memories.append(f"at rest: {memory(hand.program.pid):.0f} MB")
    print(Machine.here().to_markdown())
    print(Table("Edits by keyboard and mouse, followed by lenses", _COLUMNS, rows).to_markdown())
    print("\n".join(memories))


def run_program(file: Path, example: str) -> int:
    """Run the program, and write down what happens."""
    make = app._application

    def watched() -> QApplication:
        application = make()
        Watch(file, application)
        return application

    app._application = watched
    return app.main([example])


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser("tests.soak.live_hand")
    parser.add_argument("folder", type=Path)
    parser.add_argument(
        "--example", default=_EXAMPLE, help="one whose source can be moved, or a file"
    )
    parser.add_argument("--moves", type=int, default=12, help="indices to type")
    parser.add_argument("--patience", type=float, default=6.0, help="seconds for 2 percent")
    parser.add_argument("--seconds", type=float, default=8.0, help="of each drag")
    parser.add_argument("--edits", type=int, default=500, help="by mouse, at least")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    with virtual_screen(options.folder) as screen:
        file = options.folder / "reported.jsonl"
        file.unlink(missing_ok=True)
        shipped = resources.path("examples", f"{options.example}.json")
        example = shipped if shipped.exists() else Path(options.example)
        hand = Hand(screen, options.folder, program=("tests.soak.live_hand", file, example))
        try:
            use(hand, screen, ReportedEvents(file), options)
        finally:
            hand.close()


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1].endswith(".jsonl"):
        sys.exit(run_program(Path(sys.argv[1]), sys.argv[2]))
    main()
