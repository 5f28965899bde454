"""State shared by images of the receiver (visible part, marked points and lines), and an image."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from workbench.pictures.images import LIGHT

if TYPE_CHECKING:
    from workbench.scene import Scene

Part = tuple[float, float, float, float]
Place = tuple[float, float]
Line = tuple[Place, Place]


class ImageLink(QObject):
    """Keeps images of the same receiver in step."""

    changed = Signal()
    pointed = Signal(object)
    pinned = Signal(object)
    drawn = Signal(object)
    regions_drawn = Signal(object, str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.part: Part | None = None  # left, right, bottom, top; None for the whole
        self.pin: Place | None = None
        self.line: Line | None = None
        self.drawing = False  # whether dragging draws a line
        self.marking = False  # whether dragging and clicking mark regions
        self.draft: tuple[Place, ...] = ()  # outline of the region that is being drawn
        self.logarithmic = False
        self.colours = LIGHT
        self.number = 0  # of the scene's image that is seen

    def show_part(self, part: Part | None) -> None:
        """Show another part."""
        self._set("part", part)

    def show_pin(self, place: Place | None) -> None:
        """Mark a point; None removes it."""
        self._set("pin", place)

    def show_line(self, line: Line | None) -> None:
        """Mark a line; None removes it."""
        self._set("line", line)

    def set_drawing(self, drawing: bool) -> None:
        """Let dragging draw a line, or pan."""
        if drawing:
            self.set_marking(False)
        self._set("drawing", drawing)

    def set_marking(self, marking: bool) -> None:
        """Let the mouse mark regions, or not."""
        if marking:
            self.set_drawing(False)
        self.show_draft(())
        self._set("marking", marking)

    def show_draft(self, outline: "tuple[Place, ...]") -> None:
        """Show the outline of a region being drawn; None removes it."""
        self._set("draft", outline)

    def set_logarithmic(self, logarithmic: bool) -> None:
        """Show light on a logarithmic or linear scale."""
        self._set("logarithmic", logarithmic)

    def set_colours(self, colours: str) -> None:
        """Show light in one of `workbench.pictures.axes.UNSIGNED`."""
        self._set("colours", colours)

    def show_image(self, number: int) -> None:
        """Show another image of the scene; 0 is the first."""
        self._set("number", number)

    def number_in(self, scene: "Scene") -> int:
        """Index of the shown image in a scene: the last one if it has fewer."""
        return min(self.number, len(scene.further_images))

    def _set(self, name: str, value: object) -> None:
        if value != getattr(self, name):
            setattr(self, name, value)
            self.changed.emit()
