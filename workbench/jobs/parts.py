"""Parts of a scene, as plain data, from what jobs ask for: full widths become half widths."""

from typing import Any

from workbench.scene import Part

GREEN_UM = 0.55


def lens(
    size: tuple[float, float], material: str, wavelength_um: float = GREEN_UM
) -> dict[str, Any]:
    """A lens of a full width and height."""
    return {
        "half_width": halves(size),
        "refractive_index": material,
        "wavelength_um": wavelength_um,
        "reflection": "fresnel",
    }


def screen(distance: float, size: tuple[float, float]) -> dict[str, Any]:
    """A screen of a full width and height across the axis."""
    return {"z": distance, "half_width": halves(size)}


def emitter(
    distance: float, size: tuple[float, float], lumens: float | None = None
) -> dict[str, Any]:
    """The bright face of an LED of a full width and height, so far before the lens."""
    return {
        "kind": "area",
        "center": [0.0, 0.0, -distance],
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
