"""Makes the target images, the example scenes, the JSON Schema and the fields page of scenes here.

Run ``python -m resources.make_resources`` after a change to a built-in shape or to the scene, and
commit what changed. The icons are drawn by hand.
"""

import json
import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import resources
from resources import drawings, lights, receivers, trains, two_faces
from resources.fields_page import fields_page
from resources.parts import bspline, lens, screen, shown
from workbench.arrays import Array
from workbench.scene import BallTarget, FlameTarget, Scene, Screen, TopHatTarget
from workbench.targets.shapes import Builtin, draw

SHAPES: dict[str, Builtin] = {
    "tophat": TopHatTarget(),
    "flame": FlameTarget(),
    "ball": BallTarget(),
}
SIZES = (256, 512)
DRAWINGS = {"photo": drawings.photograph, "letter": drawings.letter, "street": drawings.street}
DRAWING_SIZE = 256
RECTANGLES = ((125, 50), (20, 20))
"""Evenly lit ones: pixels along x and y, without the dark margin."""
_MARGIN = 10  # pixels

_RADII = {3: 8.0, 5: 4.0}  # of the base, by magnification
_SOURCES = {
    "point": {"kind": "point", "position": [0.0, 0.0, -5.0], "rays": 500_000},
    "grid": {
        "kind": "grid",
        "position": [0.0, 0.0, -5.0],
        "half_width": [1.0, 1.0],
        "points": [25, 25],
        "rays": 1000,
    },
}


def make(folder: Path) -> None:
    """Write everything that is generated below ``folder``."""
    targets, examples, measured = (folder / name for name in ("targets", "examples", "lights"))
    for below in (targets, examples, measured):
        below.mkdir(exist_ok=True)
    for name in SHAPES:
        for size in SIZES:
            target_image(name, size).save(targets / f"{name}-{size}.png", optimize=True)
    for name in DRAWINGS:
        drawing(name).save(targets / f"{name}-{DRAWING_SIZE}.png", optimize=True)
    for across, up in RECTANGLES:
        lit = _grey_image(np.pad(np.ones((up, across)), _MARGIN))
        lit.save(targets / f"rectangle-{across}x{up}.png", optimize=True)
    (measured / "led.tm25ray").write_bytes(lights.led())
    (measured / "led.ies").write_bytes(receivers.lamp().encode("ascii"))
    for each in resources.EXAMPLES:
        file = examples / each.file.name
        file.write_text(example(each.name).to_json(), encoding="utf-8")
    (folder / "scene.schema.json").write_text(schema(), encoding="utf-8")
    (folder / "manual").mkdir(exist_ok=True)
    (folder / "manual" / "fields.md").write_text(fields_page(), encoding="utf-8")


def target_image(name: str, size: int) -> Image.Image:
    """Draw a built-in shape as a square 8-bit grey image of ``size`` pixels a side."""
    square = Screen(
        kind="plane", position=(0.0, 0.0, 1.0), half_width=(1.0, 1.0), pixels=(size, size)
    )
    return _grey_image(draw(SHAPES[name], square, 1.0))


def drawing(name: str) -> Image.Image:
    """Draw what no scene has built in, likewise."""
    return _grey_image(DRAWINGS[name](DRAWING_SIZE))


def _grey_image(light: Array) -> Image.Image:
    return Image.fromarray(np.rint(255 * light).astype(np.uint8))


def example(name: str) -> Scene:
    """Build the example scene of a name in `resources.EXAMPLES`."""
    if job := (lights.SCENES | receivers.SCENES | two_faces.SCENES | trains.SCENES).get(name):
        return Scene.from_data(job)
    shape, _, variant = name.partition("-")
    if variant in ("", "512"):
        return Scene.from_data(_fine(shape, fineness=2 if variant else 1))
    if shape == "derivative":
        degree, size = (int(re.sub(r"\D", "", part)) for part in variant.split("-"))
        return Scene.from_data(_influence(degree, size))
    if shape == "tophat":
        return Scene.from_data(_network(*variant.split("-")))
    if variant.startswith("x"):
        return Scene.from_data(_magnified(shape, int(variant[1:])))
    if variant == "stages":
        return Scene.from_data(_first_from_a_point())
    return Scene.from_data(_lit_from(_SOURCES[variant]))


def _fine(shape: str, fineness: int) -> dict[str, Any]:
    """A net as fine as the target is worth; on twice as many pixels one that begins soon."""
    data = _first(shape, fineness)
    return _exact(data) if fineness == 1 else _shaped(data, control_points=[192, 192])


def _exact(data: dict[str, Any]) -> dict[str, Any]:
    """With a net that the program chooses, and exact reflections."""
    return _shaped(_formed(data, reflection="fresnel"), control_points="auto")


def _first(shape: str, fineness: int = 1) -> dict[str, Any]:
    pixels, rays, control_points = 256 * fineness, 512 * fineness, 64 * fineness
    back = bspline([control_points, control_points], degree=[3, 3], height_range=[-0.3, 0.3])
    return {
        "version": 3,
        "unit": "cm",
        "source": {"kind": "collimated", "rays": [rays, rays]},
        "elements": [lens([1.0, 1.0], 0.5, 1.5, back, min_thickness=0.05, reflection="schlick")],
        "images": [shown(f"{shape}-{pixels}", screen(5.0, [1.0, 1.0], [pixels, pixels]))],
        "filter": {"kind": "gaussian", "size": [3, 3], "alpha": 1.0},
        "run": {"method": "auto", "iterations": 300, "seed": 0},
    }


def _formed(data: dict[str, Any], **fields: Any) -> dict[str, Any]:
    """The scene with other fields of its lens."""
    (element,) = data["elements"]
    return data | {"elements": [element | fields]}


def _shaped(data: dict[str, Any], **fields: Any) -> dict[str, Any]:
    """The scene with other fields of the designed face."""
    front, back = data["elements"][0]["faces"]
    return _formed(data, faces=[front, back | fields])


def _network(parametrisation: str, start: str) -> dict[str, Any]:
    """Top hat by the paper's method; a net small enough for a dense network."""
    data = _shaped(_first("tophat"), control_points=[32, 32])
    data["run"] = {
        "method": "paper",
        "parametrisation": parametrisation,
        "start": start,
        "iterations": 1000,
        "seed": 0,
    }
    return data


def _magnified(shape: str, magnification: int) -> dict[str, Any]:
    """Table 1 of the paper; the lens half-width and the distance of 32 are inferred from it.

    The focal lengths -16 and -8 of its bases then just fill the screens.
    """
    base: dict[str, Any] = {"shape": "flat"}
    if magnification > 1:
        base = {"shape": "sphere", "radius": _RADII[magnification]}
    half_width = round(0.64 * magnification, 2)
    data = _shaped(_first(shape), base=base, height_range=[-0.05, 0.05])
    data["images"] = [shown(f"{shape}-256", screen(32.5, [half_width, half_width]))]
    return _formed(data, half_width=[0.64, 0.64])


def _lit_from(source: dict[str, Any]) -> dict[str, Any]:
    """The lens has to collect the light first: it needs a larger height range."""
    data = _formed(_shaped(_first("flame"), height_range=[-0.4, 0.4]), thickness=0.6)
    data["source"] = source
    return _exact(data) if source["kind"] == "point" else data


def _first_from_a_point() -> dict[str, Any]:
    """The paper's run: a point source, and after some 200 iterations the extended one."""
    data = _lit_from(_SOURCES["grid"])
    data["run"]["stages"] = [{"iterations": 200, "source": _SOURCES["point"]}]
    return data


def _influence(degree: int, size: int) -> dict[str, Any]:
    """A case of the paper's derivative maps; its net is coarse, so that a map fills the screen."""
    data = _shaped(_first("tophat"), degree=[degree, 3], control_points=[9, 9])
    # Wide filters fall slowly, or they would be as narrow as small ones.
    data["filter"] |= {"size": [size, size], "alpha": round(9 / size**2, 2)}
    return data


def schema() -> str:
    """JSON Schema of the scene file, for editors."""
    described = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **Scene.model_json_schema(),
    }
    return json.dumps(described, indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    make(resources.path())
    sys.stdout.write(f"written below {resources.path()}\n")
