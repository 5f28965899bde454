"""How the error changes with the distance of the screen, below the image there."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QSizePolicy

from ui.views.canvas import PlotCanvas
from ui.views.view import View
from ui.widgets.plot_words import translate
from ui.words import tr
from workbench.pictures.error_curves import FocusCurve

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.files.session import Session

_LINES = 8  # of text, as high as it is beside an image


class FocusCurveView(View):
    """Small plot of errors that grows as traces arrive."""

    def __init__(self) -> None:
        super().__init__()
        self._canvas = PlotCanvas(self, bar=False)
        self._box.addWidget(self._canvas)
        self.setMinimumHeight(self.sizeHint().height())
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Expanding)
        self.setToolTip(tr("Relative L2 error against the distance; the dotted line is the screen"))
        self._ends = (0.0, 1.0)
        self._z = 0.0
        self._errors: dict[float, float] = {}
        self._curve: FocusCurve | None = None

    def sizeHint(self) -> QSize:
        """Some lines of text high."""
        return QSize(super().sizeHint().width(), _LINES * self.fontMetrics().lineSpacing())

    @property
    def errors(self) -> list[tuple[float, float]]:
        """Shown distances and errors."""
        return sorted(self._errors.items())

    def begin(self, session: "Session", ends: tuple[float, float]) -> None:
        """Remove all errors, for another lens."""
        self._ends, self._errors, self._curve = ends, {}, None
        self.show_design(session)

    def add(self, z: float, error: float) -> None:
        """Add an error."""
        self._errors[z] = error
        self._ask()

    def mark(self, z: float) -> None:
        """Mark the shown distance."""
        self._z = z
        self._ask()

    def _draw(self, session: "Session", frame: "Frame | None") -> None:
        if self._curve is None:
            self._curve = FocusCurve(self._canvas.begin(), session.scene, self._ends)
            self._canvas.animate([self._curve.mark])
            translate(self._canvas.figure)
        self._canvas.show_changes(self._curve.update(self.errors, self._z))

    def _recolour(self) -> None:
        self._canvas.recolour()
