"""The docks on what becomes of a lens outside the program: can it be made, and how well must it."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QSettings

from ui.manufacture.pane import ManufacturePane
from ui.tolerances.pane import TolerancePane

if TYPE_CHECKING:
    from ui.shown.shown_lens import ShownLens
    from ui.views.plot_view import PlotView


class ProductionPanes(QObject):
    """Makes both panes and tells them of the lens on show.

    Attributes
    ----------
    panes : dict of str to QWidget
        By the names of their docks.
    """

    def __init__(self, settings: QSettings, parent: QObject) -> None:
        super().__init__(parent)
        self.manufacture, self.tolerances = ManufacturePane(settings), TolerancePane()
        self.panes = {"manufacture": self.manufacture, "tolerances": self.tolerances}

    def plots(self) -> "dict[str, PlotView]":
        """Their pictures, by the names of their docks."""
        return {"manufacture": self.manufacture.map, "tolerances": self.tolerances.plot}

    def follow(self, shown: "ShownLens") -> None:
        """Tell both panes of what is shown."""
        for pane in (self.manufacture, self.tolerances):
            shown.add(pane)

    def allow(self, resting: bool) -> None:
        """Whether the lens on show stays as it is until somebody asks for another."""
        for pane in (self.manufacture, self.tolerances):
            pane.allow(resting)

    def close(self) -> None:
        """End their threads; safe to call twice."""
        for pane in (self.manufacture, self.tolerances):
            pane.close_thread()
