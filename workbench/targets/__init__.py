"""Target image: light on the receiver's pixels."""

from workbench.targets.prepare import draw_target, load_target, picture_aspect, picture_light

__all__ = ["draw_target", "load_target", "picture_aspect", "picture_light"]
