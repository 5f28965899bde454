"""The page that a window begins with: a picture, a job, a recent file or an example."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QRect, QSettings, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QKeyEvent, QMouseEvent, QShowEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

import resources
from resources import EXAMPLES, Example
from ui.dialogs.job_page import JobPage
from ui.files.actions import FileActions, RecentFiles
from ui.files.dialogs import FileDialogs
from ui.widgets import theme
from ui.widgets.controls import STRETCH, filled, scrolled
from ui.widgets.labels import WrappedLabel, text_label
from ui.widgets.tiles import Shape, Tile, Tiles
from ui.words import tr
from workbench.errors import Refused
from workbench.files.scene import read_scene
from workbench.files.session import Session
from workbench.jobs import JOBS, Job
from workbench.scene.part import summary_of, title_of

_WELL_HIGH, _WIDEST, _ICON = 176, 1600, 48  # pixels
_MOST_RECENT = 6
_JOBS, _EXAMPLES = Shape(212, 0.625), Shape(128, 1.0, with_about=False)
_RECENT = Shape(150, 0.0)


class StartPage(QStackedWidget):
    """Begins designs: from a dropped picture, a job, a recent file or an example."""

    begun = Signal()
    left = Signal()

    def __init__(
        self,
        files: FileActions,
        recent: RecentFiles,
        open_example: Callable[[Example], object],
        dialogs: FileDialogs,
        settings: QSettings,
    ) -> None:
        super().__init__()
        self._files, self._recent, self._dialogs = files, recent, dialogs
        self.job = JobPage(dialogs, settings)
        self.job.begun.connect(self._begin)
        self.job.left.connect(partial(self.setCurrentIndex, 0))
        self.message = WrappedLabel(textFormat=Qt.TextFormat.PlainText)
        self.message.setObjectName("hint")
        self._well = Well()
        self._well.asked.connect(self._choose_picture)
        self._well.open.clicked.connect(files.choose_and_open)
        self.jobs = Tiles(tr("Jobs"), _JOBS)
        self.jobs.put([Tile(tr(title_of(k)), tr(summary_of(k)), _of_job(k)) for k in JOBS])
        self.jobs.chosen.connect(lambda row: self.show_job(JOBS[row]))
        self.examples = Tiles(tr("Examples"), _EXAMPLES)
        self.examples.put(list(map(_of_example, EXAMPLES)))
        self.examples.chosen.connect(lambda row: open_example(EXAMPLES[row]))
        self.recent = Tiles(tr("Recent files"), _RECENT)
        self.recent.chosen.connect(lambda row: files.open_recent(self._recent.paths()[row]))
        files.recent_changed.connect(self.refresh)
        self._beside = QWidget()
        title = text_label(tr("Recent files"), "title")
        filled(QVBoxLayout(self._beside), title, self.recent, STRETCH, margins=0)
        first = filled(QHBoxLayout(), (self._well, 3), (self._beside, 2), spacing=24)
        page = QWidget()
        filled(
            QVBoxLayout(page),
            *(self.message, first),
            *(text_label(tr("Begin with a job"), "title"), self.jobs),
            *(text_label(tr("Examples"), "title"), self.examples, STRETCH),
            margins=(24, 24, 16, 16),
            spacing=8,
        )
        page.setMaximumWidth(_WIDEST)
        self._page, self._scrolled = page, scrolled(page)
        self._scrolled.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self._scrolled.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        for tiles in (self.recent, self.jobs, self.examples):
            tiles.come_to.connect(partial(self._scroll_to, tiles))
        self.addWidget(self._scrolled)
        self.addWidget(self.job)
        self.refresh()

    def refresh(self) -> None:
        """Show the files that were open last, and no message."""
        self.message.hide()
        paths = self._recent.paths()[:_MOST_RECENT]
        self.recent.put([Tile(path.stem, _short(path.parent)) for path in paths])
        self._beside.setVisible(bool(paths))

    def begin_anew(self) -> None:
        """Show what can be begun with, from the top."""
        self.refresh()
        self.setCurrentIndex(0)
        self._well.choose.setFocus(Qt.FocusReason.TabFocusReason)
        bar = self._scrolled.verticalScrollBar()
        QTimer.singleShot(0, bar, partial(bar.setValue, 0))

    def show_job(self, kind: type[Job]) -> None:
        """Ask the questions of a job."""
        self.setCurrentWidget(self.job)
        self.job.show_job(kind)

    def use_picture(self, path: Path) -> None:
        """Use a picture for the job that is shown, or for the first one."""
        if self.currentWidget() is not self.job or not self.job.use_picture(path):
            self.show_job(JOBS[0])
            self.job.use_picture(path)

    def await_drop(self, awaited: bool) -> None:
        """Show that something can be dropped."""
        self._well.setProperty("active", awaited)
        theme.restyle(self._well)

    def show_message(self, text: str) -> None:
        self.message.setText(text)
        self.message.show()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.left.emit()
        else:
            super().keyPressEvent(event)

    def _begin(self, session: Session, name: str) -> None:
        if self._files.begin(session, name):
            self.setCurrentIndex(0)
            self.begun.emit()

    def _choose_picture(self) -> None:
        path = self._dialogs.picture(tr("Picture"))
        if path is not None:
            self.use_picture(path)

    def _scroll_to(self, tiles: Tiles, place: QRect) -> None:
        middle = tiles.mapTo(self._page, place.center())
        self._scrolled.ensureVisible(middle.x(), middle.y(), 0, place.height())


class Well(QFrame):
    """Where a picture is dropped, or asked for by a click."""

    asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("well")
        self.setMinimumHeight(_WELL_HIGH)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        centre = Qt.AlignmentFlag.AlignHCenter
        self._icon, title = QLabel(alignment=centre), text_label(tr("Drop a picture here"), "title")
        title.setAlignment(centre)
        hint = text_label(tr("The lens will draw it with light. Ctrl+V pastes one."), "muted")
        hint.setAlignment(centre)
        self.choose = QPushButton(tr("Choose &picture…"))
        self.open = QPushButton(tr("&Open design…"))
        self.choose.setObjectName("primary")
        self.choose.clicked.connect(self.asked)
        for button in (self.choose, self.open):
            button.setAutoDefault(True)
        row = filled(QHBoxLayout(), STRETCH, self.choose, self.open, STRETCH, spacing=8)
        filled(QVBoxLayout(self), STRETCH, self._icon, title, hint, row, STRETCH, spacing=6)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._icon.setPixmap(theme.icon("picture", self.palette()).pixmap(_ICON))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self.rect().contains(event.position().toPoint()):
            self.asked.emit()


def _short(folder: Path) -> str:
    own = Path.home()
    return f"~/{folder.relative_to(own)}" if folder.is_relative_to(own) else str(folder)


def _of_job(kind: type[Job]) -> Callable[[], QImage]:
    return partial(QImage, str(resources.path("jobs", f"{kind.__name__}.jpg")))


def _of_example(example: Example) -> Tile:
    return Tile(
        tr(example.title), f"{tr(example.group)}: {tr(example.look)}", partial(_target, example)
    )


def _target(example: Example) -> QImage:
    try:
        image = read_scene(example.file).image
    except Refused:  # reported when it is opened
        return QImage()
    return QImage() if image is None else QImage(image)
