"""Panels of the whole scene and of the source."""

from pathlib import Path
from typing import Any

from PySide6.QtCore import Signal

from ui.panels.edits import Edit
from ui.panels.fields import Changes, ChoiceRow, Row, TextRow
from ui.panels.panel import Panel, PartPanel
from ui.panels.rows import KindRow, Make, Rows, file_rows
from ui.words import tr
from workbench.scene import (
    FieldDescription,
    Kinds,
    MeasuredSource,
    PhotometricSource,
    RayFileSource,
    Scene,
)


class ScenePanel(Panel):
    """Bound to what concerns the whole scene."""

    def __init__(self) -> None:
        rows = Rows(lambda: self.session.scene, {"unit": _unit_rows})
        fields = [field for field in Scene.fields() if field.tip and not field.parts]
        super().__init__(
            tr("Scene"), [row for field in fields for row in rows.of_field(field, field.name)]
        )


def _unit_rows(field: FieldDescription, path: str) -> list[Row]:
    units = [(unit, unit) for unit, _ in field.choices]  # in small letters
    return [_UnitRow(field, path, units)]


class _UnitRow(ChoiceRow):
    def _emit_edit(self, path: str, changes: Changes) -> None:
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


class SourcePanel(PartPanel):
    """Bound to ``scene.source``."""

    file_asked = Signal()

    def __init__(self, field: FieldDescription) -> None:
        super().__init__(field)
        for row in self.rows:
            if isinstance(row, KindRow | TextRow):
                row.asked.connect(lambda *_: self.file_asked.emit())

    def own_rows(self) -> dict[str, Make]:
        return {"file": file_rows}

    def choose_file(self, path: Path) -> None:
        """Use a light file as source; its ending gives the kind."""
        kind = next((k for k in _KINDS if path.suffix.lower() in k.endings), _KINDS[0])
        file = {"file": str(path.absolute())}
        scene = self.session.scene
        source: dict[str, Any] = {"kind": _NAMED.name_of(kind), **kind.defaults_for(scene)}
        if scene.source.kind == source["kind"]:
            source = scene.source.model_dump(mode="json")
        edit = Edit(
            "source.file", tr("change of file of light"), {"source": source | file}, waits=False
        )
        self.edited.emit(edit)
