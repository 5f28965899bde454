"""The elements of a scene as a list, in the order in which light meets them."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ui.panels.fields import Changes, ChoiceRow, NumberRow, Row
from ui.panels.panel import ListedPanel, another_name
from ui.panels.rows import Rows, value_row
from ui.panels.text_rows import TextRow
from ui.words import capitalised, in_sentence, later, tr
from workbench.design.limits import bounded
from workbench.geometry.surface import ControlNet
from workbench.materials import CATALOGUE
from workbench.powers import rounded, written
from workbench.scene import (
    AnyElement,
    Diffuser,
    FieldDescription,
    GaussianScatter,
    Kinds,
    Lens,
    Measure,
    Mirror,
    Part,
    PlacedFace,
    Scene,
)
from workbench.scene.part import title_of
from workbench.scene.paths import value_at

_KINDS: tuple[type[AnyElement], ...] = (Lens, Mirror, Diffuser)
_MATERIAL = "PMMA"
# A new lens is plano-convex: its back face is a sphere of so many half widths, and it is so many
# half widths thick, which leaves glass at the corners of a square one.
_RADIUS, _THICKNESS = 4.0, 0.5
_SIGMA = 5.0  # degrees, of a new diffuser
_GAP = 0.1  # half widths between a new element and the one before


def of_kind(kind: type[Part], before: AnyElement) -> AnyElement:
    """Return an element of another kind at the same place, with the same last face."""
    last = before.placed_faces[-1].face
    faces = ({"shape": "plane"}, last) if kind is Lens else (last,)
    same = {name: getattr(before, name) for name in ("name", "position", "tilt", "outline")}
    return _element(kind, faces, before, **same)


def _element(
    kind: type[Part], faces: tuple[Any, ...], like: AnyElement, **fields: Any
) -> AnyElement:
    fields["half_width"] = like.half_width
    if kind is Mirror:
        return Mirror(kind="mirror", face=faces[0], **fields)
    if kind is Diffuser:
        scatter = GaussianScatter(kind="gaussian", sigma=_SIGMA)
        return Diffuser(kind="diffuser", scatter=scatter, **fields)
    thickness = _rounded(_THICKNESS * max(like.half_width))
    return Lens(kind="lens", material=_MATERIAL, thickness=thickness, faces=faces, **fields)


def _behind(element: AnyElement) -> tuple[float, float, float]:
    x, y, _ = element.position
    gap = _GAP * max(element.half_width)
    z = element.highest + gap if element.onwards > 0 else element.lowest - gap
    return x, y, rounded(z, 6)


def _shifted(element: AnyElement, by: float) -> AnyElement:
    x, y, z = element.position
    return element.model_copy(update={"position": (x, y, rounded(z + by, 12))})


def _rounded(length: float) -> float:
    return rounded(length, 3)


_CUSTOM_INDEX = "index"
_AUTOMATIC, _OWN_RANGE = "automatic", "own"
_FACES = "face", "faces"


class ElementsPanel(ListedPanel[AnyElement]):
    """Bound to ``scene.elements``."""

    _CALLED = later("element")

    def __init__(self, field: FieldDescription) -> None:
        super().__init__(
            field,
            {
                tr("Add lens"): tr("Add a plano-convex lens of fixed shape behind the others"),
                tr("Add mirror"): tr("Add a plane mirror behind the others"),
                tr("Add diffuser"): tr("Add a diffuser behind the others"),
            },
            listed=later("Optical train"),
        )

    def new(self, which: int) -> AnyElement:
        last, kind = self.session.scene.elements[-1], _KINDS[which]
        size = max(last.half_width)
        faces: tuple[dict[str, Any], ...] = ({"shape": "plane"},)
        if kind is Lens:
            faces += ({"shape": "conic", "radius": -_rounded(_RADIUS * size)},)
        name = self._free_name(kind.__name__.lower())
        return _element(kind, faces, last, name=name, position=_behind(last))

    def copy(self, part: AnyElement) -> AnyElement:
        return part.model_copy(
            update={
                "name": self._free_name(part.name),
                "position": _behind(self.session.scene.elements[-1]),
            }
        )

    def place_of_copy(self) -> int:
        return len(self.session.scene.elements)

    def exchanged(self, first: AnyElement, second: AnyElement) -> tuple[AnyElement, AnyElement]:
        to_front, to_end = first.front_z - second.front_z, second.highest - first.highest
        return _shifted(second, to_front), _shifted(first, to_end)

    def chosen_among(self, before: tuple[AnyElement, ...], parts: tuple[AnyElement, ...]) -> int:
        names, current = [part.name for part in parts], self.current
        if before and before[current].name in names:
            return names.index(before[current].name)
        if len(before) == len(parts):
            return current
        return next((number for number, part in enumerate(parts) if part.designed), 0)

    def summary(self, part: AnyElement) -> str:
        kind = in_sentence(tr(title_of(type(part))))
        words = [kind if part.name == part.kind else f"{part.name}: {kind}"]
        if part.designed:
            words.append(tr("designed"))
        words.append(f"z = {written(part.position[2], self.session.scene.unit)}")
        return ", ".join(words)

    def _free_name(self, name: str) -> str:
        taken = [part.name for part in self.session.scene.elements]
        return another_name(name, taken, "-") if name in taken else name

    def name_of(self, number: int) -> str:
        return capitalised(self.session.scene.elements[number].name)

    def rows_of(self, number: int) -> list[Row]:
        rows = _ElementRows(self, number)
        return rows.of_kinds(self._field, rows.path, tr("Kind"))


class _ElementRows(Rows):
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
        return sorted(super().fields_of(kinds), key=lambda own: own[0].name in _FACES)

    @property
    def _element(self) -> AnyElement:
        return self._panel.session.scene.elements[self._number]

    def _first_of(self, kinds: Kinds, kind: type[Part], path: str) -> Part | None:
        if path == self.path:
            return of_kind(kind, self._element)
        return super()._first_of(kinds, kind, path)

    def _material_rows(self, field: FieldDescription, path: str) -> list[Row]:
        material = ChoiceRow(
            field,
            path,
            [(_CUSTOM_INDEX, tr("Custom index")), *((name, tr(name)) for name in CATALOGUE)],
            read=lambda scene: _material(scene, path),
            changes=lambda choice: {path: self._material(choice)},
        )
        (own,) = field.parts[0].fields()
        index = value_row(own, f"{path}.{own.name}")
        index.put_under(material)
        return [material, index]

    def _material(self, choice: str) -> object:
        scene = self._panel.session.scene
        if choice != _CUSTOM_INDEX:
            return choice
        return {_CUSTOM_INDEX: round(self._element.lit(scene.source.wavelength).index, 6)}

    def _range_rows(self, field: FieldDescription, path: str) -> list[Row]:
        choice = ChoiceRow(
            field,
            path,
            [(_AUTOMATIC, tr("Automatic")), (_OWN_RANGE, tr("Own limits"))],
            read=lambda scene: _range(scene, path),
            changes=lambda choice: self._change_range(choice, path),
        )
        choice.measure = Measure()  # of words
        tip = tr(
            "Bounds of the control heights relative to the base, down and up. Wider bounds allow "
            "larger deflection."
        )
        own = replace(field, title=tr("From the base"), tip=tip, optional=False)
        limits = NumberRow(own, path)
        return [choice, limits]

    def _change_range(self, choice: str, path: str) -> Changes | None:
        if choice == _range(self._panel.session.scene, path):
            return None
        if choice == _AUTOMATIC:
            return {path: None}
        own = {f"{self.path}.{each.path}.height_range": each for each in self._element.placed_faces}
        # A row of a kind that the element is no longer of has no face.
        return {path: self._own_range(own[path])} if path in own else None

    def _own_range(self, face: PlacedFace) -> list[float]:
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
        half = rounded(half, 2)
        return [-half, half]


def _heights_rows(field: FieldDescription, path: str) -> list[Row]:
    row = TextRow(field, path)
    fixed = f"{path.rpartition('.')[0]}.fixed"
    row.only_if(lambda scene: bool(value_at(scene, fixed)))
    return [row]


def _range(scene: Scene, path: str) -> str:
    return _AUTOMATIC if value_at(scene, path) is None else _OWN_RANGE


def _material(scene: Scene, path: str) -> str:
    material = value_at(scene, path)
    return material if isinstance(material, str) else _CUSTOM_INDEX
