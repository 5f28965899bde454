"""Scenes that tests start from."""

from typing import Any

import numpy as np
import pytest
from hypothesis import settings

from tests.scenes import changed
from workbench.scene import Scene

# The first example of a test pays for imports and caches. The same examples each time: what passed
# here passes elsewhere. New ones are tried by `pytest --hypothesis-profile explore`.
settings.register_profile("default", deadline=None, derandomize=True)
settings.register_profile("explore", deadline=None)
settings.load_profile("default")


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
