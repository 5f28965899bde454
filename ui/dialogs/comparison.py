"""Result of a comparison with a photograph or with measured parts."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QVBoxLayout, QWidget

from ui.widgets.controls import Table, filled
from ui.widgets.figures import FigureCanvas, translate
from ui.words import capitalised, tr

if TYPE_CHECKING:
    from workbench.report.content import Fact

_SIZE = QSize(1240, 780)


class ComparisonDialog(QDialog):
    """Picture and figures; ``save`` writes the corrected part, where there is one."""

    def __init__(
        self, draw: Callable[[Figure], None], rows: "Sequence[Fact]", window: QWidget
    ) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Made and designed"))
        figure = Figure(layout="constrained")
        draw(figure)
        translate(figure)
        self.table = Table(tr("Figures"), 2)
        self.table.horizontalHeader().hide()
        self.table.setRowCount(len(rows))
        for number, (name, value) in enumerate(rows):
            self.table.put(number, (capitalised(tr(name)), tr(value)))
        self.table.setWordWrap(False)
        self.table.resizeRowsToContents()
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        role = QDialogButtonBox.ButtonRole.ActionRole
        self.save = buttons.addButton(tr("Save &corrected part…"), role)
        self.save.setToolTip(tr("Write a design whose face makes good what repeats in the parts"))
        self.save.hide()  # unless parts were measured
        buttons.rejected.connect(self.reject)
        canvas = FigureCanvas(self, tr("Made beside designed"), figure)
        filled(QVBoxLayout(self), (canvas, 2), (self.table, 1), buttons)
        self.resize(_SIZE.boundedTo(window.size()))
