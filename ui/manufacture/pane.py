"""The dock Manufacture: computed only while it is visible and the design rests."""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from PySide6.QtCore import QSettings, QTimer, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QHBoxLayout

from ui.background import Background, Task
from ui.manufacture.figures import LimitFields, ManufactureFigures
from ui.panels.editors import Chooser
from ui.shown.frame import same_light, shows
from ui.views.image_view import ImageView
from ui.views.surface_view import FaceChoice
from ui.widgets.controls import SideBySide, filled
from ui.widgets.labels import Veil
from ui.words import later, tr
from workbench.analysis.manufacture import Manufacture, SurfaceMaps, manufacture, surface_maps
from workbench.analysis.manufacture_limits import Limits
from workbench.arrays import Array
from workbench.geometry.surface import even_counts, freeform_nets
from workbench.pictures.axes import Extent
from workbench.pictures.manufacture import MAPS, draw_map, map_unit

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes

    from ui.shown.frame import Frame
    from workbench.files.session import Session

_REST_MS = 250  # longer than between two steps of a hand
_PLACES = 193  # of a map along the longer side of the lens
_TIPS = later(
    (
        "Thickness along z",
        "Angle between the face and a plane across the axis",
        "Largest concave curvature; zero where there is none",
        "Largest convex curvature; zero where there is none",
    )
)


class _DrawnMap(NamedTuple):
    values: Array
    artists: tuple[()] = ()

    def update(self, _: Array) -> bool:
        return False


class FaceMap(ImageView):
    """Map of a face, one of `MAPS`."""

    _WAITING = later("Computed when the design rests…")

    def __init__(self) -> None:
        super().__init__()
        self._name = next(iter(MAPS))
        self._limits = Limits()
        self._chosen: SurfaceMaps | None = None
        self._maps: Mapping[str, SurfaceMaps] = {}
        self.faces = FaceChoice()
        self.faces.currentIndexChanged.connect(self._choose)
        self.chooser = Chooser()
        self.chooser.setAccessibleName(tr("What the map shows"))
        for name in MAPS:
            self.chooser.addItem(tr(name), name)
        self.chooser.currentIndexChanged.connect(self._turn)
        row = filled(QHBoxLayout(), self.faces, self.chooser, margins=(6, 4, 6, 0))
        self._box.insertLayout(0, row)
        self._turn(0)

    def show_maps(self, frame: "Frame", maps: "Mapping[str, SurfaceMaps]") -> None:
        """Show the maps of a frame, by face."""
        self._maps = maps
        self.faces.offer(frame.session.scene)
        self.show_frame(frame)
        self._choose()

    def show_limits(self, limits: Limits) -> None:
        if limits != self._limits:
            self._limits = limits
            self._begin_anew()

    def show_nothing(self, session: "Session") -> None:
        self._maps, self._chosen = {}, None
        super().show_nothing(session)

    def _choose(self) -> None:
        self._chosen = self._maps.get(self.faces.face)
        self._begin_anew()

    def _turn(self, number: int) -> None:
        self._name = self.chooser.currentData()
        self.chooser.setToolTip(
            f"<p>{tr(_TIPS[number])}{tr('; hatched where a limit is exceeded')}</p>"
        )
        self._begin_anew()

    def _new_image(self, axes: "Axes", session: "Session") -> "_DrawnMap":
        if self._chosen is None:
            return _DrawnMap(np.zeros((1, 1)))
        unit = session.scene.unit
        return _DrawnMap(draw_map(axes, self._name, self._chosen, self._limits, unit))

    def _shown_array(self, frame: "Frame") -> Array:
        return np.zeros((1, 1))  # the map is drawn at the beginning

    def _extent(self, session: "Session") -> Extent:
        optic = session.scene.focused_on(self.faces.face).optic
        return Extent.around(optic.half_width, session.scene.unit)

    def _unit(self, session: "Session") -> str:
        return map_unit(self._name, session.scene.unit).removeprefix("1 ")


class _Found(NamedTuple):
    frame: "Frame"
    figures: dict[str, Manufacture]  # by the names of elements
    maps: dict[str, SurfaceMaps]


class ManufacturePane(SideBySide):
    """Map, figures and limits of the shown lens."""

    cut_asked = Signal()

    def __init__(self, settings: QSettings) -> None:
        face_map = FaceMap()
        fields = LimitFields(settings, face_map)
        figures = ManufactureFigures(fields)
        super().__init__(face_map, figures, (figures.cut,))
        self.map, self._fields, self._figures = face_map, fields, figures
        figures.cut.clicked.connect(self.cut_asked)
        self.setFocusProxy(face_map)
        self._frame: Frame | None = None
        self._found: _Found | None = None
        self._resting = True
        self._of_another = False  # whether the frame is of another design
        self._veil = Veil(self)
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._compute)
        self._background = Background(later("analysis of the face"), self)
        self._background.done.connect(self._take)
        self._background.failed.connect(figures.say)
        self._fields.changed.connect(self.map.show_limits)
        self.map.faces.currentIndexChanged.connect(self._show_figures)

    def show_design(self, session: "Session") -> None:
        self._fields.show_scene(session.scene)
        self.map.show_design(session)
        if self._frame is not None and not shows(self._frame, session):  # nobody waits for it
            self._rest.stop()
            self._background.cancel()

    def show_outdated(self, outdated: bool) -> None:
        self._of_another = outdated
        self._show_veil()

    def show_frame(self, frame: "Frame") -> None:
        self._frame = frame
        self.look()

    def show_nothing(self, session: "Session") -> None:
        self._frame = self._found = None
        self._rest.stop()
        self.map.show_nothing(session)
        self._figures.show_nothing()
        self._figures.say("")
        self._show_veil()

    def allow(self, resting: bool) -> None:
        """Compute only while the shown lens is final."""
        self._resting = resting
        self.look()

    def look(self) -> None:
        """Compute after a short delay, if needed and visible."""
        self._show_veil()
        if self._frame is None:
            return
        if self._known:
            self._figures.say("")
            return
        if self._found is not None:
            self._figures.say(tr("Outdated; recomputed when the design rests."))
        if self._resting and self.isVisible():
            self._rest.start()
        else:
            self._rest.stop()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.look()

    def close_thread(self) -> None:
        self._frame = None
        self._rest.stop()
        self._background.close()

    @property
    def _known(self) -> bool:
        frame, found = self._frame, self._found
        return frame is not None and found is not None and same_light(found.frame, frame)

    def _show_veil(self) -> None:
        behind = self._found is not None and not self._known
        self._veil.cover(self._of_another or behind)

    def _compute(self) -> None:
        frame = self._frame
        # One behind another tab is not hidden, but nothing of it is seen.
        if frame is None or self._background.busy or self.visibleRegion().isEmpty():
            return
        optics, heights = frame.session.scene.optics, frame.state.heights

        def work(task: Task) -> _Found:
            maps = {
                face: surface_maps(optic, heights, even_counts(optic.half_width, _PLACES), face)
                for optic in optics
                for face in freeform_nets(optic)
            }
            return _Found(frame, {each.name: manufacture(each, heights) for each in optics}, maps)

        self._background.begin(work)

    def _take(self, _: None, found: _Found) -> None:
        if self._frame is None:
            return
        if same_light(found.frame, self._frame):
            self._found = found
            self.map.show_maps(found.frame, found.maps)
            self._show_figures()
        self.look()

    def _show_figures(self) -> None:
        if self._found is not None:
            scene = self._found.frame.session.scene
            name = scene.focused_on(self.map.faces.face).optic.name
            self._figures.show_found(self._found.figures[name], scene.unit)
