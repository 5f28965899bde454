"""Result of a comparison with a photograph or with measured parts."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QWidget

from ui.widgets.controls import Table
from ui.widgets.dialog import Buttons, Dialog
from ui.widgets.figures import FigureCanvas, translate
from ui.words import capitalised, tr

if TYPE_CHECKING:
    from workbench.report.content import Fact

_SIZE = QSize(1240, 780)


class ComparisonDialog(Dialog):
    """Picture and figures."""

    def __init__(
        self, draw: Callable[[Figure], None], rows: "Sequence[Fact]", window: QWidget
    ) -> None:
        super().__init__(tr("Made and designed"), window, Buttons.Close)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        figure = Figure(layout="constrained")
        draw(figure)
        translate(figure)
        self.table = Table(tr("Figures"), 2)
        self.table.horizontalHeader().hide()
        self.table.fill([(capitalised(tr(name)), tr(value)) for name, value in rows])
        self.table.setWordWrap(False)
        self.table.resizeRowsToContents()
        canvas = FigureCanvas(self, tr("Made beside designed"), figure)
        self.fill((canvas, 2), (self.table, 1), size=_SIZE)
