"""Kept runs and checks of runs: between the document, the runs that end, and the table."""

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from ui.document.document import Document
from ui.document.frame import Frame, shows
from ui.run.checks import CheckedLens, RunCheck, verified_error
from ui.run.comparison import RunComparison
from ui.run.control import RunControl
from ui.run.kept_runs import called, renamed, restored, without
from ui.run.table import RunTable
from ui.words import tr
from workbench.analysis.validation_figures import Validation
from workbench.design.session import VerifiedError
from workbench.errors import Refused
from workbench.files.session import KeptRun, Session
from workbench.pictures.loss import LossCourse


class Runs(QObject):
    """The kept runs: table, comparison, restoring, renaming and deleting."""

    compared = Signal(object)  # list of LossCourse
    checked = Signal()
    refused = Signal(str)

    def __init__(self, document: Document, control: RunControl, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._control = document, control
        self._drawn: list[KeptRun] = []
        self.comparison: RunComparison | None = None  # once it is asked for
        self.table = table = RunTable(self._verified_error)
        self.check = RunCheck(document, control, self)
        self.check.checked.connect(self.note_check)
        table.marks_changed.connect(self._plot_marked)
        table.renamed.connect(self._rename)
        table.restore_asked.connect(self.restore)
        table.delete_asked.connect(self.delete)
        table.compare_asked.connect(self.compare)
        document.session_changed.connect(self.show)
        control.runner.state_changed.connect(self._follow)
        self.show()

    def slots(self) -> dict[str, Callable[[], object]]:
        return {
            "restore_run": self.restore,
            "delete_run": self.delete,
            "compare_runs": self.compare,
        }

    def note_check(self, lens: CheckedLens, found: Validation) -> None:
        if found.contradiction:
            return
        session = self._document.session
        for run in session.runs:
            if _is_lens_of(run, lens):
                self._document.verified.note(run.result, found)
        if session.result is not None and _is_lens_of(session, lens):
            self._document.verified.note(session.result, found)
        self.table.show_verified()
        self.checked.emit()
        if self.comparison is not None:
            self.comparison.show_figures()

    def error_of(self, frame: Frame) -> VerifiedError | None:
        """Return the verified error of a shown lens; None during a run, or without a check."""
        session, result = self._document.session, self._document.session.result
        if self._control.busy or result is None or not shows(frame, session):
            return None
        noted, run = self._document.verified.of_lens(result), self._current
        return noted or (None if run is None else self._document.verified.of(run))

    def compare(self) -> None:
        """Show the two selected runs beside each other."""
        runs = self.table.chosen
        if len(runs) != 2:
            self.refused.emit(tr("Select two runs in View > Runs first (Ctrl+click)."))
            return
        if self.comparison is None:
            self.comparison = RunComparison(self._verified_error, self.table.window())
        self.comparison.show_pair((runs[0], runs[1]))
        self.comparison.show()
        self.comparison.raise_()

    def restore(self) -> None:
        """Return to task and lens of the selected run."""
        runs, session = self.table.chosen, self._document.session
        if not runs:
            self.refused.emit(tr("Select a run in View > Runs first."))
        elif len(runs) == 1:
            text = tr("return to {name}").format(name=called(runs[0]))
            self._document.change(restored(session, runs[0]), text)

    def delete(self) -> None:
        """Delete the selected runs."""
        runs = self.table.chosen
        if not runs:
            self.refused.emit(tr("Select runs in View > Runs first."))
            return
        text = (
            tr("delete {name}").format(name=called(runs[0]))
            if len(runs) == 1
            else tr("delete {count} runs").format(count=len(runs))
        )
        self._document.change(without(self._document.session, runs), text)

    def _verified_error(self, run: KeptRun) -> str:
        error = self._document.verified.of(run)
        return "" if error is None else verified_error(error)

    def show(self) -> None:
        session = self._document.session
        self.table.show_runs(session.runs, self._current)
        self._plot_marked()

    @property
    def _current(self) -> KeptRun | None:
        session = self._document.session
        if session.result is None:
            return None
        lens = CheckedLens(session, session.result.state.heights)
        return next((run for run in reversed(session.runs) if _is_lens_of(run, lens)), None)

    def _follow(self, state: str) -> None:
        self.table.allow(state == "idle")
        self._plot_marked()

    def _plot_marked(self) -> None:
        drawn = None if self._control.busy else self._current
        runs = [run for run in self.table.marked if run is not drawn]
        if runs != self._drawn:
            self._drawn = runs
            self.compared.emit([LossCourse(called(run), run.result.losses) for run in runs])

    def _rename(self, run: KeptRun, name: str) -> None:
        session = self._document.session
        try:
            self._document.change(renamed(session, run, name.strip()), tr("rename run"))
        except Refused as refused:
            self.refused.emit(
                tr("The run was not renamed; it is still {name}: {reason}").format(
                    name=called(run), reason=tr(refused.reason)
                )
            )
            self.show()


def _is_lens_of(run: KeptRun | Session, lens: CheckedLens) -> bool:
    return run.result is not None and lens.lights(run, run.result.state.heights)
