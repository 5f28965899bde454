"""Unit of lengths in meshes."""

from workbench.errors import Refused, shown
from workbench.said import Said
from workbench.units import METRES

MILLIMETRES, SCENE_UNIT = "mm", "scene"
"""What programs take lengths of a mesh without a unit for, and the name of the scene's unit."""
MESH_UNITS = (*METRES, SCENE_UNIT)
"""All that lengths of a mesh may be in."""


def mesh_unit_of(asked: str, scene_unit: str) -> str:
    """Return the unit of length that is asked for, by its name.

    Raises
    ------
    Refused
        If it is unknown.
    """
    if asked not in MESH_UNITS:
        known = ", ".join(MESH_UNITS)
        raise Refused("mesh_unit", Said("{unit}; one of {known}", unit=shown(asked), known=known))
    return scene_unit if asked == SCENE_UNIT else asked
