"""Between document and runner: what is designed, when it is shown, where the result goes."""

from PySide6.QtCore import QObject, QTimer, Signal

from ui.document import Document
from ui.runner import Runner
from workbench.design.snapshot import Result

_PREVIEW_MS = 200  # a person who types is not done yet


class RunControl(QObject):
    """Runs designs of the document and previews it in between.

    Parameters
    ----------
    document : Document
        Its session is run; it gets the result as one step that can be undone.
    """

    ended = Signal()

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self.runner = Runner(self)
        self.runner.finished.connect(self._finish)
        self._preview = QTimer(self, singleShot=True, interval=_PREVIEW_MS)
        self._preview.timeout.connect(self._show_preview)
        document.session_changed.connect(self._preview.start)
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

    def toggle_pause(self) -> None:
        """Hold the run, or let it go on."""
        if self.runner.state == "paused":
            self.runner.resume()
        else:
            self.runner.pause()

    def close(self) -> None:
        """End the run and its thread; safe to call twice."""
        self._preview.stop()
        self.runner.shutdown()

    def _start(self, continue_run: bool) -> None:
        self._preview.stop()
        self.runner.start(self._document.session, continue_run)

    def _show_preview(self) -> None:
        if not self.busy:
            self.runner.preview(self._document.session)

    def _finish(self, result: Result | None) -> None:
        if result is not None:
            self._document.set_result(result, "design run")
        self.ended.emit()
