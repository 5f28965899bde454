"""The elements of a scene: a list of them, and the settings of the one that is chosen."""

from collections.abc import Sequence

import numpy as np

from ui.panels.edits import value_at
from ui.panels.element_list import ElementListRow, of_kind
from ui.panels.fields import Changes, ChoiceRow, NumberRow, Row
from ui.panels.listed import ListedPanel
from ui.panels.rows import Rows, value_row
from ui.words import begun, tr
from workbench.design.limits import bounded
from workbench.files.session import Session
from workbench.geometry.surface import ControlNet
from workbench.materials import CATALOGUE
from workbench.scene import AnyElement, FieldDescription, Kinds, Part, PlacedFace, Scene

_CUSTOM_INDEX = "index"
_AUTOMATIC, _OWN_RANGE = "automatic", "own"
_FACES = "face", "faces"


class ElementsPanel(ListedPanel):
    """Bound to ``scene.elements``."""

    def __init__(self, field: FieldDescription) -> None:
        self._field = field
        self._list = ElementListRow(tr("Optical train"), tr(field.tip))
        super().__init__(tr(field.title), self._list)

    def show_list(self, session: Session) -> None:
        """List the elements of the scene."""
        self._list.show_elements(session.scene)

    def name_of(self, number: int) -> str:
        """Its own name."""
        return begun(self.session.scene.elements[number].name)

    def rows_of(self, number: int) -> list[Row]:
        """Kind and settings of an element."""
        kinds = self._field.mark(Kinds)
        assert kinds is not None  # they are of several kinds
        rows = _ElementRows(self, number)
        return rows.of_kinds(self._field, kinds, rows.path, tr("Kind"))


class _ElementRows(Rows):
    """Makes the rows of one element."""

    def __init__(self, panel: ElementsPanel, number: int) -> None:
        own = {
            "material": self._material_rows,
            "height_range": self._range_rows,
            "heights": _heights_rows,
        }
        super().__init__(lambda: panel.session.scene, own)
        self._panel, self._number = panel, number
        self.path = f"elements[{number}]"

    def fields_of(
        self, kinds: Sequence[type[Part]]
    ) -> list[tuple[FieldDescription, list[type[Part]]]]:
        """Show faces below all else."""
        return sorted(super().fields_of(kinds), key=lambda own: own[0].name in _FACES)

    @property
    def _element(self) -> AnyElement:
        return self._panel.session.scene.elements[self._number]

    def _first_of(self, kinds: Kinds, kind: type[Part], path: str) -> Part | None:
        if path == self.path:
            return of_kind(kind, self._element)
        return super()._first_of(kinds, kind, path)

    def _material_rows(self, field: FieldDescription, path: str) -> list[Row]:
        """A material is a name, or an index of its own."""
        material = ChoiceRow(
            path,
            tr(field.title),
            tr(field.tip),
            [(_CUSTOM_INDEX, tr("Custom index")), *((name, tr(name)) for name in CATALOGUE)],
            read=lambda scene: _material(scene, path),
            changes=lambda choice: {path: self._material(choice)},
        )
        (own,) = field.parts[0].fields()
        index = value_row(own, f"{path}.{own.name}")
        index.indent()
        return [material, index]

    def _material(self, choice: str) -> object:
        scene = self._panel.session.scene
        if choice != _CUSTOM_INDEX:
            return choice
        return {_CUSTOM_INDEX: round(self._element.lit(scene.source.wavelength).index, 6)}

    def _range_rows(self, field: FieldDescription, path: str) -> list[Row]:
        """A range may follow from the task."""
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
            tr("From the base"),
            tr(
                "How far a control point may move from the base, down and up. A wider "
                "range bends light further."
            ),
            field.measure,
            field.between,
        )
        return [choice, limits]

    def _change_range(self, choice: str, path: str) -> Changes | None:
        if choice == _range(self._panel.session.scene, path):
            return None
        if choice == _AUTOMATIC:
            return {path: None}
        face = next(
            placed
            for placed in self._element.placed_faces
            if path == f"{self.path}.{placed.path}.height_range"
        )
        return {path: self._own_range(face)}

    def _own_range(self, face: PlacedFace) -> list[float]:
        """A range that the face as it is lies within."""
        scene, heights = self._panel.session.scene, self._panel.session.heights
        optic = scene.optic
        half = 0.3 * max(self._element.half_width)
        if self._number == scene.designed_number:
            if face.name != optic.designed_face:
                return list(bounded(scene).entrance_offsets)
            if heights is not None:
                x, y = ControlNet.of(optic).positions
                base = optic.base.height_at(x[:, None], y[None, :])
                half = max(half, 1.5 * float(np.abs(heights[face.name] - base).max()))
        half = float(f"{half:.2g}")
        return [-half, half]


def _heights_rows(field: FieldDescription, path: str) -> list[Row]:
    """Asked for of a fixed face only."""
    row = value_row(field, path)
    fixed = f"{path.rpartition('.')[0]}.fixed"
    row.only_if(lambda scene: bool(value_at(scene, fixed)))
    return [row]


def _range(scene: Scene, path: str) -> str:
    return _AUTOMATIC if value_at(scene, path) is None else _OWN_RANGE


def _material(scene: Scene, path: str) -> str:
    material = value_at(scene, path)
    return material if isinstance(material, str) else _CUSTOM_INDEX
