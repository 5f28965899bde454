"""Where rays meet a face: one file a kind."""

from workbench.optics.surfaces.bspline import BSplineSurface
from workbench.optics.surfaces.conic import Conic
from workbench.optics.surfaces.plane import Plane
from workbench.optics.surfaces.surface import Meeting, Surface

__all__ = ["BSplineSurface", "Conic", "Meeting", "Plane", "Surface"]
