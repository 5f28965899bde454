"""Errors of a sweep's lenses over the values of its first field."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.widgets.plot_words import translate
from ui.words import tr
from workbench.pictures.axes import paint
from workbench.pictures.error_curves import Curve, draw_sweep

if TYPE_CHECKING:
    from workbench.sweep.sweep import PointRow

_EVERY_MS = 50  # lenses that are there already come by the thousand


class SweepCurve(FigureCanvasQTAgg):
    """Draws lenses as they are finished; a curve for each value of a second field."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(Figure(layout="constrained"))
        self._parent = parent  # its palette gives the colours: that of a canvas is white
        self.setParent(parent)
        self.setAccessibleName(tr("Verified error over the values"))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._titles: Sequence[str] = ()
        self._rows: Mapping[int, PointRow] = {}
        self._soon = QTimer(self, singleShot=True, interval=_EVERY_MS)
        self._soon.timeout.connect(self._draw_rows)
        self.recolour()

    def show_rows(self, titles: Sequence[str], rows: "Mapping[int, PointRow]") -> None:
        """Show those of some rows that have a lens, as they are in a moment.

        Parameters
        ----------
        titles : sequence of str
            What the fields are called.
        rows : mapping of int to PointRow
            By their numbers.
        """
        self._titles, self._rows = titles, rows
        if not self._soon.isActive():
            self._soon.start()

    def _draw_rows(self) -> None:
        titles, curves = self._titles, dict[str, list["PointRow"]]()
        for _, row in sorted(self._rows.items()):
            if row.reason is None:
                curves.setdefault(_name(titles, row), []).append(row)
        self.figure.clear()
        if curves:
            drawn = [
                Curve(name, [_first(row) for row in found], [row.verified for row in found])
                for name, found in curves.items()
            ]
            draw_sweep(self.figure.subplots(), titles[0], drawn)
            translate(self.figure, (titles[0], *curves))
        self.recolour()

    def recolour(self) -> None:
        """Follow the palette between light and dark."""
        palette = self._parent.palette()
        paint(self.figure, palette.windowText().color().name(), palette.window().color().name())
        self.draw_idle()


def _first(row: "PointRow") -> str:
    return next(iter(row.changes.values()))


def _name(titles: Sequence[str], row: "PointRow") -> str:
    """The second field and its value, if there is one."""
    _, *others = row.changes.values()
    return ", ".join(f"{title} {value}" for title, value in zip(titles[1:], others, strict=True))
