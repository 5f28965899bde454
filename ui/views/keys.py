"""Keys that do the same in images, curves and the 3D scene."""

from PySide6.QtCore import Qt

_Key = Qt.Key

ARROWS: dict[int, tuple[int, int]] = {
    _Key.Key_Left: (-1, 0),
    _Key.Key_Right: (1, 0),
    _Key.Key_Down: (0, -1),
    _Key.Key_Up: (0, 1),
}
"""Steps to the right and up, by key."""

ZOOMS: dict[int, int] = {_Key.Key_Plus: 1, _Key.Key_Equal: 1, _Key.Key_Minus: -1}
"""Steps nearer, by key."""

COMMANDS = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
"""With either of these, a key is for the window."""
