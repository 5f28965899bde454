"""Between document and runner: what is designed, when it is shown, where the result goes."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from ui.document.document import Document
from ui.run.kept import called, with_run
from ui.run.runner import Runner
from ui.shown.frame import iterations_before
from ui.shown.frame_history import FrameHistory
from ui.words import tr
from workbench.design.snapshot import Result

if TYPE_CHECKING:
    from ui.shown.frame import Frame
    from workbench.files.session import Session

_PREVIEW_MS = 200  # a person who types is not done yet


class RunControl(QObject):
    """Runs designs of the document and previews it in between.

    Parameters
    ----------
    document : Document
        Its session is run; it gets the result, and keeps the run, as one step that can be undone.

    Attributes
    ----------
    followed : bool
        Whether lenses for the edits of the document come from elsewhere, so that no preview of it
        is needed.
    ended : Signal()
        A run has ended, and the document has its result.
    gave_way : Signal(str)
        Name of a kept run that had to make room for a later one.
    """

    ended = Signal()
    gave_way = Signal(str)

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self.followed = False
        self.runner = Runner(self)
        self.history = FrameHistory(self)
        self.runner.frame_ready.connect(self._keep)
        self.runner.finished.connect(self._finish)
        self._preview = QTimer(self, singleShot=True, interval=_PREVIEW_MS)
        self._preview.timeout.connect(self._show_preview)
        document.session_changed.connect(self._preview.start)
        document.session_changed.connect(self._follow)
        self._preview.start()

    @property
    def busy(self) -> bool:
        """Whether a run has begun and not ended."""
        return self.runner.state != "idle"

    def start(self) -> None:
        """Design the lens from its start."""
        self._start(continue_run=False)

    def go_on(self) -> None:
        """Go on from the lens as it is."""
        self._start(continue_run=True)

    def go_on_from(self, frame: "Frame") -> None:
        """Go on from the lens as it was at some moment of the run."""
        self.history.branch(frame)
        self._document.set_result(
            frame.result,
            tr("return to iteration {number}").format(number=iterations_before(frame)),
        )
        self.go_on()

    def toggle_pause(self) -> None:
        """Hold the run, or let it go on."""
        if self.runner.state == "paused":
            self.runner.resume()
        else:
            self.runner.pause()

    def show(self, frame: "Frame") -> None:
        """Show a lens in the making, in place of a preview of the document's."""
        self._preview.stop()
        self.runner.show(frame)

    def preview(self) -> None:
        """Show the document's lens again."""
        self._preview.start()

    def close(self) -> None:
        """End the run and its thread; safe to call twice."""
        self._preview.stop()
        self.runner.shutdown()

    def _start(self, continue_run: bool) -> None:
        self._preview.stop()
        self.runner.start(self._document.session, continue_run)

    def _show_preview(self) -> None:
        if not (self.busy or self.followed):
            self.runner.preview(self._document.session)

    def _keep(self, frame: "Frame") -> None:
        if self.busy:  # a preview is no moment of a run
            self.history.add(frame)

    def _follow(self, session: "Session") -> None:
        """The course on show is that of the lens on show."""
        if not self.busy:
            self.history.show(session)

    def _finish(self, result: Result | None) -> None:
        if result is not None:
            self.history.keep(result)
            session, given_way = with_run(self._document.session, result)
            self._document.change(session, tr("design run"))
            for run in given_way:
                self.gave_way.emit(called(run))
        self.ended.emit()
