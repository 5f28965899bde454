"""Export of the lens, and reports, written in the background.

A separate process makes a report: VTK does not work in a second thread. It writes to a temporary
folder, and the complete report is moved to its place.
"""

import shutil
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from subprocess import DEVNULL, PIPE, Popen, TimeoutExpired
from tempfile import TemporaryDirectory

from PySide6.QtWidgets import QInputDialog, QMessageBox

from ui.background import Task
from ui.document.document import ENDING
from ui.files.dialogs import FileDialogs, FileWriter
from ui.run.control import NO_LENS, CurrentLens
from ui.words import capitalised, error_text, later, tr
from workbench.errors import Refused, RunFailed
from workbench.files.atomic import check_writable, replacing
from workbench.files.export.formats import GCODE, Format, format_of, formats_for
from workbench.files.export.options import MILLIMETRES, SCENE_UNIT, Chosen, mesh_unit_of
from workbench.files.session import Session
from workbench.progress import Interrupted
from workbench.report.content import HTML, PDF, check_ending
from workbench.scene import Scene


class LensWriter(FileWriter):
    """Writes the lens."""

    _KIND = ""  # of files, for dialogs

    def __init__(self, lens: CurrentLens, dialogs: FileDialogs) -> None:
        super().__init__(dialogs)
        self._lens = lens

    def _writable_lens(self) -> Session | None:
        """Return the design to write; report why there is none, or no time for it."""
        if self.background.busy:
            self._messages.note(tr("A file is still being written. Start the next one after it."))
            return None
        session = self._lens.session
        if session is None:
            self._messages.note(tr(NO_LENS))
            return None
        return self._document.verified.complete(session)

    def _ask_for_file(self, title: str, endings: Mapping[str, str]) -> Path | None:
        """Ask for a file; a name without an ending gets that of the chosen format."""
        title = title.format(lens=self._lens.text)
        return self._dialogs.to_save(self._KIND, title, self._document.name, endings)


class Exporter(LensWriter):
    """Asks for a file and writes it."""

    _WORK, _KIND = later("export"), "export"
    ask_options: Callable[[Session, Format], Chosen | None]  # set by the window

    def choose_and_export(self) -> None:
        """Ask for a file, and the element where there are several, and write it."""
        self._dialogs.chosen = ""
        endings = self._filters(MILLIMETRES) | self._filters(SCENE_UNIT)
        path = self._ask_for_file(tr("Export {lens}"), endings)
        if path is not None:
            in_scene_unit = self._dialogs.chosen in self._filters(SCENE_UNIT)
            self.export(path, mesh_unit=SCENE_UNIT if in_scene_unit else MILLIMETRES)

    def choose_and_cut(self, session: Session) -> None:
        """Ask how the face is cut, then for the file, and write it."""
        elements = self.ask_for_elements(session.scene, several=False)
        chosen = self._options_of(session, elements, GCODE)
        if chosen is not None:
            path = self._ask_for_file(tr("Cut {lens}"), {_filter(GCODE): GCODE.endings[0]})
            if path is not None:
                self._write(session, {path: elements[0]}, chosen)

    def export(self, path: Path, mesh_unit: str = MILLIMETRES) -> None:
        """Write a file; ask which element it holds, and for the cut of G-code."""
        session = self._writable_lens()
        if session is None:
            return
        try:
            found = format_of(path)
        except Refused as refused:
            self._messages.warn(error_text(refused))
            return
        elements = [session.scene.optic.name]
        if found.of_element:
            elements = self.ask_for_elements(session.scene, several=found is not GCODE)
        chosen = self._options_of(session, elements, found)
        several = len(elements) > 1
        files = {_named(path, found, each) if several else path: each for each in elements}
        if chosen is not None and self._may_replace([each for each in files if each != path]):
            self._write(session, files, chosen, mesh_unit)

    def ask_for_elements(self, scene: Scene, several: bool = True) -> list[str]:
        """Ask for one designed element or for all where there are several; none if cancelled."""
        names = [each.name for each in scene.optics]
        if len(names) == 1:
            return names
        every = tr("all, one file each")
        choices = [*names, every] if several else names
        chosen, accepted = QInputDialog.getItem(
            self._dialogs.window, tr("Export"), tr("Designed element"), choices, 0, editable=False
        )
        if not accepted:
            return []
        return names if chosen == every else [chosen]

    def _may_replace(self, files: Sequence[Path]) -> bool:
        there = ", ".join(path.name for path in files if path.exists())
        buttons = QMessageBox.StandardButton
        return not there or buttons.Yes == QMessageBox.question(
            self._dialogs.window, tr("Export"), tr("Replace {files}?").format(files=there)
        )

    def _options_of(
        self, session: Session, elements: Sequence[str], found: Format
    ) -> Chosen | None:
        if not elements:
            return None
        scene = session.scene.focused_on(elements[0])
        return self.ask_options(replace(session, scene=scene), found)

    def _write(
        self,
        session: Session,
        files: Mapping[Path, str],
        chosen: Chosen,
        mesh_unit: str = MILLIMETRES,
    ) -> None:
        title = tr("Export {name}").format(name=", ".join(path.name for path in files))
        work = partial(_write, session, files, chosen, mesh_unit, self._lens.text)
        self.background.begin(work, title=title)

    def _filters(self, mesh_unit: str) -> dict[str, str]:
        session = self._document.session
        unit = mesh_unit_of(mesh_unit, session.scene.unit)
        return {
            _filter(each, unit if each.takes_unit else ""): each.endings[0]
            for each in formats_for(session.scene.optics)
            if mesh_unit == MILLIMETRES or (each.takes_unit and unit != MILLIMETRES)
        }


def _write(
    session: Session,
    files: Mapping[Path, str],
    chosen: Chosen,
    mesh_unit: str,
    lens: str,
    task: Task,
) -> None:
    # Late: torch comes with it, and the window shows before that.
    from workbench.files.export.write import export

    def report(done: float) -> None:
        if task.stopped:
            raise Interrupted
        if task.part is None or done >= task.part + _STEP:
            task.report(done)

    try:
        found = [
            written.sentence
            for path, element in files.items()
            for written in export(
                session,
                [path],
                options=chosen.options,
                mesh_unit=mesh_unit,
                plan=chosen.plan,
                progress=report,
                element=element,
            )
        ]
    except Interrupted:
        task.outcome = tr("No file was written.")
    else:
        task.outcome, task.path = "; ".join([*found, lens]), next(iter(files))


def _named(path: Path, found: Format, element: str) -> Path:
    """The file of one of several elements: its name before the ending."""
    ending = next(each for each in found.endings if path.name.lower().endswith(each))
    start = len(path.name) - len(ending)
    return path.with_name(f"{path.name[:start]}.{element}{path.name[start:]}")


def _filter(found: Format, unit: str = "") -> str:
    patterns = " ".join(f"*{ending}" for ending in found.endings)
    name = capitalised(found.name)
    named = tr("{format} in {unit}").format(format=name, unit=unit) if unit else name
    return f"{named} ({patterns})"


_STEP = 0.01  # of the work, between two reports
_COMMAND = (sys.executable, "-P", "-m", "workbench", "report")
_PREFIX = "freeform: "  # before a reason
_OFTEN = 0.1  # seconds after which it may be cancelled
_REPORT_FILTERS = later({"Web page (*.html)": HTML[0], "Document (*.pdf)": PDF[0]})


class Reporter(LensWriter):
    """Asks for a file and writes a report, by a process."""

    _WORK, _KIND = later("report"), "report"

    def choose_and_report(self) -> None:
        """Ask for a file and write it; the ending of its name selects the format."""
        endings = {tr(text): ending for text, ending in _REPORT_FILTERS.items()}
        path = self._ask_for_file(tr("Report {lens}"), endings)
        if path is not None:
            self.report(path)

    def report(self, path: Path) -> None:
        session = self._writable_lens()
        if session is None:
            return
        name = self._document.suggested_path.stem
        work = partial(_write_report, session, name, path, self._lens.text)
        self.background.begin(work, title=tr("Report {name}").format(name=path.name))


def _write_report(session: Session, name: str, path: Path, lens_text: str, task: Task) -> None:
    # Late: torch comes with it, and the window shows before that.
    from workbench.files.session import write_session

    check_ending(path)
    check_writable(path)
    with TemporaryDirectory() as folder:
        lens, report = Path(folder, f"{name}{ENDING}"), Path(folder, f"report{path.suffix}")
        write_session(session, lens)
        if not _run_command([*_COMMAND, str(lens), str(report)], task):
            task.outcome = tr("No file was written.")
            return
        with replacing(path) as file, report.open("rb") as source:
            shutil.copyfileobj(source, file)
    task.outcome, task.path = f"{path}: {tr('report')}; {lens_text}", path


def _run_command(command: list[str], task: Task) -> bool:
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
        *_, last = ["it ended without a message", *output.splitlines()]
        raise RunFailed(f"No report: {last.removeprefix(_PREFIX)}")
    return True
