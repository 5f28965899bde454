"""What several images of the screen have in common: the part that is seen, and places on it."""

from PySide6.QtCore import QObject, Signal

Part = tuple[float, float, float, float]
Place = tuple[float, float]


class ImageLink(QObject):
    """Keeps images of the same screen in step.

    Attributes
    ----------
    changed : Signal()
        Another part is seen, or in another scale, or another place is pinned.
    pointed : Signal(tuple[float, float] or None)
        Where the mouse is, scene units; None beside all images.
    pinned : Signal(tuple[float, float])
        A place was clicked.
    """

    changed = Signal()
    pointed = Signal(object)
    pinned = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.part: Part | None = None  # left, right, bottom, top; None for the whole screen
        self.pin: Place | None = None
        self.logarithmic = False

    def show_part(self, part: Part | None) -> None:
        """See another part of the screen."""
        if part != self.part:
            self.part = part
            self.changed.emit()

    def show_pin(self, place: Place | None) -> None:
        """Mark a place, or none."""
        if place != self.pin:
            self.pin = place
            self.changed.emit()

    def set_logarithmic(self, logarithmic: bool) -> None:
        """Show light in a logarithmic scale, or in an even one."""
        if logarithmic != self.logarithmic:
            self.logarithmic = logarithmic
            self.changed.emit()
