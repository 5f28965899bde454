"""Sources of files that tests make, and what their light comes to behind a plate."""

from pathlib import Path
from typing import Any

import numpy as np

from tests.measured.photometry.files import GAMMA, candela, ies
from tests.measured.rays.files import tm25

DISTANCE, THICKNESS, SCREEN = 2.0, 0.5, 5.0

PLATE: dict[str, Any] = {
    "lens.base": {"shape": "flat", "height": THICKNESS},
    "lens.half_width": [2.0, 2.0],
    "lens.control_points": [4, 4],
    "screen.z": SCREEN,
    "screen.half_width": [2.0, 2.0],
    "screen.pixels": [40, 40],
}


def downlight(folder: Path, power: float = 3.0) -> dict[str, Any]:
    """A source whose intensity falls with a power of the cosine."""
    gamma = np.linspace(0, 90, 361)
    path = folder / "downlight.ies"
    path.write_text(ies([0], gamma, 1000 * np.cos(np.radians(gamma))[None] ** power))
    return {"kind": "photometric", "file": str(path), "position": [0.0, 0.0, -DISTANCE]}


def crooked_lamp(folder: Path) -> dict[str, Any]:
    """A source without any symmetry, turned about all axes."""
    c = np.linspace(0.0, 360.0, 25)
    path = folder / "crooked.ies"
    path.write_text(ies(c, GAMMA, candela(c, GAMMA)))
    source = {"kind": "photometric", "file": str(path), "position": [0.3, -0.2, -3.0]}
    return source | {"rotation": [10.0, -20.0, 30.0]}


def behind_plate(radius: np.ndarray, power: float = 3.0) -> np.ndarray:
    """Flux per area behind the plate, at distances from the axis, of all light of the downlight.

    A ray at an angle a, b within the plate, comes to r = (d + s) tan a + t tan b, and illuminance
    is I(a) T(a) sin a da / (r dr).
    """
    n = 1.5
    a = np.linspace(1e-6, 1.2, 20_001)
    b = np.arcsin(np.sin(a) / n)
    way = DISTANCE + SCREEN - THICKNESS
    r = way * np.tan(a) + THICKNESS * np.tan(b)
    slope = way / np.cos(a) ** 2 + THICKNESS * np.cos(a) / (n * np.cos(b) ** 3)
    normal = ((n - 1) / (n + 1)) ** 2
    into = (1 - normal) * (1 - (1 - np.cos(a)) ** 5)
    out = 1 - (normal + (1 - normal) * (1 - np.cos(a)) ** 5)
    total = 2 * np.pi / (power + 1)
    lit = np.cos(a) ** power * into * out * np.sin(a) / (r * slope) / total
    return np.interp(radius, r, lit)


def led(folder: Path, count: int = 200_000) -> dict[str, Any]:
    """A source of rays of an LED of 0.5 × 0.3 cm, turned about z, in millimetres."""
    generator = np.random.default_rng(5)
    sine2, around = generator.random((2, count)) * [[1.0], [2 * np.pi]]
    table = np.zeros((count, 7), np.float32)
    table[:, 0] = generator.uniform(-2.5, 2.5, count)
    table[:, 1] = generator.uniform(-1.5, 1.5, count)
    table[:, 3:5] = (np.sqrt(sine2) * [np.cos(around), np.sin(around)]).T
    table[:, 5] = np.sqrt(1 - sine2)
    table[:, 6] = 1.0
    path = folder / "led.tm25ray"
    path.write_bytes(tm25(table))
    source = {"kind": "ray_file", "file": str(path), "position": [0.1, 0.0, -3.0]}
    return source | {"rotation": [0.0, 0.0, 30.0]}
