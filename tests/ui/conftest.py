"""Every test of the window leaves nothing behind: no thread, timer, widget or VTK object."""

import gc
import os
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent, Qt, QThread, QTimer
from PySide6.QtWidgets import QApplication
from shiboken6 import isValid

from workbench.design.snapshot import History, Snapshot
from workbench.files.session import Session
from workbench.optics.ledger import Ledger
from workbench.targets import load_target

if sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

_SETTLING = 4  # rounds of events that may still be under way
_VTK = (
    ("vtkmodules.vtkRenderingCore", "vtkRenderWindow"),
    ("vtkmodules.vtkRenderingCore", "vtkRenderWindowInteractor"),
    ("pyvista.plotting.plotter", "BasePlotter"),
)


def living():
    """Everything that a test must not leave behind, by id, with a name for each."""
    found = {id(w): f"top-level widget {w!r}" for w in QApplication.topLevelWidgets()}
    for thread in threading.enumerate():
        # Python makes up a dummy for every QThread that it meets; those are told below.
        if not isinstance(thread, threading._DummyThread):
            found[id(thread)] = f"thread {thread.name}"
    scene_parts = tuple(
        getattr(sys.modules[module], name) for module, name in _VTK if module in sys.modules
    )
    application = QCoreApplication.instance()
    window_thread = application.thread() if application else None
    # isinstance would wake lazy proxies; each of the few kinds is looked at once.
    sought = (QThread, QTimer, *scene_parts)
    kinds = {}
    for thing in gc.get_objects():
        kind = type(thing)
        if kind not in kinds:
            kinds[kind] = issubclass(kind, sought)
        if not kinds[kind]:
            continue
        if issubclass(kind, QThread):
            if isValid(thing) and thing.isRunning() and thing != window_thread:
                found[id(thing)] = f"running {thing!r}"
        elif issubclass(kind, QTimer):
            if isValid(thing) and thing.isActive():
                found[id(thing)] = f"active {thing!r} of {thing.parent()!r}"
        else:
            found[id(thing)] = f"VTK's {kind.__name__}"
    return found


def left_behind(before):
    """Names of what lives now and did not before, after giving it a chance to go."""
    application = QApplication.instance()
    for _ in range(_SETTLING):
        if application is not None:
            application.processEvents()
            QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        found = {key: name for key, name in living().items() if key not in before}
        if not found:
            return []
        gc.collect()
    return sorted(found.values())


@pytest.fixture(scope="session", autouse=True)
def libraries_stay():
    """What imports have made lives for good; it is not searched again after every test."""
    if not gc.get_freeze_count():  # a session within a test is to leave nothing
        gc.collect()
        gc.freeze()


@pytest.fixture(scope="session")
def kernels():
    """Kernels compiled beforehand: no run waits a minute for them."""
    from workbench.optics.kernels.ready import compile_all

    compile_all()


@pytest.fixture(autouse=True)
def nothing_left_behind():
    """Fail a test that leaves something behind."""
    before = living()
    yield
    left = left_behind(before)
    if left:
        pytest.fail("left behind: " + "; ".join(left), pytrace=False)


@pytest.fixture
def leaks():
    """The two halves of the check, for tests of the check itself."""
    return living, left_behind


@pytest.fixture
def display(qapp):
    """A display that OpenGL widgets can draw on."""
    if qapp.platformName() in ("offscreen", "minimal"):
        pytest.skip("3D widgets draw nothing without a display; run under xvfb-run")


@pytest.fixture
def session(make_scene):
    """A small design without a result."""
    scene = make_scene()
    return Session(scene, load_target(scene, Path.cwd()))


@pytest.fixture
def snapshots(session):
    """Makes snapshots of a lens that sinks evenly and gets better all the time."""

    def make(iteration, iterations=10):
        scene = session.scene
        n_x, n_y = scene.screen.pixels
        return Snapshot(
            iteration=iteration,
            iterations=iterations,
            loss=1.0 / (1 + iteration),
            control_points=np.full(scene.lens.control_points, 0.5 - 0.001 * iteration),
            irradiance=np.full((n_y, n_x), 0.25),
            ledger=Ledger(1.0, 0.92, 0.0, 0.0, 0.0, 0.0, 0.04, 0.04),
            seconds=0.1 * iteration,
            best=True,
        )

    return make


@pytest.fixture
def history(snapshots):
    """Gathers so many iterations."""

    def make(iterations):
        gathered = History()
        for iteration in range(iterations + 1):
            gathered.add(snapshots(iteration))
        return gathered

    return make


@pytest.fixture
def as_run(snapshots):
    """A generator function that stands in for the engine's, of so many iterations."""

    def make(iterations, pause=0.0):
        def run(scene, target, start=None, locked=None):
            for iteration in range(iterations + 1):
                time.sleep(pause)
                yield snapshots(iteration, iterations)

        return run

    return make


@pytest.fixture
def as_seen_run(snapshots):
    """A run like `as_run`'s of which a runner's listeners see every snapshot, however slow."""

    def make(runner, iterations, snapshots=snapshots):
        seen = []
        runner.frame_ready.connect(lambda frame: seen.append(frame.snapshot))

        def run(scene, target, start=None, locked=None):
            for iteration in range(iterations + 1):
                snapshot = snapshots(iteration, iterations)
                yield snapshot
                give_up = time.monotonic() + 30
                while not any(each is snapshot for each in seen):
                    assert time.monotonic() < give_up, "nobody looks"
                    time.sleep(0.002)

        return run

    return make


class LatencyProbe:
    """A 5 ms timer that notes how long the event loop lets it wait."""

    def __init__(self):
        self._last = None
        self.gaps_ms = []
        self._timer = QTimer(interval=5, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)

    def start(self):
        self._last = None
        self._timer.start()

    def stop(self):
        self._timer.stop()

    def report(self, name):
        gaps = np.array(self.gaps_ms)
        p95, most = np.quantile(gaps, 0.95), gaps.max()
        return f"{name}: p95 {p95:.1f} ms, max {most:.0f} ms over {gaps.size} ticks"

    def _tick(self):
        now = time.perf_counter()
        if self._last is not None:
            self.gaps_ms.append(1000 * (now - self._last))
        self._last = now


@pytest.fixture
def latency_probe(qapp):
    """Measures how long the event loop is held up between ``start`` and ``stop``."""
    probe = LatencyProbe()
    yield probe
    probe.stop()
