"""Leads the camera of the 3D scene by keys.

Arrows turn it about the middle of the picture, with Shift they move it, + and − take it nearer and
farther, Home shows the whole.
"""

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

from ui.views.keys import ARROWS, COMMANDS, ZOOMS

if TYPE_CHECKING:
    from workbench.pictures.camera import FittedCamera

_TURN = 5.0  # degrees
_MOVE = 0.05  # of the height of what is seen
_ZOOM = 1.25


def steer(camera: "FittedCamera", event: QKeyEvent) -> bool:
    """Move the camera by a key; return whether the key was used.

    Arrows turn it about the middle of the picture, with Shift they shift it, + and − zoom, Home
    shows everything.
    """
    key, keys = event.key(), event.modifiers()
    if keys & COMMANDS:
        return False
    if key in ARROWS:
        right, up = ARROWS[key]
        if keys & Qt.KeyboardModifier.ShiftModifier:
            camera.move(_MOVE * right, _MOVE * up)
        else:
            camera.turn(_TURN * right, _TURN * up)
    elif key in ZOOMS:
        camera.zoom(_ZOOM ** ZOOMS[key])
    elif key == Qt.Key.Key_Home:
        camera.fit("")
    else:
        return False
    return True
