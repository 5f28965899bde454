"""What several images of the screen have in common: the part that is seen, and places on it."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QSignalBlocker, Signal
from PySide6.QtWidgets import QComboBox

from ui.shown.frame import image_titles
from ui.words import tr
from workbench.pictures.images import LIGHT

if TYPE_CHECKING:
    from workbench.scene import Scene

Part = tuple[float, float, float, float]
Place = tuple[float, float]
Line = tuple[Place, Place]


class ImageLink(QObject):
    """Shared state of the images of a receiver."""

    changed = Signal()
    pointed = Signal(object)  # tuple[float, float] or None
    pinned = Signal(object)  # tuple[float, float]
    drawn = Signal(object)  # tuple
    regions_drawn = Signal(object, str)  # tuple of AnyRegion, str

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
        self._set("part", part)

    def show_pin(self, place: Place | None) -> None:
        """Mark a place, or none."""
        self._set("pin", place)

    def show_line(self, line: Line | None) -> None:
        """Mark a line, or none."""
        self._set("line", line)

    def set_drawing(self, drawing: bool) -> None:
        """Let dragging draw a line, or move what is seen."""
        if drawing:
            self.set_marking(False)
        self._set("drawing", drawing)

    def set_marking(self, marking: bool) -> None:
        """Let dragging and clicking mark regions, or not."""
        if marking:
            self.set_drawing(False)
        self.show_draft(())
        self._set("marking", marking)

    def show_draft(self, outline: "tuple[Place, ...]") -> None:
        """Show the outline of a region that is being drawn, or none."""
        self._set("draft", outline)

    def set_logarithmic(self, logarithmic: bool) -> None:
        """Show light in a logarithmic scale, or in an even one."""
        self._set("logarithmic", logarithmic)

    def set_colours(self, colours: str) -> None:
        """Show light in one of `workbench.pictures.axes.UNSIGNED`."""
        self._set("colours", colours)

    def show_image(self, number: int) -> None:
        self._set("number", number)

    def number_in(self, scene: "Scene") -> int:
        """Return the index of the shown image; the last one of a scene with fewer."""
        return min(self.number, len(scene.images) - 1)

    def _set(self, name: str, value: object) -> None:
        if value != getattr(self, name):
            setattr(self, name, value)
            self.changed.emit()


class ImageChoice(QComboBox):
    """Choice of an image of the scene, shared by views with the same link."""

    def __init__(self, link: ImageLink) -> None:
        super().__init__()
        self._link = link
        self.setAccessibleName(tr("Image that is shown"))
        self.setToolTip(tr("Choose the image to show"))
        self.activated.connect(link.show_image)
        self.hide()

    def show_scene(self, scene: "Scene") -> None:
        """Offer the images of a scene; hidden if there is only one."""
        titles = image_titles(scene)
        with QSignalBlocker(self):
            if titles != [self.itemText(number) for number in range(self.count())]:
                self.clear()
                self.addItems(titles)
            self.setCurrentIndex(self._link.number_in(scene))
        self.setVisible(len(titles) > 1)
