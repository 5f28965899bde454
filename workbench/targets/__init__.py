"""The target: an image of light on the screen's pixels."""

from workbench.targets.prepare import load_target, picture_aspect

__all__ = ["load_target", "picture_aspect"]
