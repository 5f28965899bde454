"""Where light is wanted: one file a kind."""

from workbench.optics.receivers.plane import PlaneReceiver

__all__ = ["PlaneReceiver"]
