"""From which side the image on a receiver is seen, and how it looks from there.

Arrays of images lie as the receiver counts: row 0 at +v and column 0 at −u. On one side of the
receiver a viewer sees u to the right, and so the columns in their order; on the other side, from
the last one to the first. A target is drawn as its viewer shall see it, and laid onto the receiver
by `as_viewed`; nothing else mirrors images.
"""

from typing import TYPE_CHECKING

import numpy as np

from workbench.arrays import Array
from workbench.messages import Message
from workbench.scene.target import Side

if TYPE_CHECKING:
    from workbench.scene.task import Scene


def pixel_side(scene: "Scene") -> Side:
    """The side of the receiver from which column 0 of its pixels is at the left."""
    return "front" if scene.onwards(scene.receiver) < 0 else "back"


def viewed_from(scene: "Scene") -> Side:
    """The side of the receiver from which the target reads right.

    Examples
    --------
    >>> from workbench.scene import Scene
    >>> scene = Scene.from_data({
    ...     "version": 3,
    ...     "source": {"kind": "collimated"},
    ...     "elements": [{
    ...         "kind": "lens", "name": "lens", "half_width": [1, 1], "material": "PMMA",
    ...         "thickness": 0.5, "faces": [{"shape": "plane"}, {"shape": "bspline"}],
    ...     }],
    ...     "images": [{
    ...         "receiver": {
    ...             "kind": "plane", "position": [0, 0, 5], "half_width": [1, 1],
    ...             "pixels": [128, 128],
    ...         },
    ...         "target": {"builtin": "text", "text": "F"},
    ...     }],
    ... })
    >>> viewed_from(scene)
    'back'
    """
    return scene.target.viewed_from or pixel_side(scene)


def inverted(scene: "Scene") -> bool:
    """Whether the target's viewer sees column 0 of the receiver's pixels at the right."""
    return viewed_from(scene) != pixel_side(scene)


def as_viewed(scene: "Scene", image: Array) -> Array:
    """An image on a receiver as its viewer sees it; and the reverse, which is the same.

    `scene`: gives receiver and viewer, of its first image; `image` (n_y, n_x, ...): on the pixels
    of the receiver, or as the viewer sees it. Returns (n_y, n_x, ...).
    """
    return np.ascontiguousarray(image[:, ::-1]) if inverted(scene) else image


def side_in_words(scene: "Scene", side: Side) -> Message:
    """From where one sees, as in "viewed from behind the screen"."""
    if side == "front":
        return Message("viewed from the side of the light")
    return Message("viewed from behind the {receiver}", receiver=scene.receiver.called)


def drawing(scene: "Scene") -> tuple[object, ...]:
    """All that the array of the target depends on."""
    receiver = scene.receiver
    return scene.target, receiver.half_extent, receiver.pixels, inverted(scene)
