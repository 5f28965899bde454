"""Scenes that tests start from, and how many processes run them."""

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import settings
from xdist.scheduler import LoadScopeScheduling

from tests.scenes import changed
from workbench.scene import Scene

# The first example of a test pays for imports and caches. The same examples each time: what passed
# here passes elsewhere. New ones are tried by `pytest --hypothesis-profile explore`.
settings.register_profile("default", deadline=None, derandomize=True)
settings.register_profile("explore", deadline=None)
settings.load_profile("default")


_WHOLE = Path(__file__).parent
# Half of the time is that of the window, whose tests run in one process: they share the keyboard
# of one screen. Each process takes a gigabyte or more, and its kernels take all cores.
_MOST_PROCESSES = 3


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers(config):
    """Processes for the whole suite; parts of it, and slow tests, have one."""
    parts = [part for part in config.args if Path(part).resolve() not in (_WHOLE, _WHOLE.parent)]
    if parts or config.option.keyword or config.option.markexpr != "not slow":
        return 0
    return min(os.cpu_count() or 1, _MOST_PROCESSES)


class _Scheduling(LoadScopeScheduling):
    """Tests of a file stay in one process, and so do all of the window, the first to begin."""

    def _split_scope(self, nodeid):
        file = nodeid.split("::")[0]
        return "window" if file.startswith("tests/ui/") else file


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    return _Scheduling(config, log)


@pytest.fixture(autouse=True)
def state_folder(tmp_path_factory, monkeypatch):
    """Errors that a test provokes are not written down among those of the user."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.getbasetemp() / "state"))


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
def rng() -> np.random.Generator:
    return np.random.default_rng(7)
