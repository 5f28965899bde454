"""What a face does to the light that meets it: a file for each kind."""

from workbench.analysis.tracing.interfaces.dielectric import DielectricBoundary, reflectances
from workbench.analysis.tracing.interfaces.mirror import MirrorBoundary
from workbench.analysis.tracing.interfaces.scatter import ScatterBoundary

__all__ = ["DielectricBoundary", "MirrorBoundary", "ScatterBoundary", "reflectances"]
