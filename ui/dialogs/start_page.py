"""The page that a new design begins with: choose a job, answer its questions, begin."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QSize, Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QListWidget,
    QPushButton,
    QScrollArea,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from ui.dialogs.drawing import SideDrawing
from ui.dialogs.estimate import EstimateView, Estimator
from ui.dialogs.job_form import JobForm
from ui.files.actions import FileActions
from ui.files.dialogs import FileDialogs
from ui.panels.editors import Refusal
from ui.panels.images import image_files
from ui.panels.scene import light_files
from ui.widgets.controls import filled
from ui.words import tr
from workbench.jobs import JOBS, side_view
from workbench.scene.part import summary_of, title_of

if TYPE_CHECKING:
    from workbench.files.session import Session
    from workbench.jobs import Job

_SIZE = QSize(1240, 820)
_JOBS_WIDE, _FORM_WIDE = 190, 330  # pixels at least


class StartPage(QDialog):
    """Lists the jobs; shows form, drawing and estimate of the selected one."""

    begun = Signal(object, str)  # Session, str
    open_asked = Signal()
    examples_asked = Signal()

    def __init__(self, dialogs: FileDialogs, window: QWidget) -> None:
        super().__init__(window)
        self.setWindowTitle(tr("New design"))
        self._dialogs = dialogs
        self._session: Session | None = None  # of the job as it is now
        self._begins = False  # as soon as there is one
        self._obstacle = ""  # why there is none
        self._refusal = Refusal()
        self._estimator = Estimator(self)
        self._drawing, self._estimate = SideDrawing(), EstimateView()
        self._jobs = QListWidget()
        self._jobs.setAccessibleName(tr("Jobs"))
        self._jobs.setSpacing(3)
        self._stack = QStackedWidget()
        self._stack.setMinimumWidth(_FORM_WIDE)
        self._forms = [JobForm(kind()) for kind in JOBS]
        for kind, form in zip(JOBS, self._forms, strict=True):
            self._jobs.addItem(tr(title_of(kind)))
            self._jobs.item(self._jobs.count() - 1).setToolTip(tr(summary_of(kind)))
            form.changed.connect(self._update)
            form.image_asked.connect(self._choose_image)
            form.light_asked.connect(self._choose_light)
            self._stack.addWidget(form)
        beside = self._jobs.frameWidth() + self._jobs.spacing()
        self._jobs.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._jobs.setFixedWidth(max(self._jobs.sizeHintForColumn(0) + 2 * beside, _JOBS_WIDE))
        self._lay_out()
        self._estimator.ready.connect(self._store)
        self._estimator.found.connect(self._estimate.show_prospect)
        self._estimator.progressed.connect(self._estimate.show_progress)
        self._estimator.failed.connect(self._refuse)
        self.finished.connect(self._close)
        self._jobs.currentRowChanged.connect(self._choose)
        self._jobs.setCurrentRow(0)
        self.resize(_SIZE.boundedTo(window.size()))
        self._jobs.setFocus()

    @property
    def form(self) -> JobForm:
        return self._forms[self._stack.currentIndex()]

    def select(self, kind: "type[Job]") -> None:
        self._jobs.setCurrentRow(JOBS.index(kind))

    def begin(self) -> None:
        """Begin the job, now or as soon as its target is drawn."""
        self.form.commit()
        if self.form.refused:
            return
        self._begins = True
        if self._session is not None:
            self._end(self._session)
        else:
            self._show_obstacle()

    def _lay_out(self) -> None:
        aside = QWidget()
        filled(QVBoxLayout(aside), (self._drawing, 1), self._estimate, margins=0)
        scrolled = QScrollArea()
        scrolled.setWidget(aside)
        scrolled.setWidgetResizable(True)
        scrolled.setFrameShape(QScrollArea.Shape.NoFrame)
        line = filled(QHBoxLayout(), self._jobs, (self._stack, 2), (scrolled, 3))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self._begin = buttons.addButton(tr("&Begin"), QDialogButtonBox.ButtonRole.AcceptRole)
        for text, asked in (
            (tr("&Open a file…"), self.open_asked),
            (tr("E&xamples…"), self.examples_asked),
        ):
            button = buttons.addButton(text, QDialogButtonBox.ButtonRole.ResetRole)
            button.clicked.connect(self.reject)
            button.clicked.connect(asked.emit)
        buttons.accepted.connect(self.begin)
        buttons.rejected.connect(self.reject)
        filled(QVBoxLayout(self), (line, 1), self._refusal, buttons)
        for button in self.findChildren(QPushButton):
            button.setAutoDefault(button is self._begin)
        self._begin.setDefault(True)  # here, since buttons forget it on their way into a dialog

    def _choose(self, row: int) -> None:
        self._stack.setCurrentIndex(row)
        self._update()

    def _update(self) -> None:
        self._session, self._begins, self._obstacle = None, False, ""
        self._refusal.show_text("")
        self._begin.setEnabled(not self.form.refused)
        if self.form.refused:
            self._estimator.leave()
            self._estimate.outdate()
            return
        self._drawing.show_view(side_view(self.form.job.scene()))
        self._estimate.wait()
        self._estimator.estimate(self.form.job)

    def _store(self, session: "Session") -> None:
        self._session = session
        self._estimate.show_target(session)
        if self._begins:
            self._end(session)

    def _end(self, session: "Session") -> None:
        self._begins = False
        self.begun.emit(session, tr(title_of(type(self.form.job))))

    def _refuse(self, why: str) -> None:
        self._obstacle = why
        self._estimate.refuse(why)
        if self._begins:
            self._show_obstacle()

    def _show_obstacle(self) -> None:
        if self._obstacle:
            why = tr("Cannot begin: {reason}").format(reason=self._obstacle)
            self._refusal.show_text(f"\N{WARNING SIGN} {why}")

    def _choose_image(self) -> None:
        path = self._dialogs.to_open("image", tr("Picture"), image_files())
        if path is not None:
            self.form.choose_image(path)
        else:
            self.form.show_job()

    def _choose_light(self) -> None:
        path = self._dialogs.to_open("light", tr("File of light"), light_files())
        if path is not None:
            self.form.choose_light(path)

    def _close(self) -> None:
        self._estimator.close()
        self.deleteLater()


class Start(QObject):
    """Has at most one start page open."""

    open_changed = Signal(bool)

    def __init__(
        self,
        files: FileActions,
        show_examples: Callable[[], object],
        dialogs: FileDialogs,
        window: QWidget,
    ) -> None:
        super().__init__(window)
        self._files, self._show_examples = files, show_examples
        self._dialogs, self._window = dialogs, window
        self.page: StartPage | None = None

    def show(self) -> None:
        if self.page is not None:
            return
        self.page = page = StartPage(self._dialogs, self._window)
        page.begun.connect(self._begin)
        page.open_asked.connect(self._files.choose_and_open)
        page.examples_asked.connect(self._show_examples)
        page.finished.connect(self._forget)
        self.open_changed.emit(True)
        page.open()

    def close(self) -> None:
        if self.page is not None:
            self.page.reject()

    def _begin(self, session: "Session", name: str) -> None:
        if self._files.begin(session, name) and self.page is not None:
            self.page.accept()

    def _forget(self) -> None:
        self.page = None
        self.open_changed.emit(False)
