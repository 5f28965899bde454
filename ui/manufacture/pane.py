"""The dock Manufacture: computed only while it is visible and the design rests."""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from matplotlib.axes import Axes
from PySide6.QtCore import QSettings
from PySide6.QtGui import QAction

from ui.background import Task
from ui.document.frame import Frame
from ui.manufacture.figures import ManufactureFigures
from ui.views.surface_view import FaceMapView
from ui.views.view import ComputingView, Request
from ui.widgets.controls import SideBySide, command_button
from ui.words import later, tr
from workbench.analysis.manufacture import Manufacture, SurfaceMaps, manufacturing, surface_maps
from workbench.analysis.shop_limits import Limits
from workbench.arrays import Array
from workbench.files.session import Session
from workbench.geometry.surface import even_counts, freeform_nets
from workbench.pictures.axes import Extent
from workbench.pictures.manufacture import MAPS, draw_map, map_unit
from workbench.progress import finished, of_equal, within

_LATER = later("Computed when the design rests…")
_PLACES = 193  # of a map along the longer side of the lens
_TIPS = later(
    (
        "Thickness along z",
        "Angle between the face and a plane across the axis",
        "Largest concave curvature; zero where there is none",
        "Largest convex curvature; zero where there is none",
        "Red and hatched where a limit is exceeded, green elsewhere",
    )
)


class _DrawnMap(NamedTuple):
    values: Array
    extent: Extent
    unit: str

    def update(self, _: Array) -> None:
        """Leave the map as it was drawn."""


class FaceMap(FaceMapView):
    """Map of a face, one of `MAPS`."""

    def __init__(self) -> None:
        self._limits, self._awaited = Limits(), tr(_LATER)
        self._maps: Mapping[str, SurfaceMaps] = {}
        hatched = [*(len(MAPS) - 1) * [tr("; hatched where a limit is exceeded")], ""]
        names = zip(MAPS, _TIPS, hatched, strict=True)
        super().__init__([(tr(name), f"{tr(tip)}{more}") for name, tip, more in names])

    def show_maps(self, frame: Frame, maps: Mapping[str, SurfaceMaps]) -> None:
        self._maps = maps
        self.faces.show_scene(frame.session.scene)
        self.show_frame(frame)
        self._choose()

    def wait(self, why: str) -> None:
        """Say why there is no map yet."""
        self._awaited = why
        if self._frame is None:
            self._ask()

    def show_limits(self, limits: Limits) -> None:
        if limits != self._limits:
            self._limits = limits
            self._begin_anew()

    def show_nothing(self, session: Session) -> None:
        self._maps = {}
        super().show_nothing(session)

    def _why_empty(self, frame: Frame | None) -> str:
        return "" if frame is not None else self._awaited

    def _new_image(self, axes: Axes, session: Session) -> "_DrawnMap":
        name, unit, maps = MAPS[self.quantity], session.scene.unit, self._maps.get(self.faces.face)
        extent = Extent.around(session.scene.focused_on(self.faces.face).optic.half_width, unit)
        values = np.zeros((1, 1))
        if maps is not None:
            values = draw_map(axes, name, maps, self._limits, unit)
        shown_unit = map_unit(name, unit).removeprefix("1 ") or tr("exceeded")
        return _DrawnMap(values, extent, shown_unit)

    def _shown_array(self, frame: Frame) -> Array:
        return np.zeros((1, 1))  # the map is drawn at the beginning


class _Found(NamedTuple):
    figures: dict[str, Manufacture]  # by the names of elements
    maps: dict[str, SurfaceMaps]


class ManufacturePane(ComputingView):
    """Map, figures and limits of the shown lens, and buttons for commands that make the part."""

    _WORK, _TITLE = later("analysis of the face"), later("Analysis of the face")

    _answer: _Found | None

    def __init__(self, settings: QSettings, commands: Sequence[QAction]) -> None:
        super().__init__()
        self.map, self.figures = FaceMap(), ManufactureFigures(settings)
        buttons = [command_button(command) for command in commands]
        self._box.addWidget(SideBySide(self.map, self.figures, buttons))
        self.setFocusProxy(self.map)
        self.figures.limits_changed.connect(self.map.show_limits)
        self.map.faces.currentIndexChanged.connect(self._show_figures)

    def show_design(self, session: Session) -> None:
        self.figures.show_scene(session.scene)
        self.map.show_design(session)
        super().show_design(session)

    def show_nothing(self, session: Session) -> None:
        super().show_nothing(session)
        self.map.show_nothing(session)
        self.figures.show_nothing()
        self.figures.show_remark("")

    def _compute(self) -> None:
        # One behind another tab is not hidden, but nothing of it is seen.
        if not self.visibleRegion().isEmpty():
            super()._compute()

    @staticmethod
    def _work(request: Request, task: Task) -> _Found:
        optics, heights = request.frame.session.scene.optics, request.frame.state.heights
        maps = {
            face: surface_maps(optic, heights, even_counts(optic.half_width, _PLACES), face)
            for optic in optics
            for face in freeform_nets(optic)
        }
        figures = {}
        for number, optic in enumerate(optics):
            steps = within(manufacturing(optic, heights), partial(of_equal, len(optics), number))
            figures[optic.name] = finished(steps, task.report)
        return _Found(figures, maps)

    def _store(self, request: Request, answer: _Found) -> None:
        super()._store(request, answer)
        self.map.show_maps(request.frame, answer.maps)
        self._show_figures()

    def _fail(self, sentence: str) -> None:
        self.figures.show_remark(sentence)

    def _show_state(self) -> None:
        self.map.wait(tr("Computing…") if self.background.busy else tr(_LATER))
        if self.background.busy:
            self.figures.show_remark(tr("Computing the figures…"))
        else:
            outdated = tr("Outdated; recomputed when the design rests.")
            self.figures.show_remark(outdated if self._is_behind() else "")

    def _show_figures(self) -> None:
        if self._answered is not None and self._answer is not None:
            scene = self._answered.frame.session.scene
            name = scene.focused_on(self.map.faces.face).optic.name
            self.figures.show_found(self._answer.figures[name], scene.unit)
