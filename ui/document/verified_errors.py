"""What checks say of the lenses of kept runs."""

import weakref
from dataclasses import replace
from typing import TYPE_CHECKING

from workbench.design.session import KeptRun, Session, VerifiedError
from workbench.design.snapshot import Result

if TYPE_CHECKING:
    from workbench.analysis.validation_figures import Validation


class VerifiedErrors:
    """Errors of lenses, as long as these live.

    A check is no edit: it makes no step that could be undone, and no design unsaved. So what it
    says stands beside the sessions until one is written.
    """

    def __init__(self) -> None:
        # By id of the result, which may be gone by now.
        self._all: dict[int, tuple[weakref.ref[Result], VerifiedError]] = {}

    def note(self, lens: Result, found: "Validation") -> None:
        """Keep what a check says of a lens."""
        lens_error = found.verified
        error = VerifiedError(
            lens_error.relative_l2_corrected, lens_error.relative_l2_corrected_interval
        )
        self._all[id(lens)] = weakref.ref(lens), error

    def of(self, run: KeptRun) -> VerifiedError | None:
        """The error of a run's lens, by the latest check or by its file."""
        lens, error = self._all.get(id(run.result), (None, None))
        return error if lens is not None and lens() is run.result else run.verified

    def complete(self, session: Session) -> Session:
        """The session with the errors of its kept runs, for a file."""
        runs = tuple(replace(run, verified=self.of(run)) for run in session.runs)
        return replace(session, runs=runs)
