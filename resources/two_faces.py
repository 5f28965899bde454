"""Example scenes whose lens has two freeform faces."""

from typing import Any

_ACRYLIC = 1.49


def _scene(
    lens: dict[str, Any], source: dict[str, Any], screen: dict[str, Any], image: str
) -> dict[str, Any]:
    """Scene in millimetres with a lens of acrylic."""
    usual = {"refractive_index": _ACRYLIC, "control_points": "auto"}
    return {
        "version": 2,
        "unit": "mm",
        "lens": usual | lens,
        "source": source,
        "screen": {"pixels": [256, 256]} | screen,
        "target": {"image": f"../targets/{image}.png"},
    }


SCENES = {
    "thin-plate": _scene(
        {
            "half_width": [50, 50],
            "base": {"shape": "flat", "height": 6},
            "min_thickness": 2,
            "entrance": {"shape": "freeform", "control_points": "auto"},
        },
        {"kind": "collimated"},
        {"z": 300, "half_width": [80, 80]},
        "photo-256",
    ),
    "wide-angle": _scene(
        {
            "half_width": [25, 25],
            "outline": "ellipse",
            "base": {"shape": "flat", "height": 3},
            "max_thickness": 45,
            "min_thickness": 0.5,
            "entrance": {
                "shape": "freeform",
                "control_points": "auto",
                "height_range": [0, 12],
            },
        },
        {"kind": "point", "position": [0, 0, -14]},
        {"z": 250, "half_width": [100, 100]},
        "tophat-256",
    ),
    "led-dome": _scene(
        {
            "half_width": [10, 10],
            "outline": "ellipse",
            "control_points": [32, 32],
            "base": {"shape": "flat", "height": 3},
            "max_thickness": 18,
            "min_thickness": 0.5,
            # Its middle comes near the LED; its rim ends about where a flat one is.
            "entrance": {"shape": "freeform", "height_range": [-4, 1]},
        },
        {"kind": "area", "center": [0, 0, -7], "half_width": [1, 1]},
        {"z": 200, "half_width": [140, 140], "pixels": [40, 40]},
        "rectangle-20x20",
    ),
    # The same photograph at 0.9 and 1.1 times 150 mm behind the lens and as wide as it: light goes
    # straight on behind the lens, and is moved between its faces alone.
    "two-distances": _scene(
        {
            "half_width": [50, 50],
            "base": {"shape": "flat", "height": 100},
            "min_thickness": 2,
            "entrance": {
                "shape": "freeform",
                "control_points": "auto",
                "height_range": [-20, 20],
            },
        },
        {"kind": "collimated"},
        {"z": 235, "half_width": [50, 50], "pixels": [128, 128]},
        "photo-256",
    )
    | {
        "further_images": [
            {
                "screen": {"z": 265, "half_width": [50, 50], "pixels": [128, 128]},
                "target": {"image": "../targets/photo-256.png"},
            }
        ]
    },
}
"""Scenes by the names of their examples."""
