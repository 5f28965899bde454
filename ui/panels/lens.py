"""The lens: what its material and its range of heights need beside what their fields say."""

from dataclasses import replace

import numpy as np

from ui.panels.edits import value_at
from ui.panels.fields import Changes, ChoiceRow, NumberRow, Row
from ui.panels.panel import PartPanel
from ui.panels.rows import Make, value_row
from ui.words import tr
from workbench.design.limits import bounded
from workbench.geometry.surface import ControlNet
from workbench.materials import CATALOGUE
from workbench.scene import FieldDescription, Scene

_OWN_INDEX = "index"
_AUTOMATIC, _OWN_RANGE = "automatic", "own"
_FACE_RANGES = "lens.height_range", "mirror.height_range"
_HELIUM_D_UM = 0.5876  # the line at which catalogues quote an index


class LensPanel(PartPanel):
    """Bound to ``scene.lens`` or ``scene.mirror``."""

    def own_rows(self) -> dict[str, Make]:
        """A material is a name or a number; a range may follow from the task."""
        return {
            "refractive_index": self._material_rows,
            "wavelength_um": _wavelength_rows,
            "height_range": self._range_rows,
        }

    def _material_rows(self, field: FieldDescription, path: str) -> list[Row]:
        material = ChoiceRow(
            path,
            tr(field.title),
            tr(field.tip),
            [(_OWN_INDEX, tr("Custom index")), *((name, tr(name)) for name in CATALOGUE)],
            read=_material,
            changes=self._change_material,
        )
        index = NumberRow(
            path, tr("Index"), tr("Refractive index of the lens; the air around it has 1.")
        )
        index.only_if(lambda scene: _material(scene) == _OWN_INDEX)
        return [material, index]

    def _range_rows(self, field: FieldDescription, path: str) -> list[Row]:
        choice = ChoiceRow(
            path,
            tr(field.title),
            tr(field.tip),
            [(_AUTOMATIC, tr("Automatic")), (_OWN_RANGE, tr("Own limits"))],
            read=lambda scene: _range(scene, path),
            changes=lambda choice: self._change_range(choice, path),
        )
        limits = NumberRow(
            path,
            tr("From the base") if path in _FACE_RANGES else tr("From the entrance"),
            tr(
                "How far a control point may move from the base, down and up. A wider "
                "range bends light further."
            ),
            field.measure,
            field.between,
        )
        return [choice, limits]

    def _change_material(self, choice: str) -> Changes:
        scene = self.session.scene
        if choice == _OWN_INDEX:
            index = round(scene.optic.index, 6)
            return {"lens.refractive_index": index, "lens.wavelength_um": None}
        wavelength = (scene.lens and scene.lens.wavelength_um) or _HELIUM_D_UM
        return {"lens.refractive_index": choice, "lens.wavelength_um": wavelength}

    def _change_range(self, choice: str, path: str) -> Changes | None:
        optic, heights = self.session.scene.optic, self.session.heights
        if choice == _range(self.session.scene, path):
            return None
        if choice == _AUTOMATIC:
            return {path: None}
        if path not in _FACE_RANGES:
            return {path: list(bounded(self.session.scene).entrance_offsets)}
        half = 0.3 * max(optic.half_width)
        if heights is not None:
            x, y = ControlNet.of(optic).positions
            off = np.abs(heights[optic.designed_face] - optic.base.height_at(x[:, None], y[None, :]))
            half = max(half, 1.5 * float(off.max()))
        half = float(f"{half:.2g}")
        return {path: [-half, half]}


def _wavelength_rows(field: FieldDescription, path: str) -> list[Row]:
    """Asked for with a catalogue material only."""
    row = value_row(replace(field, optional=False), path)
    row.only_if(lambda scene: _material(scene) != _OWN_INDEX)
    return [row]


def _range(scene: Scene, path: str) -> str:
    return _AUTOMATIC if value_at(scene, path) is None else _OWN_RANGE


def _material(scene: Scene) -> str:
    index = scene.lens and scene.lens.refractive_index
    return index if isinstance(index, str) else _OWN_INDEX
