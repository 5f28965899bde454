"""All figures of the last check in a table, and how many rays the next one traces."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings, Qt, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QHeaderView, QVBoxLayout, QWidget

from ui.run.checks import RAYS, CheckedLens
from ui.widgets.controls import STRETCH, Choice, Table, command_button, filled, tool_button
from ui.widgets.labels import WrappedLabel, kept_together
from ui.words import capitalised, in_sentence, later, tr
from workbench.messages import Message

if TYPE_CHECKING:
    from workbench.analysis.validation_figures import Validation
    from workbench.report.content import Fact
    from workbench.scene import Scene

_CHOICES = (1_000_000, 4_000_000, 16_000_000, 64_000_000)
_KEY = "check/rays"
_NOTHING = later("F8 checks the design with an independent ray trace.")
_TIPS = later(
    {
        "check failed": (
            "Two independent methods, beam meshes and random rays, differ by more than their "
            "error bounds: one of them is wrong."
        ),
        "no deterministic figure": (
            "The error is from random rays alone; the intervals below include their noise."
        ),
        "optimiser and check": (
            "Image or efficiency of the optimiser differ from the check by more than the error "
            "bounds; the optimiser traces fewer rays."
        ),
        "verified error": (
            "Relative L2 error between image and target, free of ray noise, and the interval that "
            "it is in: by a deterministic beam mesh, or by random rays with 95 % confidence. With "
            "< where it cannot be told from zero."
        ),
        "beam mesh": "Number of beams through the entrance face.",
        "error by image pairs": (
            "The deterministic check would be too slow here; pairs of random images are used. The "
            "interval has 95 % confidence."
        ),
        "difference of random rays": (
            "Relative L2 difference between the images of both methods. About one noise level is "
            "expected."
        ),
        "error by random rays": (
            "The same error by random rays without their noise, with 95 % confidence: a second "
            "opinion."
        ),
        "error with ray noise": (
            "‖I − T‖ / ‖T‖ of image and target, each divided by its sum, by random rays with their "
            "noise, which more rays reduce. The interval is that of 95 % for other rays."
        ),
        "loss of the paper": (
            "Norm of the difference between image and target, each divided by its sum, over the "
            "root of the number of pixels."
        ),
        "PSNR": "Peak signal-to-noise ratio, against the target's peak: more is better.",
        "SSIM": "Mean structural similarity in windows of 11 × 11 pixels: 1 for equal images.",
        later("correlation"): (
            "Pearson's coefficient of image and target over the pixels; 1 for proportional images."
        ),
        later("uniformity"): (
            "Least over mean of irradiance / target where the target is at least half its peak; 1 "
            "is uniform, 0 has a dark pixel."
        ),
        later("contrast"): (
            "(lit − black) / (lit + black) of the mean irradiances there; black is up to a "
            "hundredth of the target's peak. 1 is a perfect black."
        ),
        later("efficiency"): "Fraction of the emitted flux in the image.",
        "meets the face again": (
            "Flux that hits its exit face a second time, as in a deep concave face. Image and "
            "efficiency ignore this."
        ),
        "comes through the screen": (
            "Flux that the screen blocks before the mirror. Image and efficiency ignore this; a "
            "screen beside the axis does not block it."
        ),
        "difference to the optimiser": (
            "Relative L2 difference to the image of the optimiser; includes its filter and ray "
            "noise."
        ),
        later("rays"): "Rays of the image; a quarter more are traced for the error without noise.",
    }
)


_OF_STEP = later(
    "Relative L2 error as designed, and after each process of manufacture and those before it; "
    "the last one is that of the finished part."
)
_OF_REGION = later(
    "Fraction of the emitted flux on the area, and its light pixel by pixel. U₀ is minimum / "
    "average, U₁ minimum / maximum; 1 is uniform."
)


class _NarrowTable(Table):
    def __init__(self) -> None:
        super().__init__(tr("Figures of the check"), columns=2)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        header = self.horizontalHeader()
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Fixed)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        header.hide()

    def share_width(self) -> None:
        """Give names at most half of the width, and values the rest."""
        names, most = self.sizeHintForColumn(0), self.viewport().width() // 2
        self.setColumnWidth(0, min(names, most))
        self.resizeRowsToContents()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.share_width()


class CheckFigures(QWidget):
    """Table of figures; those of another lens are marked as outdated."""

    rays_chosen = Signal(int)

    def __init__(self, settings: QSettings, check: QAction) -> None:
        super().__init__()
        self._settings = settings
        self._rows: list[tuple[str, str]] = []  # names and values
        self._hint = WrappedLabel(tr(_NOTHING), alignment=Qt.AlignmentFlag.AlignCenter)
        self._hint.setContentsMargins(6, 4, 6, 2)
        self._table = _NarrowTable()
        self._table.hide()  # until there is something in it
        self._table.add_action(tr("Copy"), QKeySequence.StandardKey.Copy).triggered.connect(
            self.copy
        )
        tip = tr("Rays of a check; four times as many halve the noise")
        self._rays = Choice(tr("Rays of a check"), tip)
        self._rays.currentIndexChanged.connect(self._choose)
        ask = command_button(check)
        tip = tr("Copy all figures to the clipboard, tab-separated")
        self._copy = tool_button(tr("Copy"), tip, self.copy)
        self._copy.setEnabled(False)
        row = filled(
            QHBoxLayout(), self._rays, STRETCH, ask, self._copy, margins=(6, 4, 6, 4), spacing=6
        )
        filled(QVBoxLayout(self), self._hint, (self._table, 1), row, margins=0, spacing=0)
        millions = tr("{rays} million rays")
        titles = {rays: millions.format(rays=rays // 1_000_000) for rays in _CHOICES}
        kept = settings.value(_KEY, RAYS, type=int)
        self._rays.offer(titles, kept if kept in _CHOICES else RAYS)

    @property
    def rays(self) -> int:
        return int(self._rays.currentData())

    @property
    def text(self) -> str:
        """All figures, a line for each, with a tab between name and value."""
        return "".join(f"{name}\t{value}\n" for name, value in self._rows)

    def show_check(self, lens: CheckedLens, found: "Validation", difference: float) -> None:
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
        self._rows, tips = [], []
        for number, (image, off, own, scene) in enumerate(
            zip(found.images, differences, lights, lens.session.scene.single, strict=True), start=1
        ):
            remark = None if own is None else image.beside_run(own, scene.receiver)
            for row, tip in _rows_of(image, off, remark, scene):
                name = row.name
                if found.further:
                    name = tr("image {number}: {name}").format(number=number, name=name)
                self._rows.append((capitalised(name), row.value))
                tips.append(f"<p>{tip}</p>")
        self._table.setRowCount(len(self._rows))
        for line, (texts, tip) in enumerate(zip(self._rows, tips, strict=True)):
            self._table.put(line, [*map(kept_together, texts)], tip)
        self._table.share_width()
        self._table.setEnabled(True)
        self._table.show()
        self._copy.setEnabled(True)
        self._hint.hide()

    def follow(self, under_way: bool) -> None:
        """Follow a check of the shown lens; what is there becomes outdated."""
        self.await_figures(under_way)
        self._hint.show()
        self._table.setEnabled(False)

    def await_figures(self, under_way: bool) -> None:
        """Say whether figures come where there are none of the shown lens."""
        before = tr("Outdated figures: the design has changed.") if self._rows else ""
        self._hint.setText(tr("Checking…") if under_way else before or tr(_NOTHING))

    def copy(self) -> None:
        if self._rows:
            QGuiApplication.clipboard().setText(self.text)

    def _choose(self) -> None:
        self._settings.setValue(_KEY, self.rays)
        self.rays_chosen.emit(self.rays)


def _rows_of(
    found: "Validation", difference: float, remark: Message | None, scene: "Scene"
) -> "list[tuple[Fact, str]]":
    # Late: what it stands on is slow to import, and is there after a check.
    from workbench.measured.lamps import light_unit
    from workbench.optics.account import words_of
    from workbench.report.figures import account_rows, check_rows, made_rows, region_rows

    account = (found.by_cells or found).account
    parts = account_rows(account, scene, light_unit(scene))
    titles = [words_of(part, scene.receiver) for part in account.parts_in(scene)]
    rows = [
        *((row, tr(row.name), _OF_STEP) for row in made_rows(found)),
        *((row, tr(row.name), _TIPS[row.name]) for row in check_rows(found, difference, remark)),
        *((row, tr(row.name), _OF_REGION) for row in region_rows(found)),
        *(
            (row, in_sentence(tr(name)), tip)
            for row, (name, tip) in zip(parts, titles, strict=True)
        ),
    ]
    return [(row._replace(name=name, value=_value(row.value)), tr(tip)) for row, name, tip in rows]


def _value(value: str) -> str:
    return tr(value) if isinstance(value, Message) else value
