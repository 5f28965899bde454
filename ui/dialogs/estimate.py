"""What can be expected of a job, found in a thread: figures, and the picture as at best."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from ui.background import Background, Task
from ui.panels.editors import Wrapped
from ui.panels.images import Thumbnail
from ui.widgets.controls import filled
from ui.widgets.labels import WrappedLabel
from ui.words import capitalised, later, tr
from workbench.scene.image import as_viewed, side_in_words, viewed_from

if TYPE_CHECKING:
    from workbench.files.session import Session
    from workbench.jobs import Job
    from workbench.jobs.prospect import Figure, Prospect
    from workbench.scene import Scene

_HIGH = 160  # logical pixels of a picture: two of them are compared


class Estimator(QObject):
    """Draws the target of a job and estimates its result in a thread."""

    ready = Signal(object)  # Session
    found = Signal(object)  # Prospect
    progressed = Signal(float)
    failed = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._background = Background(later("estimate"), self)
        self._background.progressed.connect(self._pass_on)
        self._background.done.connect(self._emit_found)
        self._background.failed.connect(self.failed)

    def estimate(self, job: "Job") -> None:
        self._background.begin(partial(_find, job))

    def leave(self) -> None:
        self._background.cancel()

    def close(self) -> None:
        self._background.close()

    def _pass_on(self, _: object, reported: "Session | Prospect | float") -> None:
        from workbench.jobs.prospect import Prospect  # late: takes long to import

        if isinstance(reported, float):
            self.progressed.emit(reported)
        elif isinstance(reported, Prospect):
            self.found.emit(reported)
        else:
            self.ready.emit(reported)

    def _emit_found(self, _: object, found: "Prospect | None") -> None:
        if found is not None:
            self.found.emit(found)


def _find(job: "Job", task: Task) -> "Prospect | None":
    from workbench.design.task import begin  # late: take long to import
    from workbench.jobs.prospect import prospecting

    session = begin(job.scene(), Path.cwd())
    task.report(session)
    return task.follow(
        prospecting(session), lambda step: None if step is None else task.report(step)
    )


class EstimateView(QWidget):
    """Shows the estimate of a job."""

    def __init__(self) -> None:
        super().__init__()
        self._aspect = 1.0
        self._scene: Scene | None = None  # of the shown target
        self._labels: list[QLabel] = []
        self._wanted, self._at_best = Thumbnail(_HIGH), Thumbnail(_HIGH)
        self._at_best.setAccessibleName(tr("Best possible image"))
        self._at_best.setToolTip(tr("The source size blurs the image of any lens"))
        self._side = QLabel(alignment=Qt.AlignmentFlag.AlignHCenter)
        self._state = Wrapped()
        self._figures = QGridLayout()
        self._figures.setHorizontalSpacing(12)
        self._figures.setColumnStretch(1, 1)
        pictures = QHBoxLayout()
        for title, picture in ((tr("Target"), self._wanted), (tr("Best possible"), self._at_best)):
            column = filled(
                QVBoxLayout(), QLabel(title, alignment=Qt.AlignmentFlag.AlignHCenter), picture
            )
            pictures.addLayout(column)
        filled(QVBoxLayout(self), pictures, self._side, self._state, self._figures, margins=0)

    @property
    def text(self) -> str:
        labels = self._side, self._state, *self._labels
        return "\n".join(label.text() for label in labels)

    def wait(self) -> None:
        """Show that figures are computed, and mark the old ones as outdated."""
        self.outdate()
        computing = tr("Computing the estimate…")
        self._state.show_text(f"{computing} {self._state.text()}".strip())

    def outdate(self) -> None:
        for label in self._labels:
            label.setEnabled(False)
        self._state.show_text(tr("Outdated figures.") if self._labels else "")
        self._at_best.clear()

    def show_progress(self, part: float) -> None:
        self._state.show_text(tr("Estimating… {part:.0f} %").format(part=100 * part))

    def refuse(self, why: str) -> None:
        self._clear()
        self._state.show_text(f"\N{WARNING SIGN} {why}")

    def show_target(self, session: "Session") -> None:
        scene = self._scene = session.scene
        half_u, half_v = scene.receiver.half_extent
        self._aspect = half_u / half_v
        self._wanted.show_target(as_viewed(scene, session.target), self._aspect)
        self._side.setText(capitalised(tr(side_in_words(scene, viewed_from(scene)))))

    def show_prospect(self, found: "Prospect") -> None:
        self._clear()
        if found.picture is None:
            self._state.show_text(tr("Computing the estimate…"))
        elif self._scene is not None:
            self._state.show_text("")
            self._at_best.show_target(as_viewed(self._scene, found.picture), self._aspect)
        for row, figure in enumerate(found.figures):
            self._add(row, figure)

    def _add(self, row: int, figure: "Figure") -> None:
        name = QLabel(tr(figure.name))
        mark = "\N{WARNING SIGN} " if figure.warns else ""
        sentence = capitalised(tr(figure.meaning))
        meaning = WrappedLabel(f"<b>{mark}{tr(figure.value)}</b><br>{sentence}")
        self._figures.addWidget(name, row, 0, Qt.AlignmentFlag.AlignTop)
        self._figures.addWidget(meaning, row, 1)
        self._labels += [name, meaning]

    def _clear(self) -> None:
        for label in self._labels:
            self._figures.removeWidget(label)
            label.hide()
            label.deleteLater()
        self._labels.clear()
