"""Photographs of the light and measured surfaces, compared with the lens in the background."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from PySide6.QtCore import QObject, QSettings

from ui.background import Background, Task, Work
from ui.dialogs.corners import PhotographDialog
from ui.document.document import ENDING
from ui.files.dialogs import FileDialogs
from ui.manufacture.option_fields import OptionDialog, keep_options, kept_options
from ui.panels.images import image_files
from ui.words import later, tr
from workbench.analysis.inspection.options import InspectionOptions
from workbench.analysis.making.photograph_options import PhotographOptions
from workbench.errors import Refused
from workbench.measured.surfaces import ENDINGS
from workbench.targets.colour import TONES
from workbench.targets.image import read_picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from workbench.analysis.inspection.inspection import Inspection
    from workbench.arrays import Array
    from workbench.files.session import Session
    from workbench.report.content import Fact


class Comparison(NamedTuple):
    """What a comparison shows: a picture that is drawn in the window, and figures."""

    draw: "Callable[[Figure], None]"
    rows: "Sequence[Fact]"
    inspection: "Inspection | None" = None  # of parts, which can be corrected


class Measured(QObject):
    """Asks for photographs and measurements, compares them, and shows the results."""

    def __init__(self, dialogs: FileDialogs, settings: QSettings) -> None:
        super().__init__(dialogs)
        self._messages, self._dialogs, self._settings = dialogs.messages, dialogs, settings
        self.background = Background(later("comparison"), self, finish_first=True)
        self.background.done.connect(self._show)
        self.background.failed.connect(self._messages.warn)

    def choose_photograph(self, session: "Session") -> None:
        """Ask for a photograph and the corners of the receiver in it, and compare."""
        title = tr("Compare a photograph")
        path = self._dialogs.to_open("photograph", title, image_files())
        if path is not None:
            self.compare(session, path)

    def compare(self, session: "Session", path: Path) -> None:
        kept = kept_options(self._settings, session.scene.unit, PhotographOptions)
        try:
            light = read_picture(path, tone=TONES[kept.tone]).light
        except Refused as refused:
            self._messages.warn(tr(refused.reason))
            return
        dialog = PhotographDialog(light, kept, self._dialogs.window)
        if dialog.exec():
            options, corners = dialog.fields.options, tuple(dialog.view.corners)
            keep_options(self._settings, session.scene.unit, options)
            if options.tone != kept.tone:
                light = read_picture(path, tone=TONES[options.tone]).light
            work = partial(_compared, session, light, corners)
            self._begin(work, session, path)
        dialog.deleteLater()

    def choose_surfaces(self, session: "Session") -> None:
        """Ask for measurements of parts and their units, and compare them."""
        title = tr("Read measured surfaces")
        endings = " ".join(f"*{ending}" for ending in ENDINGS)
        filters = tr("Measured surfaces ({endings});;All files (*)").format(endings=endings)
        paths = self._dialogs.to_open_several("surface", title, filters)
        if paths:
            self.inspect(session, paths)

    def inspect(self, session: "Session", paths: Sequence[Path]) -> None:
        unit = session.scene.unit
        kept = kept_options(self._settings, unit, InspectionOptions)
        dialog = OptionDialog(unit, [kept], tr("Measured surfaces"), self._dialogs.window)
        if dialog.exec():
            keep_options(self._settings, unit, *dialog.options)
            options = kept_options(self._settings, unit, InspectionOptions)
            self._begin(partial(_inspected, session, paths, options), session, paths[0])
        dialog.deleteLater()

    def _begin(self, work: Work, session: "Session", path: Path) -> None:
        title = tr("Comparison with {file}").format(file=path.name)
        self.background.begin(work, session, title)

    def _show(self, session: "Session", found: Comparison | None) -> None:
        from ui.dialogs.comparison import ComparisonDialog  # late: it loads matplotlib

        if found is not None:  # else cancelled
            dialog = ComparisonDialog(found.draw, found.rows, self._dialogs.window)
            if found.inspection is not None:
                tip = tr("Write a design whose face makes good what repeats in the parts")
                correct = partial(self._correct, session, found.inspection)
                dialog.add_button(tr("Save &corrected part…"), tip, correct)
            dialog.show()

    def _correct(self, session: "Session", inspection: "Inspection") -> None:
        title, filters = tr("Save the corrected part"), {tr("Design (*.freeform)"): ENDING}
        path = self._dialogs.to_save("session", title, f"corrected{ENDING}", filters)
        if path is not None:
            work = partial(_corrected, session, inspection, path)
            self.background.begin(work, session, tr("Corrected part"))


def _compared(
    session: "Session", light: "Array", corners: "tuple[tuple[float, float], ...]", task: Task
) -> Comparison | None:
    # Late: what they stand on is slow to import.
    from workbench.analysis.making.photograph import comparing
    from workbench.design.session import result_of
    from workbench.pictures.part.photograph import draw_photograph
    from workbench.report.measured import photograph_rows

    scene, heights = session.scene, result_of(session).state.heights
    found = task.follow(comparing(scene, session.target, heights, light, corners), task.report)
    if found is None:
        return None
    return Comparison(
        partial(draw_photograph, found=found, scene=scene), photograph_rows(found, scene.unit)
    )


def _inspected(
    session: "Session", paths: Sequence[Path], options: InspectionOptions, task: Task
) -> Comparison | None:
    # Late, as above.
    from workbench.analysis.inspection.inspection import lighting
    from workbench.made import inspect
    from workbench.pictures.part.inspection import draw_inspection
    from workbench.report.measured import light_rows, part_rows, repeating_rows

    found = inspect(
        session,
        *paths,
        unit=options.unit,
        height_unit=options.z_unit,
        with_scale=options.scale,
        pictures=options.pictures,
    )
    lights = task.follow(lighting(session, found.lenses), task.report)
    if lights is None:
        return None
    rows = [*repeating_rows(found), *light_rows(found, lights)]
    for part in found.parts:
        rows += part_rows(part, found)
    draw = partial(draw_inspection, found=found, target=session.target, lights=lights)
    return Comparison(draw, rows, found)


def _corrected(session: "Session", inspection: "Inspection", path: Path, task: Task) -> None:
    from workbench.files.session import write_session
    from workbench.made import corrected

    write_session(corrected(session, inspection), path)
    task.outcome, task.path = tr("{file} is written.").format(file=path.name), path
