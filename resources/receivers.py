"""Example scenes whose receiver is no upright screen on the axis, and the lamp of one of them."""

from typing import Any

import numpy as np

_FLUX = 100  # lumens
_POWER = 1.5  # of the cosine; 1 is Lambert's law


def _scene(source: dict[str, Any], receiver: dict[str, Any], image: str) -> dict[str, Any]:
    """Scene in millimetres with a lens of acrylic, 30 mm wide."""
    return {
        "version": 2,
        "unit": "mm",
        "lens": {
            "half_width": [15, 15],
            "refractive_index": 1.49,
            "control_points": "auto",
            "base": {"shape": "flat", "height": 6},
        },
        "source": source,
        **receiver,
        "target": {"image": f"../targets/{image}.png", "viewed_from": "front"},
    }


def _mirror(source: dict[str, Any], screen: dict[str, Any], image: str) -> dict[str, Any]:
    """Scene in millimetres with a mirror of aluminium, 30 mm wide."""
    return {
        "version": 2,
        "unit": "mm",
        "mirror": {"half_width": [15, 15], "control_points": "auto", "reflectance": 0.9},
        "source": source,
        "screen": screen | {"pixels": [256, 256]},
        "target": {"image": f"../targets/{image}.png", "viewed_from": "front"},
    }


SCENES = {
    "wall-washer": _scene(
        {"kind": "point", "position": [0, 0, -100]},
        {
            "screen": {
                "z": 400,
                "center": [0, 100],
                "tilt": [30, 0],
                "half_width": [120, 120],
                "pixels": [256, 256],
            }
        },
        "photo-256",
    ),
    "street-light": _scene(
        {"kind": "photometric", "file": "../lights/led.ies", "position": [0, 0, -20]},
        {"far_field": {"half_angle": [40, 40], "pixels": [256, 256]}},
        "street-256",
    ),
    "mirror-letter": _mirror(
        {"kind": "collimated"},
        {"z": -60, "center": [60, 0], "tilt": [0, -45], "half_width": [20, 20]},
        "letter-256",
    ),
    "mirror-photo": _mirror(
        {"kind": "point", "position": [-20, 0, -80]},
        {"z": -100, "center": [40, 0], "half_width": [20, 20]},
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
