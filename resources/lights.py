"""Example scenes with lights as there are: the sun, LEDs, a laser beam; and the rays of an LED."""

from typing import Any

import numpy as np
import numpy.typing as npt

from resources.parts import bspline, in_mm, lens, screen, shown
from workbench.measured.rays.tm25 import HEADER, VERSION

_RAYS = 9_000
_CHIP = 1.0  # mm a side
_DATE = b"2025-01-01T00:00:00+00:00"


def _scene(
    half_width: list[float],
    thickness: float,
    source: dict[str, Any],
    receiver: dict[str, Any],
    image: str,
    material: str = "PMMA",
    viewer: str | None = "front",
) -> dict[str, Any]:
    """Scene with a flat lens of a plastic, whose light is viewed on a wall."""
    back = bspline([64, 64] if source["kind"] == "area" else "auto")
    return in_mm(
        source | {"wavelength_um": 0.55},
        lens(half_width, thickness, material, back),
        shown(image, receiver, viewed_from=viewer),
    )


SCENES = {
    "sun-plate": _scene(
        [50, 50],
        8,
        {"kind": "collimated", "angular_diameter": 0.533},
        screen(500, [100, 100]),
        "photo-256",
    ),
    "phone-torch": _scene(
        [20, 20],
        8,
        {"kind": "area", "position": [0, 0, -30], "half_width": [0.75, 0.75]},
        screen(200, [80, 80]),
        "letter-256",
    ),
    # Light has to be bent to 68 degrees on a single face: wide lenses bend it less.
    "led-rectangle": _scene(
        [60, 30],
        6,
        {"kind": "area", "position": [0, 0, -10], "half_width": [1, 1]},
        screen(106, [290, 140], [145, 70]),
        "rectangle-125x50",
        "PC",
    ),
    "beam-shaper": _scene(
        [8, 8],
        4,
        {"kind": "collimated", "profile": {"kind": "gaussian", "radius": 3}},
        screen(200, [10, 10]),
        "tophat-256",
        viewer=None,
    ),
    "measured-led": _scene(
        [15, 15],
        6,
        {"kind": "ray_file", "file": "../lights/led.tm25ray", "position": [0, 0, -15]},
        screen(150, [100, 100], [40, 40]),
        "rectangle-20x20",
    ),
    # Light turned by 17 degrees and more: blue and red land 1.4 mm apart.
    "white-light": in_mm(
        {"kind": "collimated", "spectrum": [[0.45, 0.3], [0.55, 0.5], [0.63, 0.2]]},
        lens([15, 15], 12, "PC", bspline()),
        shown("letter-256", screen(80, [20, 20], [128, 128], center=[25, 0]), viewed_from="front"),
    ),
}
"""Scenes by the names of their examples."""


def led() -> bytes:
    """A file of IES TM-25-13 with rays of a square LED that shines as Lambert's law says.

    Rays have the same flux, and places and directions are even: a quasi-random sequence after
    Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018), in four dimensions.
    """
    ratio = 1.1673039782614187  # solves x⁵ = x + 1
    even = np.arange(1, _RAYS + 1)[:, None] * ratio ** -np.arange(1, 5) % 1
    sine, angle = np.sqrt(even[:, 2]), 2 * np.pi * even[:, 3]
    table = np.zeros((_RAYS, 7), "<f4")
    table[:, :2] = _CHIP * (even[:, :2] - 0.5)
    table[:, 3:6] = np.column_stack(
        [sine * np.cos(angle), sine * np.sin(angle), np.sqrt(1 - even[:, 2])]
    )
    table[:, 6] = 1 / _RAYS
    return _header(table[:, 6].sum()).tobytes() + table.tobytes()


def _header(flux: float) -> npt.NDArray[np.void]:
    header = np.zeros((), HEADER)
    header["magic"], header["version"], header["date"] = b"TM25", VERSION, _DATE
    header["rays"], header["radiant_flux"], header["luminous_flux"] = _RAYS, flux, np.nan
    for wavelength in ("wavelength", "shortest", "longest"):
        header[wavelength] = np.nan
    header["flags"] = [1, 1, 1, 0, 0, 0, 0, 0]
    header["descriptions"] = ["Square LED of 1 mm, simulated", "", *[""] * 7]
    return header
