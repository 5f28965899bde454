"""Flight of a camera from where it stands to another view."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QEasingCurve, QVariantAnimation
from PySide6.QtWidgets import QStyle, QWidget

if TYPE_CHECKING:
    from workbench.pictures.camera import CameraState


class Flight(QVariantAnimation):
    """Calls ``move`` with both ends of a flight, and the part of it that is over."""

    def __init__(
        self, view: QWidget, move: "Callable[[CameraState, CameraState, float], object]"
    ) -> None:
        super().__init__(view, startValue=0.0, endValue=1.0)
        self._view, self._move = view, move
        self._ends: tuple[CameraState, CameraState] | None = None
        self.setEasingCurve(QEasingCurve.Type.InOutQuad)
        self.valueChanged.connect(self._go)

    def begin(self, before: "CameraState", after: "CameraState") -> None:
        """Fly; at once where nobody sees it."""
        self._ends = before, after
        self.stop()
        self.setDuration(flight_ms(self._view) if self._view.isVisible() else 0)
        self.start()

    def land(self) -> None:
        """End a flight where it leads to."""
        if self.state() is QVariantAnimation.State.Running:
            self.setCurrentTime(self.duration())

    def _go(self, part: float) -> None:
        if self._ends is not None:
            self._move(*self._ends, part)


def flight_ms(view: QWidget) -> int:
    """How long the camera flies to another view: as the style animates; 0 for not at all."""
    return view.style().styleHint(QStyle.StyleHint.SH_Widget_Animation_Duration, None, view)
