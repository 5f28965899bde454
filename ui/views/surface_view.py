"""Map of a freeform face."""

from typing import TYPE_CHECKING, BinaryIO

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout

from ui.views.face_choice import FaceChoice
from ui.views.image_view import ImageView
from ui.words import tr
from workbench.arrays import Array
from workbench.pictures.axes import Column, Extent
from workbench.pictures.surface import ASPECTS, SurfaceImage

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


_FONT = 9  # of the name of a face in files


class SurfaceContent:
    """Height over the base, slope or a curvature of a face."""

    image: SurfaceImage
    aspect = ASPECTS[0]

    def __init__(self, faces: FaceChoice) -> None:
        self._faces = faces

    def extent(self, session: "Session") -> Extent:
        """The whole element."""
        return Extent.around(session.scene.optic.half_width, session.scene.unit)

    def begin(self, axes: "Axes", session: "Session") -> "Sequence[Artist]":
        """Begin an empty map."""
        self._faces.offer(session.scene.optic)
        self.image = SurfaceImage(axes, session.scene, self.aspect, self._faces.face)
        return self.image.artists

    def change(self, frame: "Frame") -> bool:
        """Show the face of a frame."""
        return self.image.update(frame.state.heights[self._faces.face])

    def values(self, frame: "Frame") -> Array:
        """Values of the map."""
        return self.image.values

    def unit(self, session: "Session") -> str:
        """Unit of the quantity."""
        return self.aspect.unit.format(session.scene.unit).removeprefix("1 ")


class SurfaceView(ImageView):
    """Map of a face and a quantity, both chosen above it."""

    _content: SurfaceContent

    def __init__(self) -> None:
        self._faces = FaceChoice()
        super().__init__(SurfaceContent(self._faces))
        self._aspects = QComboBox()
        self._aspects.setAccessibleName(tr("What the map shows"))
        for number, aspect in enumerate(ASPECTS):
            name = tr(aspect.name)
            self._aspects.addItem(name[0].upper() + name[1:])
            self._aspects.setItemData(number, tr(aspect.tip), Qt.ItemDataRole.ToolTipRole)
        self._aspects.currentIndexChanged.connect(self._turn)
        self._faces.currentIndexChanged.connect(self._begin_anew)
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 0)
        row.addWidget(self._faces)
        row.addWidget(self._aspects)
        row.addStretch(1)
        self._box.insertLayout(0, row)
        self._turn()

    def write(self, file: BinaryIO, format: str) -> None:
        """Write the plot as "png" or "svg", named by the face if there are two."""
        if self._axes is not None:
            self._axes.set_title(self._faces.needed, loc="left", fontsize=_FONT)
        super().write(file, format)
        if self._axes is not None:
            self._axes.set_title("", loc="left")
            self._canvas.draw_idle()

    def data(self) -> list[Column]:
        """Data of the map, named by the face if there are two."""
        columns, face = super().data(), self._faces.needed
        if face:
            columns[-1] = columns[-1]._replace(name=f"{face}: {columns[-1].name}")
        return columns

    def _turn(self) -> None:
        self._content.aspect = aspect = ASPECTS[self._aspects.currentIndex()]
        self._aspects.setToolTip(f"<p>{tr(aspect.tip)}</p>")
        self._begin_anew()
