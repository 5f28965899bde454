"""Maps of a freeform face."""

from typing import TYPE_CHECKING, BinaryIO

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout

from ui.views.choices import FaceChoice
from ui.views.image_view import ImageView
from ui.widgets.controls import STRETCH, filled
from ui.words import tr
from workbench.arrays import Array
from workbench.pictures.axes import Column, Extent
from workbench.pictures.surface import ASPECTS, SurfaceImage

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ui.document.frame import Frame
    from workbench.files.session import Session


_FONT = 9  # of the name of a face in files


class SurfaceView(ImageView):
    """Map of a face and a quantity, both chosen above it."""

    _image: SurfaceImage
    _aspect = ASPECTS[0]

    def __init__(self) -> None:
        super().__init__()
        self._faces = FaceChoice()
        self._aspects = QComboBox()
        self._aspects.setAccessibleName(tr("What the map shows"))
        for number, aspect in enumerate(ASPECTS):
            name = tr(aspect.name)
            self._aspects.addItem(name[0].upper() + name[1:])
            self._aspects.setItemData(number, tr(aspect.tip), Qt.ItemDataRole.ToolTipRole)
        self._aspects.currentIndexChanged.connect(self._turn)
        self._faces.currentIndexChanged.connect(self._begin_anew)
        row = filled(QHBoxLayout(), self._faces, self._aspects, STRETCH, margins=(6, 4, 6, 0))
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
        self._aspect = ASPECTS[self._aspects.currentIndex()]
        self._aspects.setToolTip(f"<p>{tr(self._aspect.tip)}</p>")
        self._begin_anew()

    def _extent(self, session: "Session") -> Extent:
        optic = session.scene.focused_on(self._faces.face).optic
        return Extent.around(optic.half_width, session.scene.unit)

    def _unit(self, session: "Session") -> str:
        return self._aspect.unit.format(session.scene.unit).removeprefix("1 ")

    def _new_image(self, axes: "Axes", session: "Session") -> SurfaceImage:
        self._faces.show_scene(session.scene)
        return SurfaceImage(axes, session.scene, self._aspect, self._faces.face)

    def _shown_array(self, frame: "Frame") -> Array:
        return frame.state.heights[self._faces.face]
