"""Where rays meet a face: one file a kind."""

from workbench.optics.surfaces.bspline import BSplineSurface
from workbench.optics.surfaces.sag import Conic, fixed_surface
from workbench.optics.surfaces.surface import Meeting, Plane, Surface

__all__ = ["BSplineSurface", "Conic", "Meeting", "Plane", "Surface", "fixed_surface"]
