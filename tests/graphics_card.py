"""What tests of a graphics card share."""

import pytest
import torch

from workbench.scene import Scene

NEEDED = pytest.mark.skipif(not torch.cuda.is_available(), reason="there is no GPU here")

EXAMPLES = [
    "letter",
    "flame-point",
    "sun-plate",
    "phone-torch",
    "led-rectangle",
    "led-dome",
    "wall-washer",
    "street-light",
    "beam-shaper",
    "measured-led",
    "white-light",
    "mirror-photo",
    "two-distances",
    "wide-angle",
]
"""Every source, receiver, outline and number of faces is in one of them, but a grid of points."""


def computed_on(device: str, scene: Scene) -> Scene:
    """A scene that asks for a device."""
    return scene.model_copy(update={"run": scene.run.model_copy(update={"device": device})})
