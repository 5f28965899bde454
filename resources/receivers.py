"""Example scenes whose receiver is no upright screen on the axis, and the lamp of one of them."""

from typing import Any

import numpy as np

from resources.parts import bspline, in_mm, lens, screen, shown

_FLUX = 100  # lumens
_POWER = 1.5  # of the cosine; 1 is Lambert's law


def _scene(
    source: dict[str, Any], element: dict[str, Any], receiver: dict[str, Any], image: str
) -> dict[str, Any]:
    """Scene whose light is viewed from its own side."""
    return in_mm(source, element, shown(image, receiver, viewed_from="front"))


_ACRYLIC = lens([15, 15], 6, 1.49, bspline())
_ALUMINIUM = {
    "kind": "mirror",
    "name": "mirror",
    "half_width": [15, 15],
    "reflectance": 0.9,
    "face": bspline(),
}
SCENES = {
    "wall-washer": _scene(
        {"kind": "point", "position": [0, 0, -100]},
        _ACRYLIC,
        screen(400, [120, 120], center=[0, 100], tilt=[30, 0, 0]),
        "photo-256",
    ),
    "street-light": _scene(
        {"kind": "photometric", "file": "../lights/led.ies", "position": [0, 0, -20]},
        _ACRYLIC,
        {"kind": "far_field", "half_angle": [40, 40], "pixels": [256, 256]},
        "street-256",
    ),
    "mirror-letter": _scene(
        {"kind": "collimated"},
        _ALUMINIUM,
        screen(-60, [20, 20], center=[60, 0], tilt=[0, -45, 0]),
        "letter-256",
    ),
    "mirror-photo": _scene(
        {"kind": "point", "position": [-20, 0, -80]},
        _ALUMINIUM,
        screen(-100, [20, 20], center=[40, 0]),
        "photo-256",
    ),
}
"""Scenes by the names of their examples."""


def lamp() -> str:
    """A file of IES LM-63-2002: an LED that shines the same all around, somewhat forward."""
    angles = np.arange(0.0, 90.0, 5.0)
    peak = _FLUX * (_POWER + 1) / (2 * np.pi)  # candela
    candela = [*(peak * np.cos(np.radians(angles)) ** _POWER), 0.0]
    return "\n".join(
        [
            "IESNA:LM-63-2002",
            "[TEST] computed, not measured",
            "[TESTLAB] none",
            "[ISSUEDATE] 2025-01-01",
            "[MANUFAC] none",
            f"[LUMINAIRE] LED, cos^{_POWER:g}",
            "TILT=NONE",
            f"1 {_FLUX} 1 {len(candela)} 1 1 2 0 0 0",
            "1 1 1",
            " ".join(f"{angle:g}" for angle in (*angles, 90)),
            "0",
            " ".join(f"{value:.3f}" for value in candela),
            "",
        ]
    )
