"""Two kept runs beside each other: light, difference, losses, figures, and fields that differ."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any

from matplotlib.figure import Figure
from PySide6.QtCore import QSize
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QDialog, QHBoxLayout, QHeaderView, QLabel, QVBoxLayout, QWidget

from ui.document.frame import image_titles
from ui.run.kept_runs import called
from ui.run.status import clock
from ui.widgets.controls import Choice, Table, filled, named, side_by_side
from ui.widgets.figures import FigureCanvas, translate
from ui.widgets.native import rgb_image
from ui.words import capitalised, field_title, later, tr
from workbench.design.loss import relative_error
from workbench.design.session import KeptRun
from workbench.extended.bound import percent
from workbench.pictures.comparison import Comparison
from workbench.pictures.images import colours_for, full_scale, to_colours
from workbench.powers import written
from workbench.report.scene_rows import differences
from workbench.scene.image import as_viewed
from workbench.scene.part import title_of
from workbench.targets.raster import averaged


def figures_of(run: KeptRun, verified: str) -> list[tuple[str, str]]:
    """Figures by their English names; ``verified`` is the verified error, if any."""
    result, (n_u, n_v) = run.result, run.scene.optic.net_shape
    return [
        ("Target", tr(run.scene.target.called)),
        ("Error", percent(relative_error(result.state, run.target))),
        ("Verified", verified or "–"),
        ("On screen", f"{100 * result.state.account.efficiency:.1f} %"),
        ("Time", clock(result.seconds)),
        ("Iterations", f"{result.iterations}"),
        ("Net", f"{n_u} × {n_v}"),
        ("Method", tr(title_of(type(run.scene.run)))),
        ("Loss", written(result.state.loss)),
        ("Ended", tr(result.ended) or "–"),
    ]


def thumbnail_of(run: KeptRun, side: int) -> QPixmap:
    """Return a thumbnail of the irradiance of a run."""
    receiver, light = run.scene.receiver, run.result.state.irradiance
    top = full_scale(run.scene, run.target, receiver.total(light))
    width, height = (round(side * r / max(receiver.half_extent)) or 1 for r in receiver.half_extent)
    seen = averaged(as_viewed(run.scene, light), (height, width))
    return QPixmap.fromImage(rgb_image(to_colours(seen, top, colours_for(run.scene))))


_SIZE = QSize(1180, 740)
_SHARES = (64, 36)  # of the pictures and the table
_SAME = later("The scenes are the same")
_DIFFER = later("Fields of the scenes that differ")
_POINT = later("Point at an image to read its irradiance")

Pair = tuple[KeptRun, KeptRun]


class RunComparison(QDialog):
    """Shows a pair of runs, and stays open beside the window."""

    def __init__(self, verified: Callable[[KeptRun], str], window: QWidget) -> None:
        super().__init__(window)
        self.setWindowTitle(tr("Comparison of two runs"))
        self._verified = verified
        self._choice = Choice(tr("Image that is shown"), tr("Choose the image to compare"))
        self._choice.activated.connect(self._show_image)
        self.pair: Pair | None = None
        self._picture: Comparison | None = None
        self._readout = named(QLabel(tr(_POINT)), tr("Value under the pointer"))
        self._canvas = FigureCanvas(self, tr("Irradiance of both runs"), Figure())
        self._canvas.mpl_connect("motion_notify_event", self._read)
        self._canvas.mpl_connect("axes_leave_event", lambda _: self._readout.setText(tr(_POINT)))
        self.table = Table(tr("Figures of both runs"), columns=3)
        lines, header = self.table.verticalHeader(), self.table.horizontalHeader()
        lines.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        for number in (1, 2):
            header.setSectionResizeMode(number, QHeaderView.ResizeMode.Stretch)
        pictures = QWidget()
        column = filled(QVBoxLayout(pictures), (self._canvas, 1), margins=0)
        below = filled(QHBoxLayout(), self._choice, (self._readout, 1))
        column.addLayout(below)
        parts = side_by_side((pictures, self.table), _SHARES, _SIZE.width())
        filled(QHBoxLayout(self), parts, margins=(8, 8, 8, 8))
        self.resize(_SIZE.boundedTo(window.size()))

    def show_pair(self, pair: Pair) -> None:
        self.pair = pair
        titles = image_titles(*(run.scene for run in pair))
        chosen = min(self._choice.currentIndex(), len(titles) - 1)
        self._choice.offer(dict(enumerate(titles)), chosen)
        self._show_image()

    def show_figures(self) -> None:
        """Fill the table: figures of both runs, light of each area, fields that differ."""
        if self.pair is None:
            return
        images = [self._image_of(run) for run in self.pair]
        self.table.setHorizontalHeaderLabels(["", *map(called, self.pair)])
        self.table.setRowCount(0)
        self.table.clearSpans()
        own = zip(*map(self._figures_of, self.pair), strict=True)
        self._add("", ((tr(name), one, other) for (name, one), (_, other) in own))
        areas = [_areas_of(run) for run in images]
        for area in areas[0] | areas[1]:
            one, other = (found.get(area, {}) for found in areas)
            figures = [
                (capitalised(tr(name)), tr(one.get(name, "–")), tr(other.get(name, "–")))
                for name in one | other
            ]
            self._add(capitalised(tr(area)), figures)
        apart = differences(*(run.scene for run in self.pair))
        fields = ((field_title(each.title), *map(tr, each.values)) for each in apart)
        self._add(tr(_DIFFER if apart else _SAME), fields)

    def _show_image(self) -> None:
        assert self.pair is not None  # since there is a choice
        one, other = (replace(run, name=called(run)) for run in self.pair)
        self._picture = Comparison(self._canvas.figure, (one, other), self._choice.currentIndex())
        translate(self._canvas.figure, self._picture.titles)
        self._canvas.recolour()
        self._readout.setText(tr(_POINT))
        self.show_figures()

    def _image_of(self, run: KeptRun) -> KeptRun:
        return run.of_image(min(self._choice.currentIndex(), len(run.scene.images) - 1))

    def _figures_of(self, run: KeptRun) -> list[tuple[str, str]]:
        return figures_of(
            self._image_of(run), "" if self._choice.currentIndex() else self._verified(run)
        )

    def _read(self, event: Any) -> None:
        if self._picture is None or event.inaxes is None:
            return
        words = self._picture.in_words(event.inaxes, event.xdata, event.ydata)
        self._readout.setText(tr(words or _POINT))

    def _add(self, heading: str, rows: Iterable[Sequence[str]]) -> None:
        for texts in [[heading]] * bool(heading) + list(rows):
            row = self.table.rowCount()
            self.table.insertRow(row)
            self.table.put(row, texts, bold=len(texts) == 1)
            if len(texts) == 1:
                self.table.setSpan(row, 0, 1, self.table.columnCount())


def _areas_of(run: KeptRun) -> dict[str, dict[str, str]]:
    """Figures of the light of each area of a run with one image, by the area's name."""
    from workbench.analysis.regions import light_of_areas  # late: takes long to import

    found = light_of_areas(run.scene, run.target, run.result.state.irradiance)
    return {light.name: light.figures for light in found}
