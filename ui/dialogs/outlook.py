"""What can be expected of a job, found in a thread: figures, and the picture as at best."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from ui.background import Background, Task, sentence_of
from ui.panels.editors import Wrapped
from ui.panels.images import Thumbnail
from ui.widgets.labels import WrappedLabel
from ui.words import begun, tr
from workbench.scene.viewing import as_viewed, side_in_words, viewed_from

if TYPE_CHECKING:
    from workbench.files.session import Session
    from workbench.jobs import Job
    from workbench.jobs.prospect import Figure, Prospect
    from workbench.scene import Scene

_HIGH = 160  # logical pixels of a picture: two of them are compared


class ProspectFinder(QObject):
    """Draws the target of the latest job and finds what can be expected of it."""

    ready = Signal(object)  # Session
    found = Signal(object)  # Prospect
    progressed = Signal(float)
    failed = Signal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._background = Background("outlook", self)
        self._background.progressed.connect(self._pass_on)
        self._background.done.connect(self._tell)
        self._background.failed.connect(
            lambda _, error: self.failed.emit(sentence_of(error, tr("outlook")))
        )

    def look(self, job: "Job") -> None:
        """Leave what was looked at, and look at this one."""
        self._background.begin(partial(_find, job))

    def leave(self) -> None:
        """Look at nothing any more."""
        self._background.cancel()

    def close(self) -> None:
        """End the search and wait for its thread; safe to call twice."""
        self._background.close()

    def _pass_on(self, _: object, reported: "Session | Prospect | float") -> None:
        from workbench.jobs.prospect import Prospect  # late: takes long to import

        if isinstance(reported, float):
            self.progressed.emit(reported)
        elif isinstance(reported, Prospect):
            self.found.emit(reported)
        else:
            self.ready.emit(reported)

    def _tell(self, _: object, found: "Prospect | None") -> None:
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


class Outlook(QWidget):
    """Shows what was found."""

    def __init__(self) -> None:
        super().__init__()
        self._aspect = 1.0
        self._scene: Scene | None = None  # of the target on show
        self._labels: list[QLabel] = []
        self._wanted, self._at_best = Thumbnail(_HIGH), Thumbnail(_HIGH)
        self._at_best.setAccessibleName(tr("Picture at best"))
        self._at_best.setToolTip(tr("Blurred by the size of the light, as any lens has to"))
        self._side = QLabel(alignment=Qt.AlignmentFlag.AlignHCenter)
        self._state = Wrapped()
        self._figures = QGridLayout()
        self._figures.setHorizontalSpacing(12)
        self._figures.setColumnStretch(1, 1)
        pictures = QHBoxLayout()
        for title, picture in ((tr("Wanted"), self._wanted), (tr("At best"), self._at_best)):
            column = QVBoxLayout()
            column.addWidget(QLabel(title, alignment=Qt.AlignmentFlag.AlignHCenter))
            column.addWidget(picture)
            pictures.addLayout(column)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addLayout(pictures)
        whole.addWidget(self._side)
        whole.addWidget(self._state)
        whole.addLayout(self._figures)

    @property
    def text(self) -> str:
        """All that is said."""
        labels = self._side, self._state, *self._labels
        return "\n".join(label.text() for label in labels)

    def wait(self) -> None:
        """Say that figures are being found, and mark those that are of the answers before."""
        self.outdate()
        computing = tr("Computing what can be expected…")
        self._state.say(f"{computing} {self._state.text()}".strip())

    def outdate(self) -> None:
        """Mark all figures as those of the answers before."""
        for label in self._labels:
            label.setEnabled(False)
        self._state.say(tr("The figures are of the answers before.") if self._labels else "")
        self._at_best.clear()

    def show_progress(self, part: float) -> None:
        """Say how far the estimate is."""
        self._state.say(tr("Estimating… {part:.0f} %").format(part=100 * part))

    def refuse(self, why: str) -> None:
        """Say why there is nothing to be expected."""
        self._clear()
        self._state.say(f"\N{WARNING SIGN} {why}")

    def show_target(self, session: "Session") -> None:
        """Show the picture that is wanted, and say from where it reads so."""
        scene = self._scene = session.scene
        half_u, half_v = scene.receiver.half_extent
        self._aspect = half_u / half_v
        self._wanted.show_target(as_viewed(scene, session.target), self._aspect)
        self._side.setText(begun(tr(side_in_words(scene, viewed_from(scene)))))

    def show_prospect(self, found: "Prospect") -> None:
        """Show figures, and the picture at best."""
        self._clear()
        if found.picture is None:
            self._state.say(tr("Computing what can be expected…"))
        elif self._scene is not None:
            self._state.say("")
            self._at_best.show_target(as_viewed(self._scene, found.picture), self._aspect)
        for row, figure in enumerate(found.figures):
            self._add(row, figure)

    def _add(self, row: int, figure: "Figure") -> None:
        name = QLabel(tr(figure.name))
        mark = "\N{WARNING SIGN} " if figure.warns else ""
        sentence = begun(tr(figure.meaning))
        said = WrappedLabel(f"<b>{mark}{tr(figure.value)}</b><br>{sentence}")
        self._figures.addWidget(name, row, 0, Qt.AlignmentFlag.AlignTop)
        self._figures.addWidget(said, row, 1)
        self._labels += [name, said]

    def _clear(self) -> None:
        for label in self._labels:
            self._figures.removeWidget(label)
            label.hide()
            label.deleteLater()
        self._labels.clear()
