"""Proposals of jobs, so that nobody has to know: thickness of the lens, pixels of the image."""

import math
from typing import Any

from workbench.extended.blur import Blur, diffraction
from workbench.jobs.slopes import needed_slopes
from workbench.scene import Scene

# A lens is at least this thick, in half-widths and in millimetres, so that it can be made.
_THINNEST, _LEAST_MM = 0.05, 1.0
# The middle of the exit face is above that by this part of what the face rises, and of the lens.
_RISE, _BODY = 0.75, 0.04
# Pixels along the longer side of an image; so many pixels describe what is blurred.
_MOST, _FEWEST, _MULTIPLE, _IN_BLUR = 256, 96, 8, 8


def proposed(task: dict[str, Any], thickness: float | None = None) -> Scene:
    """The scene of a task in millimetres, with what it leaves open.

    `task`: plain data of a scene with one element and one image. A lens may lack its thickness, and
    the receiver its pixels; `thickness`: of the stock that a lens is cut from. Raises `Refused` if
    this is no possible scene.
    """
    (element,), (image,) = task["elements"], task["images"]
    receiver = image["receiver"]
    extent = receiver.get("half_width") or receiver["half_angle"]
    lens = element["kind"] == "lens"
    if lens:
        element = _lens(element, thickness)

    def scene_with(pixels: list[int]) -> Scene:
        seen = image | {"receiver": {"pixels": pixels} | receiver}
        common = {"version": 3, "unit": "mm"}
        return Scene.from_data(task | common | {"elements": [element], "images": [seen]})

    pixels = _pixels(extent, _MOST)
    scene = scene_with(pixels)
    finest = resolution(scene)
    if finest > 0:
        per_side = math.ceil(2 * max(extent) / finest * _IN_BLUR / _MULTIPLE) * _MULTIPLE
        pixels = _pixels(extent, min(max(per_side, _FEWEST), _MOST))
    if lens and thickness is None:
        rise = needed_slopes(scene).rise
        middle = element["min_thickness"] + _RISE * rise + _BODY * max(scene.optic.half_width)
        element = element | {"thickness": float(f"{middle:.2g}")}
    return scene_with(pixels)


def resolution(scene: Scene) -> float:
    """Width of the finest detail that light of the source can draw, in the receiver's measure.

    The larger of the source's blur and of the scale of diffraction.
    """
    blur = min(blur_widths(scene))
    return max(blur, diffraction(scene))


def blur_widths(scene: Scene) -> tuple[float, float]:
    """Full widths of the source's blur along x and y, in the receiver's measure."""
    receiver = scene.receiver
    x, y = (
        2 * half * width / pixels
        for half, width, pixels in zip(
            receiver.half_extent, Blur.of(scene).widths, receiver.pixels, strict=True
        )
    )
    return x, y


def _lens(given: dict[str, Any], thickness: float | None) -> dict[str, Any]:
    half = max(given["half_width"])
    thin = float(f"{max(_THINNEST * half, _LEAST_MM):.2g}")
    if thickness is None:
        return {"min_thickness": thin, "thickness": half / 2} | given
    thin = min(thin, thickness / 2)
    middle = float(f"{(thin + thickness) / 2:.3g}")
    return {"min_thickness": thin, "max_thickness": thickness, "thickness": middle} | given


def _pixels(extent: tuple[float, float], longer: int) -> list[int]:
    """As many along the longer side, and square ones along both."""
    side = max(extent)
    return [max(round(longer * each / side / _MULTIPLE), 1) * _MULTIPLE for each in extent]
