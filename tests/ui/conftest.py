"""What tests of the window share; each of them leaves nothing behind."""

import dataclasses
import gc
import os
import sys
import time
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QSettings
from PySide6.QtGui import QCursor

from tests.accounts import account_of
from tests.ui.leftovers import left_behind, living
from ui.background import GarbageCollector
from ui.document.document import Document
from ui.document.frame import make_frame
from ui.main_window import MainWindow
from ui.panels.forms import Forms
from ui.run import worker
from workbench.design.lens_state import LensState
from workbench.design.snapshot import History, Snapshot
from workbench.files.session import Session
from workbench.geometry.faces import FaceArrays
from workbench.targets import load_target

if sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

_PATIENCE_MS = 30_000


_WITHIN_A_TEST = gc.get_freeze_count() > 0  # a session of its own, which is to leave nothing
_modules_kept = 0


def keep_what_imports_made():
    """What imports have made lives for good; it is not searched again after every test."""
    global _modules_kept
    if not _WITHIN_A_TEST and len(sys.modules) > _modules_kept:
        gc.collect()
        gc.freeze()
        _modules_kept = len(sys.modules)


@pytest.fixture(scope="module", autouse=True)
def garbage_in_the_thread_of_the_window(qapp):
    """As in the program: else a run's thread deletes the Qt objects of tests that are over.

    Tests of other packages, which run in between, have no window whose thread would do it.
    """
    collector = GarbageCollector(qapp)
    yield
    collector.close()
    collector.deleteLater()


@pytest.fixture(scope="session")
def kernels():
    """Kernels compiled beforehand: no run waits a minute for them."""
    from workbench.optics.ready import compile_all

    compile_all()


@pytest.fixture(autouse=True)
def nothing_left_behind():
    """Fail a test that leaves something behind."""
    keep_what_imports_made()
    before = living()
    yield
    left = left_behind(before)
    if left:
        pytest.fail("left behind: " + "; ".join(left), pytrace=False)


@pytest.fixture
def qtbot(qtbot):
    """Waits longer than of itself: the machine may be busy with something else."""
    for name in ("waitUntil", "waitSignal", "waitExposed", "waitActive"):
        setattr(qtbot, name, partial(getattr(qtbot, name), timeout=_PATIENCE_MS))
    return qtbot


@pytest.fixture(autouse=True)
def camera_without_flights(monkeypatch):
    """The camera of the 3D view is at once where it was sent."""
    monkeypatch.setattr("ui.views.flight.flight_ms", lambda view: 0)


@pytest.fixture
def display(qapp):
    """A display that OpenGL widgets can draw on."""
    if qapp.platformName() in ("offscreen", "minimal"):
        pytest.skip("3D widgets draw nothing without a display; run under xvfb-run")


@pytest.fixture
def application(qapp):
    """The application, which looks as before after the test."""
    sheet, palette, style = qapp.styleSheet(), qapp.palette(), qapp.style().name()
    yield qapp
    qapp.setStyleSheet(sheet)
    qapp.setPalette(palette)
    qapp.setStyle(style)


@pytest.fixture
def make_session(make_scene):
    """Makes designs of the small scene with some fields changed."""

    def make(changes=None):
        scene = make_scene(changes)
        return Session(scene, load_target(scene, Path.cwd()))

    return make


@pytest.fixture
def session(make_session):
    """A small design without a result."""
    return make_session()


@pytest.fixture
def snapshots(session):
    """Makes snapshots of a lens that sinks evenly and gets better all the time."""

    def make(iteration, iterations=10):
        scene = session.scene
        n_x, n_y = scene.receiver.pixels
        return Snapshot(
            LensState(
                loss=1.0 / (1 + iteration),
                heights=FaceArrays(
                    {"lens.back": np.full(scene.optic.net_shape, 0.5 - 0.001 * iteration)}
                ),
                irradiance=np.full((n_y, n_x), 0.25),
                account=account_of(1.0, 0.92, 0.0, 0.0, 0.0, 0.0, 0.04, 0.04),
            ),
            iteration=iteration,
            iterations=iterations,
            seconds=0.1 * iteration,
            merit=1.0 / (1 + iteration),
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
def designed(session, history):
    """The small design with a lens: a flat one."""
    return dataclasses.replace(session, result=history(3).result())


@pytest.fixture
def frames(session, snapshots, history):
    """Makes frames of an iteration, with something of its lens's state changed."""

    def make(iteration, session=session, **changes):
        snapshot = snapshots(iteration)
        state = dataclasses.replace(snapshot.state, **changes)
        snapshot = dataclasses.replace(snapshot, state=state)
        return make_frame(session, snapshot, history(iteration))

    return make


@pytest.fixture
def as_run(snapshots):
    """A generator function that stands in for the engine's, of so many iterations."""

    def make(iterations, pause=0.0):
        def run(scene, target, start=None, locked=None):
            for iteration in range(iterations + 1):
                time.sleep(pause)
                yield snapshots(iteration, iterations)
            return "all iterations are done"

        return run

    return make


@pytest.fixture
def as_seen_run(snapshots, monkeypatch):
    """A run like `as_run`'s of which a runner's listeners see every snapshot, however slow."""
    monkeypatch.setattr(worker, "_FRAME_S", 0.0)

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
            return "all iterations are done"

        return run

    return make


@pytest.fixture
def show(qtbot):
    """Shows a widget of some size, away from the pointer; it goes with the test."""

    def show(widget, width, height):
        qtbot.addWidget(widget)
        QCursor.setPos(0, 0)
        widget.setGeometry(40, 40, width, height)
        with qtbot.waitExposed(widget):
            widget.show()
        return widget

    return show


def activate(widget, qtbot):
    with qtbot.waitActive(widget):
        widget.show()
        widget.activateWindow()
    return widget


@pytest.fixture
def settings(tmp_path):
    """What windows remember: nothing as yet, but that edits are not followed."""
    settings = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    settings.setValue("run/follow", False)
    return settings


@pytest.fixture
def open_window(session, settings, qtbot):
    """Opens windows, active, without runner and views as yet; they close with the test."""

    def make(session=session, name="small"):
        window = MainWindow(Document(session, name), settings)
        qtbot.addWidget(window, before_close_func=MainWindow.discard_and_close)
        return activate(window, qtbot)

    return make


@pytest.fixture
def window(open_window):
    return open_window()


@pytest.fixture
def document(qapp, session):
    document = Document(session, "small")
    yield document
    document.deleteLater()


@pytest.fixture
def open_forms(qtbot):
    """Opens the forms of a document, active."""

    def make(document):
        forms = Forms(document)
        qtbot.addWidget(forms)
        forms.resize(330, 900)
        return activate(forms, qtbot)

    return make


@pytest.fixture
def forms(open_forms, document):
    return open_forms(document)
