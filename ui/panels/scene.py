"""Panels of the whole scene, of the source, and of the run with its stages."""

from collections.abc import Set
from pathlib import Path
from typing import Any

from PySide6.QtWidgets import QInputDialog, QLabel

from ui.panels.edits import Edit
from ui.panels.fields import Changes, ChoiceRow, Row, described
from ui.panels.panel import ListedPanel, Panel
from ui.panels.rows import Rows, value_row
from ui.words import in_sentence, later, tr
from workbench.design.net import memory_bytes, parameter_count
from workbench.levels import Level
from workbench.process import as_bytes
from workbench.scene import (
    FieldDescription,
    Kinds,
    MeasuredSource,
    PhotometricSource,
    RayFileSource,
    Scene,
    Stage,
)
from workbench.scene.making.milling import Milling
from workbench.scene.making.polishing import Polishing
from workbench.scene.making.presets import PRESETS
from workbench.scene.making.process import Process
from workbench.scene.part import title_of

_PROCESSES: tuple[type[Process], ...] = (Milling, Polishing)


class ScenePanel(Panel):
    """Bound to what concerns the whole scene."""

    def __init__(self) -> None:
        rows = Rows(lambda: self.session.scene, {"unit": lambda *of: [_UnitRow(*of)]})
        fields = [field for field in Scene.fields() if field.tip and not field.parts]
        super().__init__(
            tr("Scene"), [row for field in fields for row in rows.of_field(field, field.name)]
        )


class _UnitRow(ChoiceRow):
    def _emit_edit(self, path: str, changes: Changes, drag: str = "") -> None:
        # A step of its own: from unit to unit, rounding adds up, and the scene would be another.
        unit = self.chooser.currentData()
        self.edited.emit(Edit(path, tr("change of unit"), {}, alone=True, unit=unit))


_KINDS: tuple[type[MeasuredSource], ...] = (PhotometricSource, RayFileSource)
_ENDINGS = tuple(ending for kind in _KINDS for ending in kind.endings)
_NAMED = Kinds("kind")


def light_files() -> str:
    """File filter of light files."""
    endings = " ".join(f"*{ending}" for ending in _ENDINGS)
    return tr("Files of light ({endings});;All files (*)").format(endings=endings)


def is_light_file(path: Path) -> bool:
    """Whether a file is one of light, by its name."""
    return path.suffix.lower() in _ENDINGS


def of_light_file(path: Path, scene: Scene) -> dict[str, object]:
    """Return plain data of a source of a light file, whose ending gives the kind."""
    kind = next((k for k in _KINDS if path.suffix.lower() in k.endings), _KINDS[0])
    source: dict[str, Any] = {"kind": _NAMED.name_of(kind), **kind.defaults_for(scene)}
    if scene.source.kind == source["kind"]:
        source = scene.source.model_dump(mode="json")
    return source | {"file": str(path.absolute())}


def parametrisation_rows(field: FieldDescription, path: str) -> list[Row]:
    """Return the row of how heights follow from parameters, and the number of these."""
    return [value_row(field, path), SizeRow()]


class SizeRow(Row):
    """Number of parameters, and their memory."""

    def __init__(self) -> None:
        tip = tr(
            "Number of optimised parameters, and their memory with gradient and optimiser state. "
            "A network that does not fit into memory is refused at the start."
        )
        super().__init__(described(tr("Parameters"), tip, str, Level.EXPERT), "run.parameters")
        self.text = QLabel()
        self._add(self.text)

    def show_scene(self, scene: Any, pending: Set[str]) -> None:
        self.text.setText(f"{parameter_count(scene):,} ({as_bytes(memory_bytes(scene))})")

    def _is_there(self, scene: Any) -> bool:
        return True


def _iterations(count: int) -> str:
    return tr("1 iteration") if count == 1 else tr("{count} iterations").format(count=count)


class StagesPanel(ListedPanel[Stage]):
    """Bound to ``scene.run.stages``."""

    _CALLED, _NAMED = later("stage"), later("Stage {number}")
    _NONE = later("None: the run has only the scene itself.")

    def __init__(self) -> None:
        tip = tr(
            "Stages that a run completes before the scene itself; each continues from the lens of "
            "the previous one. Example: a point source before an extended one, or a coarse net "
            "before a fine one."
        )
        super().__init__(
            described(tr("Stages"), tip, str, Level.EXPERT),
            {tr("Add"): tr("Add a stage behind the others")},
            "run.stages",
        )

    def remark(self, scene: Scene) -> str:
        left = _iterations(self._iterations_left)
        return tr("Then the scene itself: {iterations}.").format(iterations=left)

    @property
    def _iterations_left(self) -> int:
        run = self.session.scene.run
        return run.iterations - sum(stage.iterations for stage in run.stages)

    def new(self, which: int) -> Stage:
        return Stage(iterations=max(1, self._iterations_left // 2))

    def summary(self, part: Stage) -> str:
        parts = [_iterations(part.iterations)]
        if part.method is not None:
            (method,) = (field for field in Stage.fields() if field.name == "method")
            parts.append(in_sentence(tr(dict(method.choices)[part.method])))
        if part.control_points is not None:
            n_u, n_v = part.control_points
            parts.append(tr("net of {n_u} × {n_v}").format(n_u=n_u, n_v=n_v))
        if part.source is not None:
            parts.append(in_sentence(tr(title_of(type(part.source)))))
        if part.filter is not None:
            kind = in_sentence(tr(title_of(type(part.filter))))
            parts.append(tr("{kind} filter").format(kind=kind))
        return ", ".join(parts)

    def rows_of(self, number: int) -> list[Row]:
        path = f"run.stages[{number}]"
        rows = Rows(
            lambda: self.session.scene.stage_scenes()[number],
            {"method": self._method_rows},
            path,
        )
        return rows.of_part(Stage, path)

    def _method_rows(self, field: FieldDescription, path: str) -> list[Row]:
        rate = f"{path.rpartition('.')[0]}.learning_rate"

        def changes(choice: str) -> Changes:
            made: Changes = {path: choice or None}
            if (choice or self.session.scene.run.method) == "auto":
                made[rate] = None
            return made

        return [ChoiceRow(field, path, changes=changes)]


class ProcessesPanel(ListedPanel[Process]):
    """Bound to ``scene.processes``."""

    _CALLED, _NAMED = later("process"), later("Process {number}")
    _NONE, _KIND = later("None: elements are as designed."), later("Process")

    def __init__(self, field: FieldDescription) -> None:
        super().__init__(
            field,
            {
                tr(title_of(kind)): tr("Add {process} behind the others").format(
                    process=in_sentence(tr(title_of(kind)))
                )
                for kind in _PROCESSES
            }
            | {tr("Preset…"): tr("Choose a process with usual values, whose source is stated")},
        )

    def new(self, which: int) -> Process | None:
        if which == len(_PROCESSES):
            return self._preset()
        kind = _PROCESSES[which]
        return kind.model_validate(kind.defaults_for(self.session.scene))

    def _preset(self) -> Process | None:
        presets = {f"{tr(each.title)} ({tr(each.source)})": each for each in PRESETS.values()}
        chosen, accepted = QInputDialog.getItem(
            self, tr("Preset"), tr("Process and source"), [*presets], editable=False
        )
        return presets[chosen].in_unit(self.session.scene.unit) if accepted else None

    def summary(self, part: Process) -> str:
        return tr(title_of(type(part)))
