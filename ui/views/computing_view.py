"""What views have in common that compute something of their own: never while nobody sees them."""

from typing import TYPE_CHECKING

from PySide6.QtGui import QHideEvent, QShowEvent

from ui.shown.frame import shows
from ui.views.view import View

if TYPE_CHECKING:
    from workbench.files.session import Session


class ComputingView(View):
    """Says when there is something to compute, and when no longer.

    The last among the bases of a view: PySide looks for signals along the first.
    """

    _covered = False

    def show_design(self, session: "Session") -> None:
        """Compute nothing for a design that was left."""
        super().show_design(session)
        if self._frame is not None and not shows(self._frame, session):
            self._want_nothing()

    def uncover(self, uncovered: bool) -> None:
        """Compute, or not; a dock behind another tab is not hidden, but covered."""
        self._covered = not uncovered
        if uncovered:
            self._want()
        else:
            self._want_nothing()

    def showEvent(self, event: QShowEvent) -> None:
        """Compute what came while hidden."""
        super().showEvent(event)
        self._want()

    def hideEvent(self, event: QHideEvent) -> None:
        """Compute nothing that nobody sees."""
        self._want_nothing()
        super().hideEvent(event)

    def _seen(self) -> bool:
        """Whether there is a lens, and eyes for it."""
        return self._frame is not None and self.isVisible() and not self._covered

    def _want(self) -> None:
        """What is shown may be of another lens."""

    def _want_nothing(self) -> None:
        """Drop what is being computed."""
