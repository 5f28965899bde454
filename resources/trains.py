"""Example scenes of several elements."""

from typing import Any

from resources.parts import bspline, in_mm, lens, mirror, screen, shown


def _with_diffuser(source: dict[str, Any], diffuser: dict[str, Any], image: str) -> dict[str, Any]:
    """Rear projection: the image is seen from behind the screen."""
    acrylic = lens([30, 30], 8, "PMMA", bspline(), min_thickness=2)
    film = {"kind": "diffuser", "name": "film", "transmittance": 0.9, **diffuser}
    return in_mm(source, [acrylic, film], shown(image, screen(200, [60, 60]), viewed_from="back"))


# One face bends light into the corners by 47°; acrylic reflects all light at 47.9°.
_WIDE = shown("photo-256", screen(300, [230, 230], [128, 128]))

SCENES = {
    # A silicone dome on an LED of 1 mm, a freeform lens, and a plate that covers them.
    "dome-cover": in_mm(
        {"kind": "area", "position": [0, 0, -10], "half_width": [0.5, 0.5]},
        [
            lens(
                [2.4, 2.4],
                2.5,
                1.41,
                {"shape": "conic", "radius": -2.5},
                name="dome",
                position=[0, 0, -9.9],
                outline="ellipse",
            ),
            lens([12, 12], 5, "PMMA", bspline(), outline="ellipse", min_thickness=1),
            lens([25, 25], 2, "PMMA", {"shape": "plane"}, name="cover", position=[0, 0, 30]),
        ],
        shown("rectangle-125x50", screen(160, [116, 56], [145, 70])),
    ),
    # Radius, conic constant and distance make light of the LED's middle parallel within 0.05°.
    "led-collimator": in_mm(
        {"kind": "area", "position": [0, 0, -14.8], "half_width": [0.5, 0.5]},
        [
            lens(
                [10, 10],
                8,
                "N-BK7",
                {"shape": "conic", "radius": -10.3, "conic": -0.6},
                name="collimator",
                outline="ellipse",
            ),
            lens(
                [10.5, 10.5],
                4,
                "PMMA",
                bspline(),
                name="plate",
                position=[0, 0, 14],
                outline="ellipse",
                min_thickness=1,
            ),
        ],
        shown("letter-256", screen(214, [60, 60], [128, 128])),
    ),
    "one-lens": in_mm(
        {"kind": "collimated"}, lens([10, 10], 4, "PMMA", bspline(), min_thickness=1), _WIDE
    ),
    "two-lenses": in_mm(
        {"kind": "collimated"},
        [
            lens([10, 10], 4, "PMMA", bspline(), name="first", min_thickness=1),
            lens(
                [22, 22],
                6,
                "PMMA",
                bspline(),
                name="second",
                position=[0, 0, 24],
                min_thickness=1,
            ),
        ],
        _WIDE,
    ),
    "diffuser-screen": _with_diffuser(
        {"kind": "point", "position": [0, 0, -80]},
        {
            "position": [0, 0, 196],
            "half_width": [70, 70],
            "scatter": {"kind": "gaussian", "sigma": 10},
        },
        "letter-256",
    ),
    "diffuser-lens": _with_diffuser(
        {"kind": "collimated"},
        {
            "position": [0, 0, 25],
            "half_width": [40, 40],
            "scatter": {"kind": "gaussian", "sigma": 0.3},
        },
        "photo-256",
    ),
    # The mirror turns light along +z to +y: what is behind it is turned by -90° about x.
    "fold-mirror": in_mm(
        {"kind": "collimated", "angular_diameter": 0.2},
        [
            mirror([9.5, 14], {"shape": "plane"}, name="fold", tilt=[45, 0, 0]),
            lens(
                [10, 10],
                4,
                "PMMA",
                bspline(),
                position=[0, 20, 0],
                tilt=[-90, 0, 0],
                min_thickness=1,
            ),
        ],
        shown("letter-256", screen(0, [35, 35], [128, 128], [0, 174], tilt=[-90, 0, 0])),
    ),
    # Light comes askew, and goes back beside where it came from.
    "mirror-and-lens": in_mm(
        {"kind": "collimated", "direction": [-15, 0]},
        [
            mirror([10, 10], bspline(), reflectance=0.9),
            lens(
                [20, 20],
                8,
                "N-BK7",
                {"shape": "conic", "radius": -100},
                name="field",
                position=[0, 16, -60],
                tilt=[-165, 0, 0],
            ),
        ],
        shown("letter-256", screen(-150, [30, 30], [128, 128], [0, 40], tilt=[15, 0, 0])),
    ),
    "tilted-lens": in_mm(
        {"kind": "collimated"},
        lens(
            [10, 10],
            3,
            "PMMA",
            bspline(),
            position=[2, 1, 0],
            tilt=[6, -5, 0],
            min_thickness=1,
        ),
        shown("photo-256", screen(150, [30, 30], [128, 128])),
    ),
}
"""Scenes by the names of their examples."""
