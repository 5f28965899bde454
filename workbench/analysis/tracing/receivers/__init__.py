"""Where light is counted: a file for each kind."""

from workbench.analysis.tracing.receivers.plane import PlaneDetector

__all__ = ["PlaneDetector"]
