"""The shelf: tasks in the background that a person waits for, in a panel above the status bar."""

from pathlib import Path

from PySide6.QtCore import QObject, QPoint, QSize, Qt, QTimer, QUrl, Signal
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.background import Background, Task
from ui.widgets.controls import STRETCH, filled, scrolled
from ui.widgets.labels import ElidedLabel, WrappedLabel
from ui.words import tr

_WIDTH, _MOST_HEIGHT = 380, 420  # pixels
_SMALL = QSize(64, 6)  # of the progress bar beside the button
_MOST = 12  # entries
_SOON_MS = 300  # work that ends sooner is not announced


def open_folder(path: Path | None) -> None:
    """Show a folder, or that of a file, in the file manager."""
    if path is not None:
        _open(path if path.is_dir() else path.parent)


class Entry(QFrame):
    """A task: title, progress and Cancel; then its outcome, with buttons for what it wrote."""

    def __init__(self, task: Task, background: Background) -> None:
        super().__init__()
        self.setObjectName("card")
        self.task = task
        title = ElidedLabel()
        title.setText(task.title)
        title.setStyleSheet("font-weight: 600")
        self.setAccessibleName(task.title)
        self.outcome = WrappedLabel(textFormat=Qt.TextFormat.PlainText)
        self.outcome.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.bar = QProgressBar(textVisible=False)
        self.bar.setFixedHeight(_SMALL.height())
        self.bar.setAccessibleName(tr("Progress of {task}").format(task=task.title))
        self.part = QLabel()
        self.cancel, self.open, self.folder = buttons = [
            QPushButton(text) for text in (tr("Cancel"), tr("Open"), tr("Open folder"))
        ]
        self.cancel.clicked.connect(background.stop)
        self.cancel.clicked.connect(self.refresh)
        self.open.clicked.connect(lambda: _open(task.path))
        self.folder.clicked.connect(lambda: open_folder(task.path))
        top = filled(QHBoxLayout(), (title, 1), self.part, spacing=8)
        below = filled(QHBoxLayout(), STRETCH, *buttons, spacing=6)
        filled(QVBoxLayout(self), top, self.bar, self.outcome, below, margins=8, spacing=6)
        self.refresh()

    def refresh(self) -> None:
        task = self.task
        _show_part(self.bar, task.part)
        self.bar.setHidden(task.ended)
        known = "" if task.part is None else f"{round(100 * task.part)} %"
        self.part.setText("" if task.ended else known)
        stopping = tr("Ends soon…") if task.stopped else ""
        self.outcome.setText(task.outcome if task.ended else stopping)
        self.outcome.setVisible(bool(self.outcome.text()))
        self.cancel.setHidden(task.ended)
        self.cancel.setEnabled(not task.stopped)
        there = task.ended and task.path is not None and task.path.exists()
        self.open.setVisible(there and task.path is not None and task.path.is_file())
        self.folder.setVisible(there)


class Shelf(QWidget):
    """Button with the number of running tasks, and a panel of entries, the latest first.

    An ended task without an outcome leaves the panel.
    """

    written = Signal(str, object)  # outcome, path

    def __init__(self) -> None:
        super().__init__()
        self.entries: list[Entry] = []
        self._followed: set[Background] = set()
        self.button, self._bar = QToolButton(), QProgressBar(textVisible=False)
        self.button.setAutoRaise(True)
        self.button.setToolTip(tr("Checks, exports, reports and sweeps in the background"))
        self.button.clicked.connect(self.open)
        self._bar.setFixedSize(_SMALL)
        self._bar.setAccessibleName(tr("Progress of the tasks"))
        filled(QHBoxLayout(self), self._bar, self.button, margins=0, spacing=6)
        self.panel = QFrame(self, Qt.WindowType.Popup)
        self.panel.setObjectName("shelf")
        self.panel.setAccessibleName(tr("Tasks"))
        self._none = WrappedLabel(tr("No tasks. Checks, exports, reports and sweeps appear here."))
        self._inner = QWidget()
        self._column = filled(QVBoxLayout(self._inner), self._none, margins=8, spacing=8)
        filled(QVBoxLayout(self.panel), scrolled(self._inner), margins=1)
        self._soon = QTimer(self, singleShot=True, interval=_SOON_MS)
        self._soon.timeout.connect(self._show_count)
        self._show_count()

    def follow(self, owner: QObject) -> None:
        """List all work of an object and its children that has a title; again for new children."""
        new = set(owner.findChildren(Background)) - self._followed
        self._followed |= new
        for background in new:
            background.changed.connect(lambda task, of=background: self._show(task, of))

    @property
    def running(self) -> list[Task]:
        return [entry.task for entry in self.entries if not entry.task.ended]

    def open(self) -> None:
        self._place()
        self.panel.show()
        self._place()  # the height of its texts is known from here on
        first = self.panel.findChild(QPushButton)
        (first or self.panel).setFocus(Qt.FocusReason.PopupFocusReason)

    def _show(self, task: Task, background: Background) -> None:
        entry = next((each for each in self.entries if each.task is task), None)
        if entry is None:
            entry = Entry(task, background)
            self.entries.insert(0, entry)
            self._column.insertWidget(0, entry)
        if task.ended and not task.outcome:
            self._remove(entry)
        else:
            entry.refresh()
        ended = [each for each in self.entries if each.task.ended]
        if len(self.entries) > _MOST and ended:
            self._remove(ended[-1])
        self._none.setVisible(not self.entries)
        if task.ended and task.path is not None:
            self.written.emit(task.outcome, task.path)
        if not self._soon.isActive():
            self._soon.start()
        if self.panel.isVisible():
            self._place()

    def _remove(self, entry: Entry) -> None:
        self.entries.remove(entry)
        entry.hide()
        entry.deleteLater()

    def _show_count(self) -> None:
        running = self.running
        parts = [task.part for task in running if task.part is not None]
        _show_part(self._bar, sum(parts) / len(parts) if parts else None)
        self._bar.setVisible(bool(running))
        count = len(running)
        self.button.setText(tr("Tasks ({count})").format(count=count) if count else tr("Tasks"))

    def _place(self) -> None:
        width = min(_WIDTH, self.window().width())
        inner = width - 4  # margins and border
        column = self._column
        hint = column.sizeHint().height()
        wanted = 4 + (column.heightForWidth(inner) if column.hasHeightForWidth() else hint)
        height = min(wanted, _MOST_HEIGHT, self.window().height() // 2)
        corner = self.mapToGlobal(QPoint(self.width() - width, -height - 4))
        self.panel.setGeometry(corner.x(), corner.y(), width, height)


def _show_part(bar: QProgressBar, part: float | None) -> None:
    bar.setRange(0, 0 if part is None else 100)
    bar.setValue(0 if part is None else round(100 * part))


def _open(path: Path | None) -> None:
    if path is not None:
        QDesktopServices.openUrl(QUrl.fromLocalFile(path.absolute()))
