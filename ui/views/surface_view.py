"""A choice between the freeform faces of an optic."""

from typing import TYPE_CHECKING, BinaryIO

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout

from ui.views.image_view import ImageView
from ui.words import tr
from workbench.arrays import Array
from workbench.geometry.surface import freeform_nets
from workbench.pictures.axes import Column, Extent
from workbench.pictures.surface import ASPECTS, SurfaceImage
from workbench.scene import Element

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session


class FaceChoice(QComboBox):
    """Hidden while there is no choice: the optic has one freeform face."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(tr("Face"))
        self.setToolTip(tr("Which of the freeform faces of the lens is meant"))
        self.hide()

    @property
    def face(self) -> str:
        """The name of the chosen face; empty before an optic is known."""
        return str(self.currentData() or "")

    @property
    def needed(self) -> str:
        """What the chosen face is called; empty where the optic has one alone."""
        return self.currentText() if self.count() > 1 else ""

    def choose(self, face: str) -> None:
        """Choose one by its name."""
        self.setCurrentIndex(self.findData(face))

    def offer(self, optic: Element) -> None:
        """Let the faces of an optic be chosen; one that is chosen stays if it has that."""
        faces = list(freeform_nets(optic))
        if faces == [self.itemData(number) for number in range(self.count())]:
            return
        chosen = self.face if self.face in faces else optic.designed_face
        with QSignalBlocker(self):
            self.clear()
            for face in faces:
                name = tr(optic.face_in_words(face))
                self.addItem(f"{name[0].upper()}{name[1:]}", face)
            self.choose(chosen)
        self.setVisible(len(faces) > 1)


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
