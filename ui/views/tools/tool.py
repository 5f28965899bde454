"""The events that a tool of the 3D scene gets, and what it has to return."""

from collections.abc import Set
from dataclasses import dataclass
from typing import Protocol

from PySide6.QtCore import Qt


@dataclass(frozen=True)
class Pointer:
    """Where the mouse is, and the keys held with it.

    Attributes
    ----------
    x, y : float
        Pixels of the screen from the lower left corner of the plotter, as VTK counts.
    fine : bool
        Shift: move little for a large movement of the hand.
    along : bool
        Alt or Ctrl: move along the optical axis.
    """

    x: float
    y: float
    fine: bool = False
    along: bool = False


class Tool(Protocol):
    """Takes the left button for itself where it has something to do there, and some keys.

    Attributes
    ----------
    cursor : Qt.CursorShape
        What the pointer looks like.
    shows_net, shows_handles : bool
        Whether control points are shown, and handles of the source.
    keys : set of int
        The keys that are its own, of `Qt.Key`, without Ctrl and Alt.
    """

    cursor: Qt.CursorShape
    shows_net: bool
    shows_handles: bool
    keys: Set[int]

    @property
    def hint(self) -> str:
        """What can be done with it, in a line."""

    def press(self, at: Pointer) -> bool:
        """Begin a drag; False leaves the button to the camera."""

    def drag(self, at: Pointer) -> None:
        """Go on with it."""

    def press_key(self, key: int) -> None:
        """Begin what a key of its own does, as a drag."""

    def repeat_key(self, key: int, fine: bool) -> None:
        """Do it: right after the press, and again and again while the key is held."""

    def release(self) -> None:
        """End a drag, or what a key does."""

    def cancel(self) -> None:
        """Take it back; without a drag do nothing."""

    def hover(self, at: Pointer | None) -> None:
        """Show what a press would take; None once the pointer is elsewhere."""

    def turn_wheel(self, steps: int) -> None:
        """Become larger or smaller, if it has a size."""
