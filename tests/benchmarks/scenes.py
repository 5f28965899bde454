"""Small scenes of all kinds of sources, optics and receivers, each designed in seconds."""

import json
from pathlib import Path
from typing import Any

import numpy as np

import resources
from tests.measured.photometry.files import GAMMA, candela, ldt
from tests.measured.rays.files import rays, tm25
from tests.scenes import changed

LENS: dict[str, Any] = {
    "format": "freeform-scene",
    "version": 2,
    "unit": "mm",
    "lens": {
        "half_width": [10, 10],
        "refractive_index": 1.49,
        "control_points": [40, 40],
        "base": {"shape": "flat", "height": 5},
        "min_thickness": 0.5,
    },
    "source": {"kind": "collimated", "rays": [256, 256]},
    "screen": {"z": 60, "half_width": [12, 12], "pixels": [96, 96]},
    "target": {"builtin": "ball"},
    "run": {"method": "auto", "iterations": 40, "seed": 0},
}
_MIRROR = {
    "lens": None,
    "mirror": {"half_width": [10, 10], "control_points": [40, 40], "reflectance": 0.9},
}
_PHOTO = {"image": str(resources.path("targets", "photo-256.png"))}
_POINT = {"kind": "point", "position": [0, 0, -50]}
_RECTANGLE = {"builtin": "rectangle", "width": 0.8, "height": 0.8}
_LDT, _RAYS = "lamp.ldt", "led.tm25ray"


def _screen(z: float, half_width: list[float], pixels: int = 64, **others: Any) -> dict[str, Any]:
    return {"z": z, "half_width": half_width, "pixels": [pixels, pixels]} | others


def _far_field(half_angle: float, center: list[float]) -> dict[str, Any]:
    return {
        "screen": None,
        "far_field": {"half_angle": [half_angle] * 2, "center": center, "pixels": [96, 96]},
    }


def _led(distance: float, half_width: float) -> dict[str, Any]:
    return {"kind": "area", "center": [0, 0, -distance], "half_width": [half_width] * 2}


_CHANGES: dict[str, dict[str, Any]] = {
    "flame": {
        "lens.control_points": [48, 48],
        "screen.pixels": [256, 256],
        "target": {"builtin": "flame"},
    },
    "words": {
        "lens.control_points": [48, 48],
        "screen.pixels": [128, 128],
        "target": {"builtin": "text", "text": "Light\nhere"},
    },
    "sun": {"source.angular_diameter": 0.533, "screen": _screen(50, [12, 12]), "target": _PHOTO},
    "gaussian-beam": {
        "source.profile": {"kind": "gaussian", "radius": 4},
        "target": {"builtin": "tophat"},
    },
    "tilted-collimated": {"source.direction": [8, -5]},
    "point": {"source": _POINT, "target": _PHOTO},
    "grid-of-points": {
        "source": {"kind": "grid", "center": [0, 0, -50], "half_width": [1, 1], "points": [5, 5]},
        "target": {"builtin": "flame"},
    },
    "led-near": {
        "lens.half_width": [30, 30],
        "lens.control_points": [24, 24],
        "source": _led(10, 1),
        "screen": _screen(110, [140, 140]),
        "target": _RECTANGLE,
    },
    "led-far": {
        "lens.half_width": [20, 20],
        "source": _led(30, 0.75),
        "screen": _screen(200, [80, 80]),
        "target": {"builtin": "text", "text": "F"},
    },
    "ies": {
        "lens.half_width": [15, 15],
        "source": {
            "kind": "photometric",
            "file": str(resources.path("lights", "led.ies")),
            "position": [0, 0, -20],
        },
        "screen": _screen(150, [100, 100], 96),
        "target": _PHOTO,
    },
    "ldt-rotated": {
        "lens.half_width": [15, 15],
        "source": {
            "kind": "photometric",
            "file": _LDT,
            "position": [2, -1, -25],
            "rotation": [10, -15, 30],
        },
        "screen": _screen(150, [90, 90], 96),
        "target": {"builtin": "tophat"},
    },
    "ray-file": {
        "lens.half_width": [15, 15],
        "lens.control_points": [24, 24],
        "source": {"kind": "ray_file", "file": _RAYS, "position": [0, 0, -20]},
        "screen": _screen(150, [100, 100]),
        "target": _RECTANGLE,
    },
    "mirror-collimated": {
        **_MIRROR,
        "screen": _screen(-60, [15, 15], 96, center=[45, 0], tilt=[0, -35]),
    },
    "mirror-tilted-far-field": {
        **_MIRROR,
        **_far_field(8, [30, 0]),
        "source.direction": [0, 30],
        "target": _PHOTO,
    },
    "two-faces-near-led": {
        "lens": {
            "half_width": [10, 10],
            "outline": "ellipse",
            "entrance": {"shape": "freeform", "height_range": [-4, 1]},
            "refractive_index": 1.49,
            "control_points": [20, 20],
            "base": {"shape": "flat", "height": 3},
            "max_thickness": 18,
        },
        "source": _led(7, 1),
        "screen": _screen(200, [140, 140]),
        "target": _RECTANGLE,
    },
    # The scene has no plane exit face: this one can hardly move.
    "freeform-entrance-alone": {
        "lens.entrance": {"shape": "freeform", "control_points": [40, 40]},
        "lens.degree": [1, 1],
        "lens.control_points": [2, 2],
        "lens.height_range": [-1e-3, 1e-3],
        "target": {"builtin": "tophat"},
    },
    "elliptical-outline": {
        "lens.half_width": [12, 8],
        "lens.outline": "ellipse",
        "target": {"builtin": "ring"},
    },
    "far-field": {**_far_field(8, [0, 0]), "target": {"builtin": "flame"}},
    "tilted-screen": {
        "source": _POINT,
        "screen": _screen(80, [20, 20], 96, center=[0, 15], tilt=[25, 0]),
    },
    "absorption-and-coating": {
        "lens.absorption": 0.01,
        "lens.coating": [0.005, 0.01],
        "target": _PHOTO,
    },
    "paper-inch": {
        "unit": "inch",
        "lens.half_width": [1, 1],
        "lens.control_points": [32, 32],
        "lens.base": {"shape": "flat", "height": 0.5},
        "lens.height_range": [-0.3, 0.3],
        "lens.min_thickness": 0.05,
        "screen": _screen(5, [1, 1]),
        "filter": {"kind": "gaussian", "size": [5, 5], "alpha": 0.5},
        "target": {"builtin": "tophat"},
        "run": {"method": "paper", "iterations": 40, "seed": 0},
    },
}

SCENES: dict[str, dict[str, Any]] = {
    name: changed(changes, LENS) for name, changes in _CHANGES.items()
}
"""Scenes by name, as plain data."""


def write_scene(name: str, folder: Path) -> Path:
    """Write a scene file and the lamp files that it names into a folder.

    Parameters
    ----------
    name : str
        One of `SCENES`.
    folder : path
        Where to.

    Returns
    -------
    Path
        The scene file.
    """
    c = np.linspace(0.0, 345.0, 24)
    lamps = {
        _LDT: lambda: ldt(0, c.tolist(), GAMMA.tolist(), candela(c, GAMMA)).encode(),
        _RAYS: lambda: tm25(rays(100_000)),
    }
    lamp = SCENES[name]["source"].get("file")
    if lamp in lamps:
        (folder / lamp).write_bytes(lamps[lamp]())
    scene = folder / f"{name}.json"
    scene.write_text(json.dumps(SCENES[name]), "utf-8")
    return scene
