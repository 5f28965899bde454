"""Views, the base of all: store the latest frame, and draw or compute only while visible."""

from typing import TYPE_CHECKING

from PySide6.QtGui import QHideEvent, QShowEvent

from ui.shown.frame import shows
from ui.views.view import View

if TYPE_CHECKING:
    from workbench.files.session import Session


class ComputingView(View):
    """Emits when there is something to compute, and when no longer.

    It must be the last base of a view: PySide looks for signals along the first.
    """

    _covered = False

    def show_design(self, session: "Session") -> None:
        """Drop the computation for another design."""
        super().show_design(session)
        if self._frame is not None and not shows(self._frame, session):
            self._want_nothing()

    def uncover(self, uncovered: bool) -> None:
        """Start or stop computing; a dock behind another tab is covered, not hidden."""
        self._covered = not uncovered
        if uncovered:
            self._want()
        else:
            self._want_nothing()

    def showEvent(self, event: QShowEvent) -> None:
        """Compute what was requested while hidden."""
        super().showEvent(event)
        self._want()

    def hideEvent(self, event: QHideEvent) -> None:
        """Compute nothing while hidden."""
        self._want_nothing()
        super().hideEvent(event)

    def _seen(self) -> bool:
        return self._frame is not None and self.isVisible() and not self._covered

    def _want(self) -> None: ...

    def _want_nothing(self) -> None: ...
