"""What can be expected of a job, found in a thread: figures, and the picture as at best."""

from functools import partial
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from ui.background import Background, Task
from ui.panels.editors import Remark
from ui.panels.images import Thumbnail
from ui.widgets.controls import filled
from ui.widgets.labels import WrappedLabel
from ui.words import capitalised, later, tr
from workbench.files.session import Session
from workbench.jobs import Job
from workbench.scene import Scene
from workbench.scene.image import as_viewed, side_in_words, viewed_from

if TYPE_CHECKING:
    from workbench.jobs.prospect import Figure, Prospect

_HIGH = 160  # logical pixels of a picture: two of them are compared


def estimate(job: Job, task: Task) -> None:
    """Report the session of a job, then how far the estimate is, and what is found."""
    from workbench.design.task import begin  # late: take long to import
    from workbench.jobs.prospect import prospecting

    session = begin(job.scene(), Path.cwd())
    task.report(session)
    found = task.follow(
        prospecting(session), lambda step: None if step is None else task.report(step)
    )
    if found is not None:
        task.report(found)


class EstimateView(QWidget):
    """Finds and shows the estimate of a job, and its target before."""

    drawn = Signal(object)  # Session
    estimated = Signal(object)  # Prospect
    refused = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._background = Background(later("estimate"), self)
        self._background.progressed.connect(self._show)
        self._background.failed.connect(self._refuse)
        self._aspect = 1.0
        self._scene: Scene | None = None  # of the shown target
        self._wanted, self._at_best = Thumbnail(_HIGH), Thumbnail(_HIGH)
        self._at_best.setAccessibleName(tr("Best possible image"))
        self._at_best.setToolTip(tr("The source size blurs the image of any lens"))
        self._side = QLabel(alignment=Qt.AlignmentFlag.AlignHCenter)
        self._state = Remark()
        self._figures = WrappedLabel()
        pictures = QHBoxLayout()
        for title, picture in ((tr("Target"), self._wanted), (tr("Best possible"), self._at_best)):
            column = filled(
                QVBoxLayout(), QLabel(title, alignment=Qt.AlignmentFlag.AlignHCenter), picture
            )
            pictures.addLayout(column)
        filled(QVBoxLayout(self), pictures, self._side, self._state, self._figures, margins=0)

    @property
    def text(self) -> str:
        labels = self._side, self._state, self._figures
        return "\n".join(label.text() for label in labels)

    def begin(self, job: Job) -> None:
        """Estimate a job, and mark the figures of the one before as outdated."""
        self.outdate()
        computing = tr("Computing the estimate…")
        self._state.show_text(f"{computing} {self._state.text()}".strip())
        self._background.begin(partial(estimate, job))

    def cancel(self) -> None:
        self._background.cancel()

    def outdate(self) -> None:
        self._figures.setEnabled(False)
        self._state.show_text(tr("Outdated figures.") if self._figures.text() else "")
        self._at_best.clear()

    def _show(self, _: object, found: "Session | Prospect | float") -> None:
        if isinstance(found, float):
            self._state.show_text(tr("Estimating… {part:.0f} %").format(part=100 * found))
        elif isinstance(found, Session):
            self._show_target(found)
            self.drawn.emit(found)
        else:
            self._show_prospect(found)
            self.estimated.emit(found)

    def _refuse(self, why: str) -> None:
        self._figures.clear()
        self._state.show_text(f"\N{WARNING SIGN} {why}")
        self.refused.emit(why)

    def _show_target(self, session: Session) -> None:
        scene = self._scene = session.scene
        half_u, half_v = scene.receiver.half_extent
        self._aspect = half_u / half_v
        self._wanted.show_target(as_viewed(scene, session.target), self._aspect)
        self._side.setText(capitalised(tr(side_in_words(scene, viewed_from(scene)))))

    def _show_prospect(self, found: "Prospect") -> None:
        if found.picture is None:
            self._state.show_text(tr("Computing the estimate…"))
        elif self._scene is not None:
            self._state.show_text("")
            self._at_best.show_target(as_viewed(self._scene, found.picture), self._aspect)
        self._figures.setText(f"<table>{''.join(map(_row, found.figures))}</table>")
        self._figures.setEnabled(True)


def _row(figure: "Figure") -> str:
    mark = "\N{WARNING SIGN} " if figure.warns else ""
    value, meaning = escape(tr(figure.value)), escape(capitalised(tr(figure.meaning)))
    return (
        f"<tr><td style='padding-right: 12px'>{escape(tr(figure.name))}</td>"
        f"<td style='padding-bottom: 4px'>"
        f"<span style='font-weight: 600'>{mark}{value}</span><br>{meaning}</td></tr>"
    )
