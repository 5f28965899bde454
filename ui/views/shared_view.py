"""How a design is viewed: options that all views share, and what is picked in them."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

from PySide6.QtCore import QObject, Signal

from ui.document.frame import Frame
from workbench.analysis.shop_limits import Limits
from workbench.geometry.faces import ControlPoint
from workbench.pictures.surface import FaceColours
from workbench.scene import Scene

Part = tuple[float, float, float, float]
Place = tuple[float, float]
Line = tuple[Place, Place]


@dataclass(frozen=True)
class ViewOptions:
    """Options of images, then of the 3D view, then of both."""

    part: Part | None = None  # left, right, bottom, top; None for the whole
    pin: Place | None = None
    line: Line | None = None
    drawing: bool = False  # whether dragging draws a line
    marking: bool = False  # whether dragging and clicking mark regions
    draft: tuple[Place, ...] = ()  # outline of the region that is being drawn
    logarithmic: bool = False
    contours: bool | None = None  # lines of equal light; None where they help
    reference: Frame | None = None  # whose light is pinned, of this or another design

    rays: int = 15  # along each axis: a divisor of `ui.document.frame.RAYS`, or 0
    exploded: bool = False
    perspective: bool = False
    by_weight: bool = False
    faces: FaceColours = "material"
    exaggerated: bool = False
    limits: Limits = field(default_factory=Limits)

    colours: str = ""  # one of `workbench.pictures.axes.UNSIGNED`; by default that for the scene
    number: int = 0  # of the scene's image
    point: ControlPoint | None = None  # whose derivative is shown

    @property
    def of_scene(self) -> tuple[object, ...]:
        """Those that the 3D view follows."""
        drawn = self.rays, self.exploded, self.perspective, self.by_weight, self.faces
        return (*drawn, self.exaggerated, self.limits, self.colours, self.point)


class SharedView(QObject):
    """The options, and signals of what is picked; views know each other by this alone."""

    changed = Signal()
    pointed = Signal(object)  # tuple[float, float] or None
    pinned = Signal(object)  # tuple[float, float]
    drawn = Signal(object)  # tuple
    image_pinned = Signal(bool)
    regions_drawn = Signal(object, str)  # tuple of AnyRegion, str
    picked = Signal(object)  # ControlPoint

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.now = ViewOptions()

    def show(self, **changes: Any) -> None:
        now = replace(self.now, **changes)
        if now != self.now:
            self.now = now
            self.changed.emit()

    def slot(self, name: str) -> Callable[[Any], None]:
        return lambda value: self.show(**{name: value})

    def draw_line(self, on: bool) -> None:
        if on:
            self.mark_regions(False)
        self.show(drawing=on)

    def pin_image(self, frame: Frame | None) -> None:
        """Pin the light of a frame until another is pinned; None removes it."""
        self.show(reference=frame)
        self.image_pinned.emit(frame is not None)

    def mark_regions(self, on: bool) -> None:
        """Let dragging and clicking mark regions, or not."""
        self.show(marking=on, draft=(), drawing=self.now.drawing and not on)

    def number_in(self, scene: Scene) -> int:
        """Return the index of the shown image; the last one of a scene with fewer."""
        return min(self.now.number, len(scene.images) - 1)
