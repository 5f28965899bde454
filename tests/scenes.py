"""The small scene that most tests start from."""

import copy
from typing import Any

SMALL: dict[str, Any] = {
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


def changed(changes: dict[str, Any], data: dict[str, Any] = SMALL) -> dict[str, Any]:
    """A copy of plain data with some fields changed: ``{"screen.z": 7}``."""
    data = copy.deepcopy(data)
    for path, value in changes.items():
        *parents, last = path.split(".")
        part = data
        for parent in parents:
            part = part[parent]
        part[last] = value
    return data
