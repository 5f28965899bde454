"""Scenes that tests start from."""

import copy
from typing import Any

import numpy as np
import pytest
from hypothesis import settings

from workbench.scene import Scene

# The first example of a test pays for imports and caches.
settings.register_profile("default", deadline=None)
settings.load_profile("default")

_DATA: dict[str, Any] = {
    "format": "freeform-scene",
    "version": 1,
    "unit": "cm",
    "lens": {
        "half_width": [1.0, 1.0],
        "entrance_z": 0.0,
        "refractive_index": 1.5,
        "degree": [3, 3],
        "control_points": [12, 10],
        "base": {"shape": "flat", "height": 0.5},
        "height_range": [-0.3, 0.3],
        "min_thickness": 0.05,
    },
    "source": {"kind": "collimated", "rays": [64, 64]},
    "screen": {"z": 5.0, "half_width": [1.0, 1.0], "pixels": [32, 32]},
    "filter": {"kind": "gaussian", "size": [3, 3], "alpha": 1.0},
    "target": {"builtin": "tophat"},
    "run": {"method": "auto", "iterations": 10, "seed": 0},
}


@pytest.fixture
def scene_data() -> dict[str, Any]:
    """A small scene as plain data, free to change."""
    return copy.deepcopy(_DATA)


@pytest.fixture
def make_scene(scene_data: dict[str, Any]) -> Any:
    """Builds the small scene with some fields changed: ``make_scene({"screen.z": 7})``."""

    def make(changes: dict[str, Any] | None = None) -> Scene:
        data = copy.deepcopy(scene_data)
        for path, value in (changes or {}).items():
            *parents, last = path.split(".")
            part = data
            for parent in parents:
                part = part[parent]
            part[last] = value
        return Scene.from_data(data)

    return make


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(7)
