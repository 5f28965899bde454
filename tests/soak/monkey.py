"""A monkey at the window: ``python -m tests.soak.monkey FOLDER --seed 1 --seconds 120``.

It plays with the real program, started as a person starts it, on whatever screen DISPLAY names.
Each step draws its choices from a generator of its own, made of seed and number, so that the same
seed does the same again as far as time allows. Settings, recovery files and whatever it saves lie
in FOLDER, and so does ``monkey.log``: each step before it is done, and every problem.

Every minute it rests: one window with the first example, nothing on. There it measures memory.
After ten minutes of warm-up the lowest of any five rests must not be more than 200 MB higher:
what can be undone, and caches, take more now and then, and give it back.
"""

import argparse
import ctypes
import gc
import json
import os
import sys
import threading
import time
from collections.abc import Generator
from pathlib import Path
from random import Random

from PySide6.QtCore import QObject, QThread, QTimer
from PySide6.QtWidgets import QApplication
from shiboken6 import isValid

import resources
from resources import EXAMPLES
from tests.soak.actions import ACTIONS, windows
from tests.soak.dialogs import answer, open_dialog
from tests.soak.monitor import Monitor, resident_mb
from tests.stress.random_trains import TrainDraw
from ui import app
from ui.main_window import MainWindow
from ui.windows import Windows
from workbench.geometry.surface import nets_of

REST_SECONDS = 60.0
WARM_UP_SECONDS = 600.0  # until every library has been loaded that something needs
GROWTH_MB, RESTS = 200.0, 5  # from then on, and so many rests of which the lowest counts
# Drawn trains: a designed mirror between lenses; two designed lenses, a mirror and a diffuser; a
# fixed B-spline face. The first and the last one in light of two colours.
TRAINS = 6, 21, 43
_THREADS = 2  # at rest: the window's and the watchdog
_PATIENCE = 120.0  # seconds until a run has stopped or a window has closed, on a busy machine
_ANSWER_MS = 150  # a dialog is looked at for so long


class Monkey(QObject):
    """Plays for some seconds, rests now and then, and closes all windows at the end.

    Parameters
    ----------
    folder : Path
        For settings, files and log.
    seed : int
        Of all choices.
    seconds : float
        How long it plays.
    program : Windows
        The program that it plays with.
    steps : int
        Number of the last step before its first.
    """

    def __init__(
        self, folder: Path, seed: int, seconds: float, program: Windows, steps: int = 0
    ) -> None:
        super().__init__()
        self._program = program
        self.memory: list[float] = []  # MB at each rest
        self.steps = steps
        self._seed, self._seconds = seed, seconds
        self._files = folder / "files"
        self._log = (folder / "monkey.log").open("a", buffering=1)
        self._began = time.monotonic()
        self._calm = False
        self._answers = 0
        self._warm_mb, self._warm_rests = 0.0, 0  # memory after the warm-up, and rests until then
        self._acting = False
        self._doing: Generator[int, None, None] | None = None
        self.monitor = Monitor(self.log, folder / "stacks.txt", _scenes)

    def log(self, line: str) -> None:
        """Write a line with the time since the start."""
        self._log.write(f"{time.monotonic() - self._began:8.2f} {line}\n")

    def begin(self) -> None:
        """Play as soon as the event loop runs."""
        QApplication.setQuitOnLastWindowClosed(False)
        self._doing = self._play()
        self._tick()

    def close(self) -> None:
        """Look for what remains once the program has ended."""
        for thread in threading.enumerate():
            other = thread not in (threading.main_thread(), threading.current_thread())
            if other and not thread.daemon and not isinstance(thread, threading._DummyThread):
                self.monitor.report(f"thread left: {thread.name}")
        for of_qt in [each for each in gc.get_objects() if type(each) is QThread]:
            if isValid(of_qt) and of_qt.isRunning():
                self.monitor.report(f"running thread left: {of_qt}")
        self.monitor.close()
        self._log.close()

    def _tick(self) -> None:
        """One step; the next comes also where a dialog keeps this one from returning."""
        dialog = open_dialog()
        if dialog is not None:
            QTimer.singleShot(_ANSWER_MS, self, self._tick)
            self._answer(dialog)
        elif self._acting:  # a dialog is closing; the step that opened it goes on
            QTimer.singleShot(_ANSWER_MS, self, self._tick)
        elif self._doing is not None:
            self._answers = 0
            self._acting = True
            again = QTimer(self, singleShot=True, interval=_ANSWER_MS)
            again.timeout.connect(self._tick)
            again.start()  # in case this step opens a dialog
            try:
                pause = next(self._doing, None)
            except Exception:
                sys.excepthook(*sys.exc_info())
                self._doing = pause = None
                QApplication.exit(1)
            self._acting = False
            if again.isActive():
                again.stop()
                if pause is not None:
                    QTimer.singleShot(pause, self, self._tick)
            again.deleteLater()

    def _answer(self, dialog) -> None:
        rng = Random(f"{self._seed}/{self.steps}/{self._answers}")
        self._answers += 1
        try:
            reported = answer(dialog, rng, self._files, self._calm or self._answers > 20)
        except Exception:
            sys.excepthook(*sys.exc_info())
        else:
            self.log(f"{self.steps}.{self._answers} answer {reported}")

    def _play(self) -> Generator[int, None, None]:
        """All that it does, with the milliseconds to wait after each step."""
        yield from self._wait(
            lambda: windows() and windows()[0].loaded is not None, "a first window"
        )
        yield from self._rest()
        end, next_rest = self._began + self._seconds, time.monotonic() + REST_SECONDS
        while time.monotonic() < end:
            if time.monotonic() > next_rest:
                yield from self._rest()
                next_rest = time.monotonic() + REST_SECONDS
            self.steps += 1
            rng = Random(f"{self._seed}/{self.steps}")
            self._act(rng)
            yield rng.choice([10, 50, 50, 100, 100, 300])
        yield from self._rest()
        QApplication.setQuitOnLastWindowClosed(True)
        windows()[0].commands["quit"].trigger()

    def _act(self, rng: Random) -> None:
        action = rng.choices(list(ACTIONS), ACTIONS.values())[0]
        if not windows():
            self._program.open_beside()
        window = rng.choice(sorted(windows(), key=lambda window: window.winId()))
        name = f"{self.steps} {action.__name__}"
        self.log(name)
        try:
            reported = action(window, rng, self._files)
        except Exception:
            sys.excepthook(*sys.exc_info())
        else:
            self.log(f"{name} {reported}")
        for each in windows():
            self._check_nets(each)

    def _check_nets(self, window: MainWindow) -> None:
        """Look whether each lens lies on the net of its task."""
        session = window.document.session
        lenses = [(run.scene, run.result.state.heights) for run in session.runs]
        if session.heights is not None:
            lenses.append((session.scene, session.heights))
        for scene, heights in lenses:
            nets = nets_of(scene)
            if any(heights[face].shape != net.shape for face, net in nets.items()):
                self.monitor.report(f"a lens on another net than its task: {nets}")

    def _rest(self) -> Generator[int, None, None]:
        """Close what is open but one window with the first example; then measure memory."""
        self._calm = True
        if not windows():
            self._program.open_beside()
        for window in windows()[1:]:
            yield from self._still(window)
            window.close()
        yield from self._wait(lambda: len(windows()) == 1, "the other windows to close")
        (window,) = windows()
        yield from self._wait(lambda: window.loaded is not None, "a window to load")
        yield from self._still(window)
        window.showNormal()
        window.files.new(EXAMPLES[0])
        yield from self._wait(lambda: not window.document.dirty, "the example")
        yield 1500
        yield from self._wait(lambda: len(_threads()) <= _THREADS, "threads to end")
        gc.collect()
        if sys.platform == "linux":
            ctypes.CDLL("libc.so.6").malloc_trim(0)
        self.memory.append(resident_mb())
        self.log(f"rest with {self.memory[-1]:.0f} MB, {len(_threads())} threads")
        if time.monotonic() - self._began < WARM_UP_SECONDS:
            self._warm_mb, self._warm_rests = self.memory[-1], len(self.memory)
        later = self.memory[self._warm_rests :][-RESTS:]
        if len(later) == RESTS and min(later) > self._warm_mb + GROWTH_MB:
            self.monitor.report(f"memory grew from {self._warm_mb:.0f} to {min(later):.0f} MB")
        self._calm = False

    def _still(self, window: MainWindow) -> Generator[int, None, None]:
        """Stop what the window does."""

        def busy() -> bool:
            return isValid(window) and window.loaded is not None and window.loaded.control.busy

        if busy():
            window.loaded.control.runner.stop()
            yield from self._wait(lambda: not busy(), "work to stop")

    def _wait(self, condition, what: str) -> Generator[int, None, None]:
        give_up = time.monotonic() + _PATIENCE
        while not condition():
            if time.monotonic() > give_up:
                self.monitor.dump(f"waited in vain for {what}; threads: {', '.join(_threads())}")
                return
            yield 100


def _scenes() -> str:
    loaded = [window for window in windows() if window.loaded is not None]
    return "\n".join(json.dumps(each.document.session.scene.to_data()) for each in loaded)


def _threads() -> list[str]:
    # Python keeps an entry for good for each QThread that it meets.
    running = threading.enumerate()
    return [each.name for each in running if not isinstance(each, threading._DummyThread)]


def main() -> int:
    """Play; exit status 0 if nothing went wrong."""
    parser = argparse.ArgumentParser("tests.soak.monkey", description="Random actions on a window.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--after", type=int, default=0, help="leave out so many steps")
    parser.add_argument("--seconds", type=float, default=120.0)
    options = parser.parse_args()
    folder = options.folder.absolute()
    _furnish(folder)
    os.environ["XDG_CONFIG_HOME"] = str(folder / "settings")
    played: list[Monkey] = []
    begun: list[Windows] = []
    begin, run = Windows.__init__, QApplication.exec

    # Not found by `gc.get_objects`: it takes hold of tuples that threads are building, which fail.
    def keep(program: Windows, *named) -> None:
        begin(program, *named)
        begun.append(program)

    def play() -> int:
        monkey = Monkey(folder, options.seed, options.seconds, *begun, options.after)
        played.append(monkey)
        QTimer.singleShot(0, monkey, monkey.begin)
        return run()

    Windows.__init__, QApplication.exec = keep, staticmethod(play)
    status = app.main([])
    (monkey,) = played
    monkey.close()
    report = {
        "seed": options.seed,
        "steps": monkey.steps,
        "problems": monkey.monitor.problems,
        "longest_s": round(monkey.monitor.longest, 2),
        "memory_mb": [round(mb) for mb in monkey.memory],
    }
    print(json.dumps(report))
    return status or int(bool(monkey.monitor.problems))


def _furnish(folder: Path) -> None:
    """Have files to open and to drop, good ones and bad ones."""
    files = folder / "files"
    if files.is_dir():
        return
    files.mkdir(parents=True)
    small = {
        "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [12, 12]},
        "source": {"kind": "point", "position": [0, 0, -5], "rays": 2000},
        "screen": {"z": 5, "half_width": [1, 1], "pixels": [32, 32]},
        "target": {"builtin": "ball"},
        "run": {"iterations": 200},
    }
    (files / "small.json").write_text(json.dumps(small))
    for number in TRAINS:
        train = TrainDraw(1, number).scene() | {"run": {"iterations": 50}}
        (files / f"train-{number}.json").write_text(json.dumps(train))
    (files / "bowl.npy").write_bytes(TrainDraw.files["bowl.npy"])
    (files / "not-a-scene.json").write_text("{}")
    (files / "broken.freeform").write_bytes(b"PK\3\4 and nothing else")
    picture = resources.path("targets", "flame-256.png")
    (files / "picture.png").write_bytes(picture.read_bytes())
    (files / "broken.png").write_bytes(b"no picture")


if __name__ == "__main__":
    sys.exit(main())
