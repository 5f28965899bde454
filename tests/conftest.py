"""Scenes that tests start from, and how many processes run them."""

import gc
import os
import shutil
import signal
import subprocess
from pathlib import Path
from typing import Any

from workbench.process import calm_library_threads

# As the program does, before numpy is loaded: threads of OpenBLAS that wait for each other took
# three quarters of the processor's time of a first design where others worked on the same cores.
calm_library_threads()

import numpy as np  # noqa: E402
import pytest  # noqa: E402
from hypothesis import settings  # noqa: E402
from xdist.scheduler import LoadScopeScheduling  # noqa: E402

from tests.scenes import changed  # noqa: E402
from workbench.scene import Scene  # noqa: E402

# The first example of a test pays for imports and caches. The same examples each time: what passed
# here passes elsewhere. New ones are tried by `pytest --hypothesis-profile explore`.
settings.register_profile("default", deadline=None, derandomize=True)
settings.register_profile("explore", deadline=None)
settings.load_profile("default")


_WHOLE = Path(__file__).parent
# Each process takes a gigabyte or more, and its kernels take all cores.
_MOST_PROCESSES = 4
_SHARED = ("not slow and not full", "full")  # marks of tests that several processes share
_XVFB = shutil.which("Xvfb")
_WINDOW = "tests/ui/"


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers(config):
    """Return the number of processes: several for all tests, one for a part and for slow tests."""
    parts = [part for part in config.args if Path(part).resolve() not in (_WHOLE, _WHOLE.parent)]
    if parts or config.option.keyword or config.option.markexpr not in _SHARED:
        return 0
    # One more than there are cores: tests of the window wait for more than half of their time.
    return min((os.cpu_count() or 1) + 1, _MOST_PROCESSES)


@pytest.hookimpl(wrapper=True)
def pytest_collection():
    """Search no garbage among what imports make and the tests themselves: it stays to the end.

    That took more than a third of the processor's time of collecting all tests.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config, items):
    """Spread files of the window, whose tests wait, among files whose tests compute.

    Those of no folder take longest, ten seconds and more; others end at the same time after them.
    """
    if not (_XVFB and hasattr(config, "workerinput")):
        return
    files = {}
    for item in items:
        files.setdefault(_file_of(item.nodeid), []).append(item)
    places = {}
    for of_window in (True, False):
        group = [file for file in files if file.startswith(_WINDOW) == of_window]
        group.sort(key=lambda file: file.count("/"))
        places |= {file: place / len(group) for place, file in enumerate(group)}
    items[:] = [item for file in sorted(files, key=places.get) for item in files[file]]


class _Scheduling(LoadScopeScheduling):
    """Tests of a file stay in one process, in their order.

    So do all of the window where processes share a screen, and thereby its keyboard.
    """

    def _split_scope(self, nodeid):
        file = _file_of(nodeid)
        return "window" if file.startswith(_WINDOW) and not _XVFB else file


def _file_of(nodeid):
    return nodeid.split("::")[0]


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    config.option.loadscopereorder = not _XVFB
    return _Scheduling(config, log)


def pytest_configure(config):
    """Give each of several processes a screen of its own."""
    if _XVFB and hasattr(config, "workerinput"):
        config.add_cleanup(_new_screen())


def _new_screen():
    """Begin a virtual screen, where windows of this process come to be; gives what ends it."""
    here, there = os.pipe()
    server = subprocess.Popen(
        [_XVFB, "-displayfd", str(there), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"],
        pass_fds=[there],
        stderr=subprocess.DEVNULL,
    )
    os.close(there)
    with open(here) as number:
        os.environ["DISPLAY"] = f":{number.readline().strip()}"

    def end():
        server.terminate()
        server.wait()

    return end


@pytest.fixture(autouse=True)
def state_folder(tmp_path_factory, monkeypatch):
    """Errors that a test provokes are not written down among those of the user."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.getbasetemp() / "state"))


@pytest.fixture
def usual_signals():
    """Signals that end a program do so, whatever the surroundings ignore, as nohup does."""
    usual = {"SIGINT": signal.default_int_handler, "SIGTERM": signal.SIG_DFL}
    usual["SIGHUP"] = signal.SIG_DFL
    before = {
        number: signal.signal(number, handler)
        for name, handler in usual.items()
        if (number := getattr(signal, name, None)) is not None
    }
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


@pytest.fixture
def scene_data() -> dict[str, Any]:
    """A small scene as plain data, free to change."""
    return changed({})


@pytest.fixture
def make_scene(scene_data: dict[str, Any]) -> Any:
    """Builds the small scene with some fields changed: ``make_scene({"screen.z": 7})``."""

    def make(changes: dict[str, Any] | None = None) -> Scene:
        return Scene.from_data(changed(changes or {}, scene_data))

    return make


@pytest.fixture
def fewer_rays(monkeypatch):
    """Checks begin with fewer cells and fewer random rays than those of users."""
    monkeypatch.setattr("workbench.analysis.cells.image._BEGIN", 1 << 18)
    monkeypatch.setattr("workbench.analysis.scatter._BEGIN", 1 << 18)


@pytest.fixture
def few_plans(monkeypatch):
    """Plans of a shop compare fewer widths of polishing and steps of milling."""
    monkeypatch.setattr("workbench.analysis.making.plan._WIDTHS", (0.0, 0.6))
    monkeypatch.setattr("workbench.analysis.making.plan._HALVINGS", 3)


@pytest.fixture
def upright_parts(monkeypatch):
    """Measured parts lie as the face does: their alignment tries few placements."""
    quarters = np.radians([0, 90, 180, 270])
    monkeypatch.setattr("workbench.analysis.inspection.starts._ANGLES", quarters)
    monkeypatch.setattr("workbench.analysis.inspection.alignment._STARTS", 2)


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(7)
