"""Log of runs: their stages, and what was chosen for their traces."""

from collections.abc import Callable

from PySide6.QtCore import QObject

from ui.document.document import Document
from ui.document.frame import Frame
from ui.run.control import RunControl
from ui.run.status import clock
from ui.words import later, tr
from workbench.design.snapshot import Snapshot
from workbench.powers import written

_TURNS = later(
    {
        ("running", "paused"): "Run paused",
        ("paused", "running"): "Run resumed",
        ("running", "stopping"): "Stop requested",
        ("paused", "stopping"): "Stop requested",
    }
)


class RunLog(QObject):
    """Logs the runs of a window: one entry for each change, not for each iteration."""

    def __init__(self, document: Document, control: RunControl, log: Callable[[str], None]) -> None:
        super().__init__(control)
        self._document, self._control, self._log = document, control, log
        self._state = "idle"
        self._last: Snapshot | None = None
        control.runner.state_changed.connect(self._follow)
        control.runner.frame_ready.connect(self._log_frame)
        control.ended.connect(self._end)
        control.displaced.connect(
            lambda name: log(tr("{name} was removed: memory limit of kept runs").format(name=name))
        )

    def _follow(self, state: str) -> None:
        before, self._state = self._state, state
        if (before, state) == ("idle", "running"):
            self._last = None
            run = self._document.session.scene.run
            self._log(
                tr("Run started: {name}, method {method}").format(
                    name=self._document.name, method=run.method
                )
            )
        elif (before, state) in _TURNS:
            at = (
                tr(" at iteration {iteration}").format(iteration=self._last.iteration)
                if self._last is not None
                else ""
            )
            self._log(tr(_TURNS[before, state]) + at)

    def _log_frame(self, frame: Frame) -> None:
        if not self._control.busy:  # a preview
            return
        shot, last = frame.snapshot, self._last
        self._last = shot
        if shot.stages > 1 and (last is None or last.stage != shot.stage):
            self._log(
                tr("Stage {stage} of {stages}, iteration {iteration}").format(
                    stage=shot.stage + 1, stages=shot.stages, iteration=shot.iteration
                )
            )
        new = [note for note in shot.notes if last is None or note not in last.notes]
        if new:
            self._log(tr("Trace: {notes}").format(notes="; ".join(map(tr, new))))

    def _end(self) -> None:
        if self._last is None:
            called = self._document.session.scene.optic.called
            self._log(tr("Run ended without a {optic}", optic=called))
            return
        shot, session = self._last, self._document.session
        result, place = session.result, tr(session.scene.receiver.place)
        why = f" ({tr(result.ended)})" if result is not None and result.ended else ""
        self._log(
            tr(
                "Run ended{why} after iteration {iteration} of {iterations}, {clock}: last loss "
                "{loss}, {efficiency:.1f} % {place}"
            ).format(
                why=why,
                iteration=shot.iteration,
                iterations=shot.iterations,
                clock=clock(shot.seconds),
                loss=written(shot.state.loss),
                efficiency=100 * shot.state.account.efficiency,
                place=place,
            )
        )
