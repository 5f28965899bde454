"""The engine of the Freeform Lens Workbench: everything but the window."""

__version__ = "0.1.0"
