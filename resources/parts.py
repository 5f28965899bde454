"""Parts of example scenes, as plain data."""

from collections.abc import Sequence
from typing import Any

PLANE = {"shape": "plane"}


def bspline(control_points: Sequence[int] | str = "auto", **fields: Any) -> dict[str, Any]:
    """A freeform face."""
    return {"shape": "bspline", "control_points": control_points, **fields}


def lens(
    half_width: Sequence[float],
    thickness: float,
    material: str | float,
    back: dict[str, Any],
    front: dict[str, Any] = PLANE,
    **fields: Any,
) -> dict[str, Any]:
    """A lens of a catalogue material or an index, its front vertex at the origin."""
    made_of = material if isinstance(material, str) else {"index": material}
    return {
        "kind": "lens",
        "name": "lens",
        "half_width": half_width,
        "material": made_of,
        "thickness": thickness,
        "faces": [front, back],
        **fields,
    }


def mirror(half_width: Sequence[float], face: dict[str, Any], **fields: Any) -> dict[str, Any]:
    """A mirror, its vertex at the origin."""
    return {"kind": "mirror", "name": "mirror", "half_width": half_width, "face": face, **fields}


def screen(
    z: float,
    half_width: Sequence[float],
    pixels: Sequence[int] = (256, 256),
    center: Sequence[float] = (0, 0),
    **fields: Any,
) -> dict[str, Any]:
    """A screen with its middle at a z, upright unless it has a tilt."""
    where = {"kind": "plane", "position": [*center, z]}
    return where | {"half_width": half_width, "pixels": pixels, **fields}


def shown(image: str, receiver: dict[str, Any], **fields: Any) -> dict[str, Any]:
    """An image: one of the shipped targets on a receiver."""
    return {"receiver": receiver, "target": {"image": f"../targets/{image}.png", **fields}}


def in_mm(
    source: dict[str, Any],
    elements: dict[str, Any] | Sequence[dict[str, Any]],
    *images: dict[str, Any],
) -> dict[str, Any]:
    """A scene in millimetres with one element or several."""
    return {
        "version": 3,
        "unit": "mm",
        "source": source,
        "elements": [elements] if isinstance(elements, dict) else elements,
        "images": images,
    }
