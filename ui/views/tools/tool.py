"""The events that a tool of the 3D scene gets, and what it has to return."""

from collections.abc import Set
from dataclasses import dataclass
from typing import Protocol

from PySide6.QtCore import Qt


@dataclass(frozen=True)
class Pointer:
    """Position of the mouse, and modifier keys."""

    x: float
    y: float
    fine: bool = False
    along: bool = False


class Tool(Protocol):
    """Tool that uses the left button, and some keys."""

    cursor: Qt.CursorShape
    shows_net: bool
    shows_handles: bool
    keys: Set[int]

    @property
    def hint(self) -> str:
        """What the tool does, in one line."""

    def press(self, at: Pointer) -> bool:
        """Begin a drag; False leaves the button to the camera."""

    def drag(self, at: Pointer) -> None:
        """Continue a drag."""

    def press_key(self, key: int) -> None:
        """Begin the action of a key, as a drag."""

    def repeat_key(self, key: int, fine: bool) -> None:
        """Apply the action of a key: after the press, and repeatedly while it is held."""

    def release(self) -> None:
        """End a drag, or the action of a key."""

    def cancel(self) -> None:
        """Cancel a drag, if there is one."""

    def hover(self, at: Pointer | None) -> None:
        """Highlight what a press would grab; None when the pointer left."""

    def turn_wheel(self, steps: int) -> None:
        """Change the size of the tool, if it has one."""
