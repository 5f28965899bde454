"""What a face does to the light that meets it: a file for each kind."""

from workbench.analysis.tracing.interfaces.dielectric import DielectricBoundary, reflectances

__all__ = ["DielectricBoundary", "reflectances"]
