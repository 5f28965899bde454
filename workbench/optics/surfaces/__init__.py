"""Where rays meet a face: one file a kind."""

from workbench.optics.surfaces.bspline import BSplineSurface
from workbench.optics.surfaces.sag import Conic
from workbench.optics.surfaces.surface import Meeting, Plane, Surface

__all__ = ["BSplineSurface", "Conic", "Meeting", "Plane", "Surface"]
