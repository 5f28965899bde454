"""Faces that rays meet: a file for each kind."""

from workbench.analysis.tracing.surfaces.cut import CutSurface
from workbench.analysis.tracing.surfaces.fixed import ConicSurface, fixed_surface
from workbench.analysis.tracing.surfaces.flat import FlatFace
from workbench.analysis.tracing.surfaces.moved import MovedFace
from workbench.analysis.tracing.surfaces.placed import PlacedSurface
from workbench.analysis.tracing.surfaces.spline import FrontFace, LaterFace, SplineFace

__all__ = [
    "ConicSurface",
    "CutSurface",
    "FlatFace",
    "FrontFace",
    "LaterFace",
    "MovedFace",
    "PlacedSurface",
    "SplineFace",
    "fixed_surface",
]
