"""Maps of a freeform face."""

from collections.abc import Sequence
from typing import BinaryIO

from matplotlib.axes import Axes
from PySide6.QtCore import Qt

from ui.document.frame import Frame
from ui.views.choices import FaceChoice
from ui.views.image_view import ImageView
from ui.widgets.controls import Chooser, named
from ui.words import capitalised, tr
from workbench.arrays import Array
from workbench.files.session import Session
from workbench.pictures.axes import Column
from workbench.pictures.surface import ASPECTS, SurfaceImage

_FONT = 9  # of the name of a face in files


class FaceMapView(ImageView):
    """Map of a face and a quantity, both chosen below it; a quantity has a name and a tip."""

    def __init__(self, quantities: Sequence[tuple[str, str]]) -> None:
        super().__init__()
        titles = {number: capitalised(name) for number, (name, _) in enumerate(quantities)}
        self.faces, self.chooser = FaceChoice(), named(Chooser(titles), tr("What the map shows"))
        self.chooser.setMinimumContentsLength(max(map(len, titles.values())))
        for number, (_, tip) in enumerate(quantities):
            self.chooser.setItemData(number, f"<p>{tip}</p>", Qt.ItemDataRole.ToolTipRole)
        self.faces.currentIndexChanged.connect(self._choose)
        self.chooser.currentIndexChanged.connect(self._choose)
        for number, choice in enumerate((self.faces, self.chooser)):
            self._bottom.insertWidget(number, choice)
        self._choose()

    @property
    def quantity(self) -> int:
        return self.chooser.currentIndex()

    def _choose(self) -> None:
        self.chooser.setToolTip(self.chooser.currentData(Qt.ItemDataRole.ToolTipRole))
        self._begin_anew()


class SurfaceView(FaceMapView):
    """Map of heights, slopes or curvatures."""

    _image: SurfaceImage

    def __init__(self) -> None:
        super().__init__([(tr(aspect.name), tr(aspect.tip)) for aspect in ASPECTS])

    def write(self, file: BinaryIO, format: str) -> None:
        """Write the plot as "png" or "svg", named by the face if there are two."""
        for axes in self._canvas.figure.axes:
            axes.set_title(self.faces.needed, loc="left", fontsize=_FONT)
        super().write(file, format)

    def data(self) -> list[Column]:
        """Data of the map, named by the face if there are two."""
        columns, face = super().data(), self.faces.needed
        if face:
            columns[-1] = columns[-1]._replace(name=f"{face}: {columns[-1].name}")
        return columns

    def _new_image(self, axes: Axes, session: Session) -> SurfaceImage:
        self.faces.show_scene(session.scene)
        return SurfaceImage(axes, session.scene, ASPECTS[self.quantity], self.faces.face)

    def _shown_array(self, frame: Frame) -> Array:
        return frame.state.heights[self.faces.face]
