"""Target image: light on the receiver's pixels."""

from workbench.targets.prepare import (
    cropped,
    draw_target,
    levelled,
    load_target,
    picture_aspect,
    pixel_values,
    stored_picture,
)

__all__ = [
    "cropped",
    "draw_target",
    "levelled",
    "load_target",
    "picture_aspect",
    "pixel_values",
    "stored_picture",
]
