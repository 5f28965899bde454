"""All figures of the last check in a table, and how many rays the next one traces."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings, Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHBoxLayout,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.run.check import RAYS, CheckedLens
from ui.widgets.labels import WrappedLabel, kept_together
from ui.words import inside, later, tr
from workbench.said import Said

if TYPE_CHECKING:
    from collections.abc import Sequence

    from workbench.analysis.validation_figures import Validation
    from workbench.report.content import Fact
    from workbench.scene import Scene

_CHOICES = (1_000_000, 4_000_000, 16_000_000, 64_000_000)
_KEY = "check/rays"
_SAID = Qt.ItemDataRole.UserRole  # a text with the spaces that it was given
_NOTHING = later("F8 traces what is on show anew, with rays that its design never saw.")
_TIPS = later(
    {
        "check failed": (
            "Cells and random rays trace the same light by different means. Where they differ by "
            "more than noise and error bounds explain, one of them is wrong."
        ),
        "no deterministic figure": (
            "The error is by random rays alone, whose noise is in the intervals below."
        ),
        "optimiser and check": (
            "The image and the efficiency of the design differ from the check by more than errors "
            "explain: the optimiser traces fewer rays."
        ),
        "verified error": (
            "Relative L2 error of image and target, by cells and without random "
            "rays: what the optic itself is off."
        ),
        "it is surely": "Where that error lies, by a bound from two sizes of cells.",
        later(
            "cells"
        ): "Cells of the entrance face whose light is spread over what they cover there.",
        "error by independent images": (
            "Cells would have to be finer than time allows: the error, and where it "
            "lies with 95 % confidence, are from pairs of images by random rays: "
            "their scatter has no mean."
        ),
        "random rays are off by": (
            "Relative L2 difference of the two images: the second opinion. About "
            "once the noise of the rays is what chance alone makes."
        ),
        "relative L2 error": (
            "‖I − T‖ / ‖T‖ of image and target, each divided by its sum. The scatter "
            "of the rays from pixel to pixel is in it; more rays make it smaller."
        ),
        "95 % of other rays": "Where the error with scatter lies for as many other rays.",
        "without ray noise": (
            "The same error without the scatter of the rays: what the optic itself "
            "is off. With < if so few rays cannot tell it from none."
        ),
        "95 % confidence": "Where the error of the optic itself lies.",
        "loss of the paper": (
            "The norm of the difference between image and target, each divided by "
            "its sum, over the root of the number of pixels."
        ),
        "PSNR": "Peak signal-to-noise ratio, against the target's peak: more is better.",
        "SSIM": "Mean structural similarity in windows of 11 × 11 pixels: 1 for equal images.",
        later("correlation"): "Pearson's coefficient of image and target over the pixels: "
        "1 for images of one shape.",
        later("uniformity"): (
            "Least over mean of irradiance / target where the target is lit, at half "
            "its peak or more: 1 is even, 0 has a dark pixel."
        ),
        later("contrast"): (
            "(lit − black) / (lit + black) of the mean irradiances there; black is "
            "up to a hundredth of the target's peak. 1 is a perfect black."
        ),
        later("efficiency"): "Part of the emitted light that makes the image.",
        "meets the face again": (
            "Light that comes back to the face which it leaves, as in a deep bowl. "
            "Image and efficiency count it as if nothing were in its way."
        ),
        "comes through the screen": (
            "Light that the screen keeps from the mirror. Image and efficiency count "
            "it as if the screen were not in its way; a screen beside the axis is "
            "not."
        ),
        "off the optimiser's image": (
            "Relative L2 difference to the image that the optimiser sees. Its filter "
            "and the scatter of these rays are in it."
        ),
        later("rays"): "Rays of the image; a quarter as many more are traced for the error "
        "without scatter.",
    }
)


_OF_REGION = later(
    "Part of the emitted light that falls on the region, and its darkest and "
    "brightest pixel over the mean: 1 is even."
)


class _NarrowTable(QTableWidget):
    def __init__(self, rows: int, columns: int) -> None:
        super().__init__(rows, columns)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.horizontalHeader().setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)

    def share_width(self) -> None:
        """Give names the width that they need, but at most half; values get the rest."""
        names, most = self.sizeHintForColumn(0), self.viewport().width() // 2
        self.setColumnWidth(0, min(names, most))
        self.resizeRowsToContents()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Wrap for the width of now."""
        super().resizeEvent(event)
        self.share_width()


class CheckFigures(QWidget):
    """Keeps the figures when another lens is shown, and tells that they are of the one before."""

    rays_chosen = Signal(int)

    def __init__(self, settings: QSettings, check: QAction) -> None:
        super().__init__()
        self._settings = settings
        self._hint = WrappedLabel(tr(_NOTHING), alignment=Qt.AlignmentFlag.AlignCenter)
        self._hint.setContentsMargins(6, 4, 6, 2)
        self._table = _NarrowTable(0, 2)
        self._table.hide()  # until there is something in it
        self._table.setAccessibleName(tr("Figures of the check"))
        self._table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self._table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self._table.setAlternatingRowColors(True)
        self._table.setShowGrid(False)
        self._table.setFrameShape(QTableWidget.Shape.NoFrame)
        self._table.horizontalHeader().hide()
        self._table.verticalHeader().hide()
        copy = QAction(tr("Copy"), self._table)
        copy.setShortcut(QKeySequence(QKeySequence.StandardKey.Copy))
        copy.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        copy.triggered.connect(self.copy)
        self._table.addAction(copy)
        self._rays = QComboBox()
        self._rays.setAccessibleName(tr("Rays of a check"))
        self._rays.setToolTip(tr("Rays of a check; four times as many halve their scatter"))
        for rays in _CHOICES:
            self._rays.addItem(tr("{rays} million rays").format(rays=rays // 1_000_000), rays)
        kept = self._rays.findData(settings.value(_KEY, RAYS, type=int))
        self._rays.setCurrentIndex(kept if kept >= 0 else _CHOICES.index(RAYS))
        self._rays.currentIndexChanged.connect(self._choose)
        ask = QToolButton()
        ask.setDefaultAction(check)
        self._copy = QToolButton()
        self._copy.setText(tr("Copy"))
        self._copy.setToolTip(tr("Put all figures on the clipboard, a tab between name and value"))
        self._copy.clicked.connect(self.copy)
        self._copy.setEnabled(False)
        row = QHBoxLayout()
        row.setContentsMargins(6, 4, 6, 4)
        row.setSpacing(6)
        row.addWidget(self._rays)
        row.addStretch(1)
        row.addWidget(ask)
        row.addWidget(self._copy)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._hint)
        column.addWidget(self._table, 1)
        column.addLayout(row)

    @property
    def rays(self) -> int:
        """Rays that a check traces."""
        return int(self._rays.currentData())

    @property
    def text(self) -> str:
        """All figures, a line for each, with a tab between name and value."""
        return "".join(f"{self._cell(n, 0)}\t{self._cell(n, 1)}\n" for n in range(self._count))

    def show_check(self, lens: CheckedLens, found: "Validation", difference: float) -> None:
        """Show what a check says."""
        # Late: it is slow to import, and is there after a check.
        from workbench.analysis.metrics import relative_l2

        differences = [
            difference,
            *(
                relative_l2(image.irradiance, own)
                for image, own in zip(found.further, lens.further, strict=True)
            ),
        ]
        lights = (lens.irradiance, *lens.further)
        rows: list[Fact] = []
        tips: list[str] = []
        for number, (image, off, own, scene) in enumerate(
            zip(found.images, differences, lights, lens.session.scene.single, strict=True), start=1
        ):
            remark = None if own is None else image.beside_run(own, scene.receiver)
            for row, tip in _rows_of(image, off, remark, scene):
                name = row.name
                if found.further:
                    name = tr("image {number}: {name}").format(number=number, name=name)
                rows.append(row._replace(name=name))
                tips.append(tip)
        self._fill(rows, tips)
        self._table.setEnabled(True)
        self._table.show()
        self._copy.setEnabled(True)
        self._hint.hide()

    def follow(self, figures: str) -> None:
        """Take note of what is known of the lens on show, before `show_check` shows its figures."""
        before = tr(" Out of date: these figures are of the design before.") if self._count else ""
        self._hint.setText(f"{figures[:1].upper()}{figures[1:]}{before}" or tr(_NOTHING))
        self._hint.show()
        self._table.setEnabled(False)

    def copy(self) -> None:
        """Put all figures on the clipboard."""
        if self._count:
            QGuiApplication.clipboard().setText(self.text)

    @property
    def _count(self) -> int:
        return self._table.rowCount()

    def _cell(self, row: int, column: int) -> str:
        item = self._table.item(row, column)
        assert item is not None  # each row is filled
        return str(item.data(_SAID))

    def _fill(self, rows: "Sequence[Fact]", tips: "Sequence[str]") -> None:
        self._table.setRowCount(len(rows))
        for number, (row, tip) in enumerate(zip(rows, tips, strict=True)):
            for column, text in enumerate((row.name[:1].upper() + row.name[1:], row.value)):
                item = QTableWidgetItem(kept_together(text))
                item.setData(_SAID, text)
                item.setToolTip(f"<p>{tip}</p>")
                self._table.setItem(number, column, item)
        self._table.share_width()

    def _choose(self) -> None:
        self._settings.setValue(_KEY, self.rays)
        self.rays_chosen.emit(self.rays)


def _rows_of(
    found: "Validation", difference: float, remark: Said | None, scene: "Scene"
) -> "list[tuple[Fact, str]]":
    # Late: what it stands on is slow to import, and is there after a check.
    from workbench.measured.lamps import light_unit
    from workbench.optics.account import words_for
    from workbench.report.figures import account_rows, check_rows, region_rows

    words = words_for(scene.receiver)
    parts = account_rows(found.account, scene, light_unit(scene))
    titles = [words[name] for name in found.account.parts_in(scene)]
    rows = [
        *((row, tr(row.name), _TIPS[row.name]) for row in check_rows(found, difference, remark)),
        *((row, tr(row.name), _OF_REGION) for row in region_rows(found)),
        *((row, inside(tr(name)), tip) for row, (name, tip) in zip(parts, titles, strict=True)),
    ]
    return [(row._replace(name=name, value=_value(row.value)), tr(tip)) for row, name, tip in rows]


def _value(value: str) -> str:
    return tr(value) if isinstance(value, Said) else value
