"""A job: its questions, its drawing, what can be expected of it, and the button that begins it."""

import json
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QSettings, Qt, Signal
from PySide6.QtGui import QHideEvent, QKeyEvent
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from ui.dialogs.drawing import SideDrawing
from ui.dialogs.estimate import EstimateView
from ui.dialogs.job_form import JobForm
from ui.files.dialogs import FileDialogs
from ui.panels.editors import Remark
from ui.widgets.controls import STRETCH, filled, scrolled
from ui.words import tr
from workbench.errors import Refused
from workbench.files.session import Session
from workbench.jobs import Job, side_view
from workbench.scene.part import title_of

_FORM_WIDE = 400  # pixels
_OF_FILES = ("target", "file")  # answers that are not remembered


class JobPage(QWidget):
    """Shows form, drawing and estimate of a job, and draws its target before it begins."""

    begun = Signal(object, str)  # Session, str
    left = Signal()

    def __init__(self, dialogs: FileDialogs, settings: QSettings) -> None:
        super().__init__()
        self._dialogs, self._settings = dialogs, settings
        self._session: Session | None = None  # of the job as it is now
        self._begins = False  # as soon as there is one
        self._obstacle = ""  # why there is none
        self._refusal = Remark("refusal")
        self._drawing, self.estimate = SideDrawing(), EstimateView()
        self.estimate.drawn.connect(self._take)
        self.estimate.refused.connect(self._refuse)
        self.form: JobForm  # of the job that is shown
        self._form = scrolled(QWidget())
        self._form.setFixedWidth(_FORM_WIDE)
        self._back, self._begin = QPushButton(tr("B&ack")), QPushButton(tr("&Begin"))
        self._begin.setObjectName("primary")
        for button in (self._back, self._begin):
            button.setAutoDefault(True)  # Enter presses the one with the focus
        self._back.clicked.connect(self.left)
        self._begin.clicked.connect(self.begin)
        aside = QWidget()
        filled(QVBoxLayout(aside), (self._drawing, 1), self.estimate, margins=0)
        aside_scrolled = scrolled(aside, across=True)
        parts = filled(QHBoxLayout(), self._form, (aside_scrolled, 1), spacing=24)
        buttons = filled(QHBoxLayout(), self._back, STRETCH, self._begin)
        filled(QVBoxLayout(self), (parts, 1), self._refusal, buttons, margins=24, spacing=12)

    def show_job(self, kind: type[Job]) -> None:
        """Ask the questions of a job, with the answers of the last time."""
        job = kind()
        with suppress(Refused, ValueError, TypeError):
            job = job.with_answers(json.loads(str(self._settings.value(_key(kind)))))
        self.form = JobForm(job)
        self.form.changed.connect(self._update)
        self.form.asked.connect(self._choose_file)
        self._form.setWidget(self.form)
        QWidget.setTabOrder(self.form, self._back)
        self.form.rows[0].label.buddy().setFocus() if self.form.rows else self._begin.setFocus()
        self._update()

    def use_picture(self, path: Path) -> bool:
        """Use a picture; False for a job without one."""
        if "target" not in type(self.form.job).model_fields:
            return False
        self.form.choose_image(path)
        self._begin.setFocus()
        return True

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

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._begins = False
        self.estimate.cancel()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.begin()
        elif event.key() == Qt.Key.Key_Escape:
            self.left.emit()
        else:
            super().keyPressEvent(event)

    def _update(self) -> None:
        self._session, self._begins, self._obstacle = None, False, ""
        self._refusal.show_text("")
        self._begin.setEnabled(not self.form.refused)
        if self.form.refused:
            self.estimate.cancel()
            self.estimate.outdate()
            return
        self._drawing.show_view(side_view(self.form.job.scene()))
        self.estimate.begin(self.form.job)

    def _take(self, session: Session) -> None:
        self._session = session
        if self._begins:
            self._end(session)

    def _end(self, session: Session) -> None:
        self._begins = False
        kind = type(self.form.job)
        answers = self.form.job.model_dump(mode="json", exclude_none=True, exclude={*_OF_FILES})
        self._settings.setValue(_key(kind), json.dumps(answers))
        self.begun.emit(session, tr(title_of(kind)))

    def _refuse(self, why: str) -> None:
        self._obstacle = why
        if self._begins:
            self._show_obstacle()

    def _show_obstacle(self) -> None:
        if self._obstacle:
            why = tr("Cannot begin: {reason}").format(reason=self._obstacle)
            self._refusal.show_text(f"\N{WARNING SIGN} {why}")

    def _choose_file(self, asking: str) -> None:
        light = asking == "file"
        path = self._dialogs.light() if light else self._dialogs.picture(tr("Picture"))
        if path is None:
            self.form.show_rows()
        else:
            (self.form.choose_light if light else self.form.choose_image)(path)


def _key(kind: type[Job]) -> str:
    return f"jobs/{kind.__name__}"
