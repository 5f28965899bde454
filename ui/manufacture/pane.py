"""The dock that says whether a shop can make the lens on show.

1. Figures and maps are computed only for eyes: never while the pane cannot be seen.
2. They follow the lens when it rests: not while a run brings frame after frame, and a moment after
   the last step of whoever turns or drags something.
"""

from typing import TYPE_CHECKING, NamedTuple

from PySide6.QtCore import QSettings, QTimer, Signal
from PySide6.QtGui import QShowEvent

from ui.manufacture.face_map import FaceMap
from ui.manufacture.figures import ManufactureFigures
from ui.manufacture.limits import LimitFields
from ui.shown.frame import same_light, shows
from ui.threads.background import Background, Task
from ui.threads.failure import sentence_of
from ui.widgets.side_by_side import SideBySide
from ui.widgets.veil import Veil
from ui.words import tr
from workbench.analysis.manufacture import Manufacture, SurfaceMaps, manufacture, surface_maps
from workbench.geometry.surface import even_counts

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.files.session import Session

_REST_MS = 250  # longer than between two steps of a hand
_PLACES = 193  # of a map along the longer side of the lens


class _Found(NamedTuple):
    """What was asked about, and what was found."""

    frame: "Frame"
    figures: Manufacture
    maps: dict[str, SurfaceMaps]


class ManufacturePane(SideBySide):
    """Map, figures and limits of the lens on show.

    Attributes
    ----------
    map : FaceMap
        Its picture.
    cut_asked : Signal()
        A person wants to have the face cut.
    """

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
        self._background = Background("look at the face", self)
        self._background.done.connect(self._take)
        self._background.failed.connect(
            lambda _, error: figures.say(sentence_of(error, tr("look at the face")))
        )
        self._fields.changed.connect(self.map.show_limits)

    def show_design(self, session: "Session") -> None:
        """Take unit and own limits of a design."""
        self._fields.show_scene(session.scene)
        self.map.show_design(session)
        if self._frame is not None and not shows(self._frame, session):  # nobody waits for it
            self._rest.stop()
            self._background.cancel()

    def show_outdated(self, outdated: bool) -> None:
        """Mark map and figures as those of another design, or no longer."""
        self._of_another = outdated
        self._show_veil()

    def show_frame(self, frame: "Frame") -> None:
        """Take note of another lens."""
        self._frame = frame
        self.look()

    def show_nothing(self, session: "Session") -> None:
        """Take note that there is no lens to show."""
        self._frame = self._found = None
        self._rest.stop()
        self.map.show_nothing(session)
        self._figures.show_nothing()
        self._figures.say("")
        self._show_veil()

    def allow(self, resting: bool) -> None:
        """Whether the lens on show stays as it is; while it does not, nothing is computed."""
        self._resting = resting
        self.look()

    def look(self) -> None:
        """Look at the lens in a moment, if that is not done and somebody sees it."""
        self._show_veil()
        if self._frame is None:
            return
        if self._known:
            self._figures.say("")
            return
        if self._found is not None:
            self._figures.say(tr("Out of date: of the lens before; computed anew when it rests."))
        if self._resting and self.isVisible():
            self._rest.start()
        else:
            self._rest.stop()

    def showEvent(self, event: QShowEvent) -> None:
        """Compute what came while hidden."""
        super().showEvent(event)
        self.look()

    def close_thread(self) -> None:
        """Wait for what is under way; nothing is computed any more. Safe to call twice."""
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
        optic = frame.session.scene.optic
        heights, count = frame.state.heights, even_counts(optic.half_width, _PLACES)

        def work(task: Task) -> _Found:
            maps = {face: surface_maps(optic, heights, count, face) for face in heights}
            return _Found(frame, manufacture(optic, heights), maps)

        self._background.begin(work)

    def _take(self, _: None, found: _Found) -> None:
        if self._frame is None:
            return
        if same_light(found.frame, self._frame):
            self._found = found
            self._figures.show_found(found.figures, found.frame.session.scene.unit)
            self.map.show_maps(found.frame, found.maps)
        self.look()
