"""Dialog of a sweep: fields and values, and a table and a curve of the designs."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from PySide6.QtCore import QSize, QTimer, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QWidget,
)

from ui.background import Background, Task
from ui.document.document import Document
from ui.widgets.controls import Choice, Table, filled, named, side_by_side, tool_button
from ui.widgets.dialog import Buttons, Dialog
from ui.widgets.figures import FigureCanvas, translate
from ui.widgets.labels import WrappedLabel
from ui.words import error_text, field_title, later, tr
from workbench.design.session import verified_error
from workbench.errors import Refused
from workbench.pictures.error_curves import Curve, draw_sweep
from workbench.progress import Interrupted, interrupted_when
from workbench.report.scene_rows import FieldRow, field_rows
from workbench.scene import Scene

if TYPE_CHECKING:
    from workbench.sweep.points import Point, Variation
    from workbench.sweep.sweep import PointRow


RAYS = 4_000_000
"""Of the check of each lens, as on the command line."""


@dataclass(frozen=True, eq=False)
class Sweep:
    """Design tasks of a sweep, and the folder for sessions and tables."""

    points: "list[Point]"
    folder: Path


def work_on(sweep: Sweep, task: Task) -> None:
    """Design the lenses of a sweep in processes; for a thread. Reports numbers and rows."""
    # Late: what they stand on is slow to import.
    from workbench.sweep.processes import Processes
    from workbench.sweep.sweep import Store
    from workbench.sweep.sweep import sweep as rows_of

    store, found = Store(sweep.folder), dict[int, "PointRow"]()
    with store.locked():
        try:
            workers = Processes.of(len(sweep.points))
            with interrupted_when(lambda: task.stopped), workers:
                for number, row in rows_of(sweep.points, store, workers, RAYS):
                    found[number] = row
                    task.part = len(found) / len(sweep.points)
                    task.report((number, row))
        except Interrupted:
            pass  # the table has what is finished
        store.write_table([found[number] for number in sorted(found)])
    done = tr("{count} of {wanted} designs").format(count=len(found), wanted=len(sweep.points))
    task.outcome, task.path = f"{done}, {sweep.folder}", sweep.folder


_SIZE = QSize(1120, 640)
_SHARES = (56, 44)  # of the table and the curve
_ABOUT = later(
    "Designs and checks a lens for each value, or each pair of values of two fields. The folder "
    "gets the sessions and a table (CSV, JSON). Finished designs are skipped."
)
_FIGURES = later(("Verified error", "Light", "Iterations", "Seconds"))


class SweepDialog(Dialog):
    """Dialog of a sweep, which stays open: fields, values, folder, table and curve."""

    open_asked = Signal(Path)

    def __init__(self, document: Document, window: QWidget) -> None:
        super().__init__(tr("Sweep"), window, Buttons.Close)
        self._document, self._rows = document, dict[int, "PointRow"]()
        self._sweep: Sweep | None = None
        self.form, self.folder = SweepForm(), QLineEdit()
        self.form.lines.addRow(tr("Folder"), self._folder_line())
        self.status = WrappedLabel()
        self.status.setAccessibleName(tr("Progress of the sweep"))
        self.table, self.curve = Table(tr("Designs of the sweep")), SweepCurve(self)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.begin = self.add_button(tr("Start"), act=self.toggle)
        tip = tr("Open the session of the selected row")
        self.look = self.add_button(tr("&Open design"), tip, self._open)
        self.begin.setDefault(True)
        parts = side_by_side((self.table, self.curve), _SHARES, _SIZE.width())
        self.fill(WrappedLabel(tr(_ABOUT)), self.form, self.status, (parts, 1), size=_SIZE)
        self.background = Background(later("sweep"), self)
        self.background.progressed.connect(self._show_row)
        self.background.done.connect(lambda *_: self._offer())
        self.background.failed.connect(self._give_up)
        self.table.itemSelectionChanged.connect(self._offer)
        self.table.itemDoubleClicked.connect(lambda _: self._open())
        self._offer()

    def show_design(self) -> None:
        """Show the dialog with the fields of the open design, and a folder beside its file."""
        path = self._document.suggested_path
        self.form.show_scene(self._document.session.scene)
        # For a design without a file a person chooses the folder.
        if not self.folder.text() and path.is_absolute():
            self.folder.setText(str(path.with_name(f"{path.stem}-sweep").absolute()))
        self.show()
        self.raise_()
        self.activateWindow()

    def toggle(self) -> None:
        if self.background.busy:
            self.background.stop()
            self._offer()
            return
        from workbench.sweep.points import points_of  # late: slow to import

        try:
            points = points_of(
                [(self._document.suggested_path, self._document.session)], self.form.variations()
            )
        except Refused as refused:
            self.status.setText(f"\N{WARNING SIGN} {error_text(refused)}")
            return
        if not self.folder.text().strip():
            self._choose_folder()
        if not self.folder.text().strip():
            self.status.setText("\N{WARNING SIGN} " + tr("Choose a folder for the designs."))
            return
        self._sweep = sweep = Sweep(points, Path(self.folder.text()).expanduser())
        self._rows.clear()
        self._show_points(sweep)
        self.background.begin(partial(work_on, sweep), sweep, tr("Sweep"))
        self._offer()

    def _folder_line(self) -> QHBoxLayout:
        self.folder.setAccessibleName(tr("Folder"))
        self.folder.setPlaceholderText(tr("Chosen at the start"))
        choose = tool_button("…", "", self._choose_folder, tr("Choose the folder"))
        return filled(QHBoxLayout(), (self.folder, 1), choose)

    def _choose_folder(self) -> None:
        chosen = QFileDialog.getExistingDirectory(self, tr("Folder"), self.folder.text())
        if chosen:
            self.folder.setText(chosen)

    def _show_points(self, sweep: Sweep) -> None:
        from workbench.sweep.points import shown  # late, as above

        points, titles = sweep.points, self.form.titles()
        self.curve.show_rows(titles, self._rows)
        self.table.clear()
        self.table.setColumnCount(len(titles) + len(_FIGURES))
        self.table.setHorizontalHeaderLabels([*titles, *map(tr, _FIGURES)])
        self.table.fill([[*map(shown, point.changes.values()), "…"] for point in points])

    def _show_row(self, sweep: Sweep, found: "tuple[int, PointRow]") -> None:
        number, row = found
        self._rows[number] = row
        values = list(row.changes.values())
        if row.reason is not None:
            refused = sweep.points[number].scene
            why = error_text(refused) if isinstance(refused, Refused) else tr(row.reason)
            self.table.put(number, [*values, why])
            self.table.setSpan(number, len(values), 1, len(_FIGURES))
        else:
            figures = row.figures
            light, seconds = f"{figures['efficiency']:.1%}", f"{figures['seconds']:.1f}"
            error, steps = verified_error(row.verified), f"{figures['iterations']:.0f}"
            self.table.put(number, [*values, error, light.replace("%", " %"), steps, seconds])
        self.curve.show_rows(self.form.titles(), self._rows)
        self._offer()

    def _give_up(self, sentence: str) -> None:
        self._offer()
        self.status.setText(f"\N{WARNING SIGN} {sentence}")

    def _chosen(self) -> Path | None:
        row = self._rows.get(self.table.currentRow())
        if self._sweep is None or row is None or row.session is None:
            return None
        return self._sweep.folder / row.session

    def _open(self) -> None:
        if (path := self._chosen()) is not None:
            self.open_asked.emit(path)

    def _offer(self) -> None:
        busy = self.background.busy
        self.begin.setText(tr("Stop") if busy else tr("Start"))
        self.begin.setEnabled(not self.background.stopping)
        self.look.setEnabled(self._chosen() is not None)
        self.form.setEnabled(not busy)
        if self._sweep is not None:
            done = tr("{count} of {wanted} designs").format(
                count=len(self._rows), wanted=len(self._sweep.points)
            )
            self.status.setText(f"{done}…" if busy else f"{done}, {self._sweep.folder}")


# Nothing of the lens depends on these, or a sweep refuses them.
_NOT = re.compile(r"unit|regions|images\[[1-9]|elements\[\d+\]\.(kind|name)$")
_VALUES = later(
    "Separate values by commas: 1, 2.5, 3; ranges as 0..4; pairs as 64x48; words as auto. Lengths "
    "in the unit of the scene."
)


class SweepForm(QWidget):
    """One or two fields and their values."""

    def __init__(self) -> None:
        super().__init__()
        titles = tr("Field"), tr("Second field")
        self.fields = [Choice(title) for title in titles]
        self.values = [QLineEdit() for _ in titles]
        self._rows: dict[str, FieldRow] = {}
        self.lines = QFormLayout(self)
        self.lines.setContentsMargins(0, 0, 0, 0)
        for title, field, values in zip(titles, self.fields, self.values, strict=True):
            field.currentIndexChanged.connect(self._show_present)
            named(values, tr("Values of {field}").format(field=title), f"<p>{tr(_VALUES)}</p>")
            line = filled(QHBoxLayout(), (field, 1), (values, 1))
            self.lines.addRow(title, line)

    def show_scene(self, scene: Scene) -> None:
        """Offer the fields of a scene; the selection stays where possible."""
        self._rows = {row.path: row for row in field_rows(scene) if not _NOT.match(row.path)}
        titles = {path: field_title(row.title) for path, row in self._rows.items()}
        for number, field in enumerate(self.fields):
            field.offer({"": tr("none"), **titles} if number else titles, field.currentData())
        self._show_present()

    def variations(self) -> "list[Variation]":
        from workbench.sweep.points import Variation  # late, as all of sweeps

        found = []
        for field, values in zip(self.fields, self.values, strict=True):
            if path := field.currentData():
                found.append(Variation.parse(f"{path}={values.text().replace(' ', '')}"))
        return found

    def titles(self) -> list[str]:
        return [field.currentText() for field in self.fields if field.currentData()]

    def _show_present(self) -> None:
        for field, values in zip(self.fields, self.values, strict=True):
            row = self._rows.get(field.currentData() or "")
            values.setEnabled(row is not None)
            now = "" if row is None else tr("now {value}").format(value=row.value)
            values.setPlaceholderText(now)


_EVERY_MS = 50  # lenses that are there already come by the thousand


class SweepCurve(FigureCanvas):
    """Plots errors of finished lenses, a curve for each value of a second field."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent, tr("Verified error over the values"), Figure(layout="constrained"))
        self._titles: Sequence[str] = ()
        self._rows: Mapping[int, PointRow] = {}
        self._soon = QTimer(self, singleShot=True, interval=_EVERY_MS)
        self._soon.timeout.connect(self._draw_rows)

    def show_rows(self, titles: Sequence[str], rows: "Mapping[int, PointRow]") -> None:
        """Plot the rows that have a lens, after a short delay."""
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


def _first(row: "PointRow") -> str:
    return next(iter(row.changes.values()))


def _name(titles: Sequence[str], row: "PointRow") -> str:
    _, *others = row.changes.values()
    return ", ".join(f"{title} {value}" for title, value in zip(titles[1:], others, strict=True))
