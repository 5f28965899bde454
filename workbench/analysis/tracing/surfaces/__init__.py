"""Faces that rays meet: a file for each kind."""

from workbench.analysis.tracing.surfaces.flat import FlatFace
from workbench.analysis.tracing.surfaces.spline import MirrorFace, SplineFace

__all__ = ["FlatFace", "MirrorFace", "SplineFace"]
