"""What all views have in common: they keep the latest and draw it when it can be seen."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ui.views.drawing_queue import drawing_queue
from ui.widgets.veil import Veil

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.files.session import Session


class View(QWidget):
    """Shows one aspect of the design.

    The first frame of another design replaces the old picture. Until then the old one is greyed and
    marked as outdated.
    """

    def __init__(self) -> None:
        super().__init__()
        self._session: Session | None = None
        self._frame: Frame | None = None
        self._to_draw = False
        self._box = QVBoxLayout(self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self._of_another = False  # whether the frame is of another design
        self._veil = Veil(self)

    @property
    def outdated(self) -> bool:
        """Whether the picture is marked as outdated."""
        return not self._veil.isHidden()

    def add_below(self, widget: QWidget) -> None:
        """Add a widget below the picture."""
        self._box.addWidget(widget)

    def show_design(self, session: "Session") -> None:
        """Store another scene or target."""
        self._session = session
        if self._frame is None:
            self._ask()

    def show_frame(self, frame: "Frame") -> None:
        """Show a frame of a run or a preview."""
        self._frame = frame
        self._ask()

    def show_nothing(self, session: "Session") -> None:
        """Show a design without a frame."""
        self._session, self._frame = session, None
        self._show_veil()
        self._ask()

    def show_outdated(self, outdated: bool) -> None:
        """Mark the picture as outdated, or remove the mark."""
        self._of_another = outdated
        self._show_veil()

    def draw_now(self) -> None:
        """Draw now, if needed and visible."""
        if not self._to_draw or not self.isVisible() or self.window().isMinimized():
            return
        session = self._session if self._frame is None else self._frame.session
        if session is not None:
            self._to_draw = False
            self._draw(session, self._frame)

    def is_dark(self) -> bool:
        """Whether text is brighter than the background."""
        palette = self.palette()
        return palette.windowText().color().lightness() > palette.window().color().lightness()

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what came while hidden."""
        super().showEvent(event)
        if self._to_draw:
            drawing_queue().ask(self)

    def hideEvent(self, event: QHideEvent) -> None:
        """Do not draw while hidden."""
        drawing_queue().leave(self)
        super().hideEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        """Follow changes of the palette."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._recolour()
            self._ask()

    def _ask(self) -> None:
        self._to_draw = True
        if self.isVisible():
            drawing_queue().ask(self)

    def _show_veil(self) -> None:
        self._veil.cover(self._of_another or self._is_behind())

    def _is_behind(self) -> bool:
        return False

    def _draw(self, session: "Session", frame: "Frame | None") -> None: ...

    def _recolour(self) -> None: ...
