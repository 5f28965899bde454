"""Panels below each other, with groups of what is seldom needed, and a line that searches."""

from collections.abc import Sequence, Set
from functools import partial
from itertools import pairwise

from PySide6.QtCore import QCoreApplication, QEvent, QSettings, Qt, QTimer
from PySide6.QtGui import QKeySequence, QResizeEvent, QShortcut, QShowEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QVBoxLayout, QWidget

from ui.panels.fields import Row
from ui.panels.panel import Panel
from ui.widgets import theme
from ui.widgets.controls import STRETCH, filled
from ui.widgets.folds import Fold
from ui.widgets.labels import WrappedLabel
from ui.widgets.native import available_size
from ui.widgets.search import SearchLine
from ui.words import later, tr
from workbench.levels import Level

_GROUPS = later({Level.LIMITS: "Limits", Level.EXPERT: "Expert"})
_MOST_OF_SCREEN = 0.29  # of its width, that the forms insist on
_GRID = 8  # pixels
_MARKED = 1500  # milliseconds


class FormArea(QScrollArea):
    """Shows which rows there are, and finds rows."""

    def __init__(self, panels: Sequence[Panel]) -> None:
        super().__init__()
        self.panels = panels
        self._present: Sequence[Row] = ()
        self._refused: Set[Row] = frozenset()
        self._ordered: list[Row] = []
        self._hint, self._nothing = WrappedLabel(), WrappedLabel(tr("No field matches."))
        for label in (self._hint, self._nothing):
            label.setObjectName("hint")
            label.hide()
        self._groups = {level: Fold(tr(title)) for level, title in _GROUPS.items()}
        for level, group in self._groups.items():
            sections = [panel.deeper[level] for panel in panels]
            filled(QVBoxLayout(group.body), *sections, margins=0, spacing=0)
            group.unfold(False)
        self._content = QWidget()
        parts: list[QWidget] = [self._hint, self._nothing, *panels, *self._groups.values()]
        filled(QVBoxLayout(self._content), *parts, STRETCH, margins=0, spacing=0)
        self.setWidget(self._content)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        tip = tr("Search all fields by name, explanation or path in files (Ctrl+F)")
        self.search = SearchLine(tr("Search fields"), tip)
        self.search.setParent(self)
        self.search.textChanged.connect(self._show_rows)
        self.search.returnPressed.connect(self._focus_first)
        self.setViewportMargins(0, self.search.sizeHint().height() + 2 * _GRID, 0, 0)
        find = QShortcut(QKeySequence(QKeySequence.StandardKey.Find), self)
        find.activated.connect(self.search.begin)

    def showEvent(self, event: QShowEvent) -> None:
        """Set the minimum width to that of the rows, limited by the screen."""
        super().showEvent(event)
        rows = self._content.minimumSizeHint().width() + self.verticalScrollBar().sizeHint().width()
        self.setMinimumWidth(min(rows, int(_MOST_OF_SCREEN * available_size(self).width())))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        width = self.viewport().width() - 2 * _GRID
        self.search.setGeometry(_GRID, _GRID, width, self.search.sizeHint().height())

    def remember(self, settings: QSettings) -> None:
        """Unfold the groups that were unfolded before, and keep what is folded from now on."""
        for level, group in self._groups.items():
            key = f"form/{level.name.lower()}"
            group.unfold(bool(settings.value(key, False, bool)))
            group.unfolded.connect(partial(settings.setValue, key))

    def reveal(self, row: Row) -> None:
        """Unfold what holds a row, and scroll to it."""
        for panel in self.panels:
            if row in panel.rows:
                self._groups.get(row.level, panel).unfold(True)
        if row.isHidden():
            self.search.clear()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)
        self.ensureWidgetVisible(row)

    def show_part(self, path: str) -> None:
        """Select a part of the scene, scroll to its first field, and mark and focus this field."""
        for panel in self.panels:
            panel.select(path)
        row = next((row for row in self._ordered if row.path.startswith(f"{path}.")), None)
        if row is None:
            return
        self.reveal(row)
        top = row.mapTo(self._content, row.rect().topLeft()).y()
        self.verticalScrollBar().setValue(top - 2 * row.height())  # below its heading
        row.label.buddy().setFocus(Qt.FocusReason.ShortcutFocusReason)
        mark(row, True)
        QTimer.singleShot(_MARKED, row, partial(mark, row, False))

    def show_rows(self, present: Sequence[Row], refused: Set[Row]) -> None:
        """Show the rows of a scene, which they show already; refused ones are revealed."""
        self._present, self._refused = present, refused
        for level, group in self._groups.items():
            of_level = [row for row in present if row.level is level]
            names = {row.path: row.name for row in of_level if row.changed}
            note = tr("{count} changed").format(count=len(names)) if names else ""
            group.note(note, "\n".join(names.values()))
            if not refused.isdisjoint(of_level):
                group.unfold(True)
        self._show_rows()
        order = sorted(present, key=lambda row: row.level)
        if order != self._ordered:
            self._ordered = order
            self._put_in_tab_order()
            self._align()

    def _show_rows(self) -> None:
        """Show the rows that the search finds, and those that are refused."""
        words = self.search.words
        shown: set[Row] = set()
        for found in self._present:
            row = found if found.matches(words) or found in self._refused else None
            while row is not None:
                shown.add(row)
                row = row.above
        self._nothing.setVisible(not shown)
        for fold in (*self.panels, *self._groups.values()):
            fold.force(bool(words))
        for panel in self.panels:
            panel.show_rows(shown)
            if any(row in self._refused and row.level is Level.JOB for row in panel.rows):
                panel.unfold(True)
        for level, group in self._groups.items():
            group.setVisible(any(row.level is level for row in shown))

    def _focus_first(self) -> None:
        row = next((row for row in self._ordered if not row.isHidden()), None)
        if row is not None:
            self.reveal(row)
            row.label.buddy().setFocus()

    def _align(self) -> None:
        """Let the editors of each level begin at one line."""
        for level in Level:
            labels = [row.label for row in self._ordered if row.level is level]
            width = max((label.sizeHint().width() for label in labels), default=0)
            for label in labels:
                label.setMinimumWidth(width)

    def _put_in_tab_order(self) -> None:
        """Let Tab reach all rows as they stand; those made later would come last."""
        stops = [
            widget
            for fold in (*self.panels, *self._groups.values())
            for widget in fold.findChildren(QWidget)
            if widget.focusPolicy() & Qt.FocusPolicy.TabFocus
            and widget.focusProxy() is None
            and widget.window() is self.window()  # not the lists that choosers open
        ]
        for before, after in pairwise([self.search, *stops]):
            self.setTabOrder(before, after)

    def _rows(self) -> list[Row]:
        return [row for panel in self.panels for row in panel.rows]


def mark(row: Row, on: bool) -> None:
    """Draw the label of a row as one that was looked for."""
    row.label.setProperty("marked", on)
    theme.restyle(row.label)
