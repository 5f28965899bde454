"""The target: an image of light on the screen's pixels."""

from workbench.targets.prepare import draw_target, load_target, picture_aspect

__all__ = ["draw_target", "load_target", "picture_aspect"]
