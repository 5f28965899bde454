"""The engine of the Freeform Lens Workbench: everything but the window.

Other programs find what they may rely on in `workbench.api`, and can take it from here.
"""

from importlib import import_module
from typing import Any

__version__ = "0.1.0"

__all__ = [
    "Cutting",
    "DesignRun",
    "Drawing",
    "FaceArrays",
    "Inspection",
    "PlanOptions",
    "Refused",
    "Result",
    "RunFailed",
    "Scene",
    "Session",
    "Snapshot",
    "Tile",
    "Turning",
    "Validation",
    "Written",
    "as_made",
    "begin",
    "check",
    "compromises",
    "corrected",
    "expected_error",
    "export",
    "inspect",
    "load",
    "photograph",
    "plan",
    "preset_processes",
    "save",
    "sensitivity",
]


def __getattr__(name: str) -> Any:
    # Late: the program's own parts import this package, and want little of it.
    if name in __all__:
        return getattr(import_module("workbench.api"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
