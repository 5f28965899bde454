"""Example scenes whose lens has two freeform faces."""

from resources.parts import bspline, in_mm, lens, screen, shown

_ACRYLIC = 1.49


SCENES = {
    "thin-plate": in_mm(
        {"kind": "collimated"},
        lens([50, 50], 6, _ACRYLIC, bspline(), bspline(), min_thickness=2),
        shown("photo-256", screen(300, [80, 80])),
    ),
    "wide-angle": in_mm(
        {"kind": "point", "position": [0, 0, -14]},
        lens(
            [25, 25],
            3,
            _ACRYLIC,
            bspline(),
            bspline(height_range=[0, 12]),
            outline="ellipse",
            max_thickness=45,
            min_thickness=0.5,
        ),
        shown("tophat-256", screen(250, [100, 100])),
    ),
    "led-dome": in_mm(
        {"kind": "area", "position": [0, 0, -7], "half_width": [1, 1]},
        lens(
            [10, 10],
            3,
            _ACRYLIC,
            bspline([32, 32]),
            # Its middle comes near the LED; its rim ends about where a flat one is.
            bspline(height_range=[-4, 1]),
            outline="ellipse",
            max_thickness=18,
            min_thickness=0.5,
        ),
        shown("rectangle-20x20", screen(200, [140, 140], [40, 40])),
    ),
    # The same photograph at 0.9 and 1.1 times 150 mm behind the lens and as wide as it: light goes
    # straight on behind the lens, and is moved between its faces alone.
    "two-distances": in_mm(
        {"kind": "collimated"},
        lens(
            [50, 50],
            100,
            _ACRYLIC,
            bspline(),
            bspline(height_range=[-20, 20]),
            min_thickness=2,
        ),
        *(shown("photo-256", screen(z, [50, 50], [128, 128])) for z in (235, 265)),
    ),
}
"""Scenes by the names of their examples."""
