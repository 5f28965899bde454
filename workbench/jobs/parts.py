"""Parts of a scene, as plain data, from what jobs ask for: full widths become half widths."""

from typing import Any

from workbench.scene import Part

GREEN_UM = 0.55


def lens(size: tuple[float, float], material: str) -> dict[str, Any]:
    """A lens of a full width and height, whose back face is designed."""
    return {
        "kind": "lens",
        "name": "lens",
        "half_width": halves(size),
        "material": material,
        "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": "auto"}],
    }


def mirror(size: tuple[float, float]) -> dict[str, Any]:
    """A mirror of a full width and height."""
    return {
        "kind": "mirror",
        "name": "mirror",
        "half_width": halves(size),
        "face": {"shape": "bspline", "control_points": "auto"},
    }


def screen(distance: float, size: tuple[float, float]) -> dict[str, Any]:
    """A screen of a full width and height across the axis."""
    return {"kind": "plane", "position": [0.0, 0.0, distance], "half_width": halves(size)}


def emitter(
    distance: float, size: tuple[float, float], lumens: float | None = None
) -> dict[str, Any]:
    """The bright face of an LED of a full width and height, so far before the lens."""
    return {
        "kind": "area",
        "position": [0.0, 0.0, -distance],
        "half_width": halves(size),
        "flux": lumens,
    }


def halves(size: tuple[float, float]) -> list[float]:
    """Half of each."""
    return [each / 2 for each in size]


def written(part: Part) -> dict[str, Any]:
    """A part as plain data."""
    data: dict[str, Any] = part.model_dump(mode="json", exclude_none=True)
    return data
