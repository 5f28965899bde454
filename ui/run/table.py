"""The kept runs of a session, one in each line."""

from collections.abc import Callable, Sequence
from functools import partial

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QIcon, QKeySequence
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QLineEdit,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableWidgetItem,
    QToolTip,
    QVBoxLayout,
    QWidget,
)

from ui.run.comparison import figures_of, thumbnail_of
from ui.run.kept_runs import called
from ui.widgets.controls import STRETCH, Table, filled, push_button
from ui.widgets.labels import WrappedLabel
from ui.words import later, tr
from workbench.design.session import LONGEST_NAME
from workbench.files.session import KeptRun

_NOTHING = later("Finished runs are listed here, to compare and restore them.")
_COLUMNS = later(
    {
        "Name": ("Name and image of the run; tick it to plot its loss beside that of this run"),
        "Target": "Target image: file or built-in shape",
        "Error": "Relative L2 error of the best result, as the optimiser computes it",
        "Verified": "Relative L2 error of the result, by the independent check",
        "On screen": "Fraction of the flux on the receiver",
        "Time": "Run time",
        "Iterations": "Iterations, including those of continued runs",
        "Net": "Numbers of control points along x and y",
        "Method": "Design method",
        "Loss": "Loss of the best result",
        "Ended": "Why the run ended",
    }
)
_LEFT = ("Target", "Ended")  # words; numbers stand at the right
_PICTURE = 40  # pixels of the light beside the name
_BETWEEN = 6  # pixels from one picture to the next
_WIDEST = 32  # characters of a column; longer texts are cut, and whole in a tip
_VERIFIED = list(_COLUMNS).index("Verified")


class RunTable(QWidget):
    """Table of the kept runs."""

    marks_changed = Signal()
    renamed = Signal(object, str)  # KeptRun, str
    restore_asked = Signal()
    delete_asked = Signal()
    compare_asked = Signal()

    def __init__(self, verified: Callable[[KeptRun], str]) -> None:
        super().__init__()
        self._verified = verified
        self._runs: tuple[KeptRun, ...] = ()
        self._marked: set[int] = set()  # ids of results, which outlive other names
        self._pictures: dict[int, QIcon] = {}  # by the same
        self._hint = WrappedLabel(tr(_NOTHING), alignment=Qt.AlignmentFlag.AlignCenter)
        self._hint.setMargin(self.fontMetrics().height())
        self.table = Table(tr("Kept runs"), len(_COLUMNS))
        self.table.setShowGrid(True)
        self.table.setIconSize(QSize(_PICTURE, _PICTURE))
        self.table.setWordWrap(False)
        for column, (title, tip) in enumerate(_COLUMNS.items()):
            heading = QTableWidgetItem(tr(title))
            heading.setToolTip(f"<p>{tr(tip)}</p>")
            self.table.setHorizontalHeaderItem(column, heading)
        rows = self.table.verticalHeader()
        rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        rows.setDefaultSectionSize(max(_PICTURE, self.fontMetrics().height()) + _BETWEEN)
        header = self.table.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignCenter)
        header.setMaximumSectionSize(_WIDEST * self.fontMetrics().averageCharWidth())
        self.table.setItemDelegateForColumn(0, _NameDelegate(self.table))
        self.table.itemChanged.connect(self._read_change)
        self.table.itemSelectionChanged.connect(self._show_possible)
        self._by_key = self.table.add_action(tr("Delete"), QKeySequence.StandardKey.Delete)
        self._by_key.triggered.connect(self.delete_asked)
        tip = tr("Compare irradiance, figures and fields of two selected runs")
        self._restore, self._delete, self._compare = buttons = [
            push_button(
                tr("Restore"), tr("Restore task and result of this run"), self.restore_asked.emit
            ),
            push_button(tr("Delete"), tr("Delete the selected runs"), self.delete_asked.emit),
            push_button(tr("Compare"), tip, self.compare_asked.emit),
        ]
        self._editable = True
        below = filled(QHBoxLayout(), *buttons, STRETCH, margins=(6, 4, 6, 4), spacing=6)
        filled(QVBoxLayout(self), (self._hint, 1), (self.table, 1), below, margins=0, spacing=0)
        self.show_runs((), None)

    @property
    def marked(self) -> tuple[KeptRun, ...]:
        return tuple(run for run in self._runs if id(run.result) in self._marked)

    @property
    def chosen(self) -> tuple[KeptRun, ...]:
        rows = {index.row() for index in self.table.selectedIndexes()}
        return tuple(self._runs[row] for row in sorted(rows))

    def show_runs(self, runs: Sequence[KeptRun], current: KeptRun | None) -> None:
        stays = self.table.currentRow()
        self._runs = tuple(runs)
        there = {id(run.result) for run in runs}
        self._marked &= there
        self._pictures = {key: each for key, each in self._pictures.items() if key in there}
        with QSignalBlocker(self.table):
            self.table.setRowCount(len(runs))
            for row, run in enumerate(runs):
                self._fill(row, run, run is current)
        self.table.setVisible(bool(runs))
        self._hint.setVisible(not runs)
        if 0 <= stays < len(runs):
            self.table.selectRow(stays)
        self._show_possible()

    def show_verified(self) -> None:
        with QSignalBlocker(self.table):
            for row, run in enumerate(self._runs):
                item = self.table.item(row, _VERIFIED)
                assert item is not None  # each row is filled
                item.setText(self._verified(run) or "–")

    def allow(self, editable: bool) -> None:
        self._editable = editable
        triggers = QAbstractItemView.EditTrigger
        self.table.setEditTriggers(
            triggers.DoubleClicked | triggers.EditKeyPressed
            if editable
            else triggers.NoEditTriggers
        )
        self._show_possible()

    def _fill(self, row: int, run: KeptRun, is_current: bool) -> None:
        name = QTableWidgetItem(self._picture(run), called(run))
        marked = id(run.result) in self._marked
        name.setCheckState(Qt.CheckState.Checked if marked else Qt.CheckState.Unchecked)
        font = name.font()
        font.setBold(is_current)
        name.setFont(font)
        own = tr("Run of the current lens")
        name.setToolTip(f"{name.text()}\n{own}" if is_current else name.text())
        self.table.setItem(row, 0, name)
        for column, (title, text) in enumerate(figures_of(run, self._verified(run)), start=1):
            item = QTableWidgetItem(text)
            item.setFlags(item.flags() & ~Qt.ItemFlag.ItemIsEditable)
            sides = Qt.AlignmentFlag
            side = sides.AlignLeft if title in _LEFT else sides.AlignRight
            item.setTextAlignment(side | sides.AlignVCenter)
            item.setToolTip(text)
            self.table.setItem(row, column, item)

    def _picture(self, run: KeptRun) -> QIcon:
        result = id(run.result)
        if result not in self._pictures:
            self._pictures[result] = QIcon(thumbnail_of(run, _PICTURE))
        return self._pictures[result]

    def _read_change(self, item: QTableWidgetItem) -> None:
        run = self._runs[item.row()]
        result = id(run.result)
        marked = item.checkState() is Qt.CheckState.Checked
        if marked != (result in self._marked):
            self._marked ^= {result}
            self.marks_changed.emit()
        elif item.text() != called(run):
            self.renamed.emit(run, item.text())

    def _show_possible(self) -> None:
        chosen = len(self.chosen)
        self._restore.setEnabled(self._editable and chosen == 1)
        for delete in (self._delete, self._by_key):
            delete.setEnabled(self._editable and chosen > 0)
        self._compare.setEnabled(chosen == 2)


class _NameDelegate(QStyledItemDelegate):
    def createEditor(
        self,
        parent: QWidget,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> QWidget:
        editor = QLineEdit(parent, frame=False, maxLength=LONGEST_NAME)
        editor.inputRejected.connect(partial(_show_too_long, editor))
        return editor


def _show_too_long(editor: QLineEdit) -> None:
    below = editor.mapToGlobal(editor.rect().bottomLeft())
    QToolTip.showText(
        below, tr("A name has at most {count} characters").format(count=LONGEST_NAME), editor
    )
