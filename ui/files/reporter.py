"""Takes all that is known of the lens to a report for those who do not have the program.

1. A process of its own makes it: its 3D picture needs VTK, which does not work in a second thread
   beside the window's.
2. It writes to a folder of its own. What it has written goes to its place whole, and a process
   that is killed leaves nothing there.
"""

import shutil
import sys
from functools import partial
from pathlib import Path
from subprocess import DEVNULL, PIPE, Popen, TimeoutExpired
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.document.document import ENDING, Document
from ui.files.dialogs import FileDialogs
from ui.run.lens_on_show import NO_LENS, LensOnShow
from ui.threads.background import Background, Task
from ui.threads.failure import sentence_of
from ui.widgets.message_bar import MessageBar
from ui.words import later, tr
from workbench.errors import RunFailed
from workbench.files.atomic import check_writable, replacing
from workbench.report.content import HTML, PDF, check_ending

if TYPE_CHECKING:
    from workbench.files.session import Session

_COMMAND = (sys.executable, "-P", "-m", "workbench", "report")
_SAYS = "freeform: "  # before a reason
_OFTEN = 0.1  # seconds after which it may be cancelled
_FILTERS = later({"Web page (*.html)": HTML[0], "Document (*.pdf)": PDF[0]})


class Reporter(QObject):
    """Asks for a file and has the report written there, one at a time."""

    def __init__(
        self,
        document: Document,
        lens: LensOnShow,
        messages: MessageBar,
        dialogs: FileDialogs,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._lens = document, lens
        self._messages, self._dialogs = messages, dialogs
        self._background = Background("report", self)
        self._background.done.connect(self._tell)
        self._background.failed.connect(
            lambda _, error: messages.warn(sentence_of(error, tr("report")))
        )

    def choose_and_report(self) -> None:
        """Ask for a file and write it; the ending of its name tells the format."""
        path = self.ask_for_name()
        if path is not None:
            self.report(path)

    def report(self, path: Path) -> None:
        """Write a report of the lens as it is now."""
        if self._background.busy:
            self._messages.note(
                tr("One report is still being written; ask for the next after it."),
                (tr("Cancel"), self.cancel),
            )
            return
        found = self._lens.session
        if found is None:
            self._messages.note(tr(NO_LENS))
            return
        document = self._document
        session = document.verified.complete(found)
        name = document.suggested_path.stem
        self._messages.note(
            tr("{file} is being written, with a check of {lens}…").format(
                file=path.name, lens=self._lens.text
            ),
            (tr("Cancel"), self.cancel),
            lasts=True,
        )
        self._background.begin(partial(_write, session, name, path))

    def ask_for_name(self) -> Path | None:
        """Ask for a file; a name without an ending gets that of the chosen format."""
        title, name = tr("Report {lens}").format(lens=self._lens.text), self._document.name
        return self._dialogs.to_save("report", title, name, {tr(k): e for k, e in _FILTERS.items()})

    def cancel(self) -> None:
        """Write none after all."""
        self._background.stop()

    def close(self) -> None:
        """Cancel the report under way. Safe to call twice."""
        self._background.close()

    def _tell(self, _: None, path: Path | None) -> None:
        self._messages.done(
            tr("No report is written.")
            if path is None
            else tr("{path} is written.").format(path=path)
        )


def _write(session: "Session", name: str, path: Path, task: Task) -> Path | None:
    """Write a report; None if it was cancelled."""
    # Late: torch comes with it, and the window shows before that.
    from workbench.files.session import write_session

    check_ending(path)
    check_writable(path)
    with TemporaryDirectory() as folder:
        lens, report = Path(folder, f"{name}{ENDING}"), Path(folder, f"report{path.suffix}")
        write_session(session, lens)
        if not _run([*_COMMAND, str(lens), str(report)], task):
            return None
        with replacing(path) as file, report.open("rb") as source:
            shutil.copyfileobj(source, file)
    return path


def _run(command: list[str], task: Task) -> bool:
    """Let a command do its work; False if it was cancelled.

    Raises
    ------
    RunFailed
        If it failed, with its last line.
    """
    with Popen(command, stdin=DEVNULL, stdout=DEVNULL, stderr=PIPE, encoding="utf-8") as process:
        while True:
            if task.stopped:
                process.kill()
                return False
            try:
                _, output = process.communicate(timeout=_OFTEN)
                break
            except TimeoutExpired:
                pass
    if process.returncode:
        *_, last = ["it ended without a word", *output.splitlines()]
        raise RunFailed(f"No report: {last.removeprefix(_SAYS)}")
    return True
