"""The elements of a scene as a list, in the order in which light meets them."""

from typing import Any

from ui.panels.part_list import PartListRow, another_name
from ui.words import inside, tr
from workbench.powers import written
from workbench.scene import AnyElement, Lens, Mirror, Part, Scene
from workbench.scene.kinds import title_of

_KINDS: tuple[type[AnyElement], ...] = (Lens, Mirror)
_MATERIAL = "PMMA"
# A new lens is plano-convex: its back face is a sphere of so many half widths, and it is so many
# half widths thick, which leaves glass at the corners of a square one.
_RADIUS, _THICKNESS = 4.0, 0.5
_GAP = 0.1  # half widths between a new element and the one before


class ElementListRow(PartListRow[AnyElement]):
    """The elements one below the other, and what can be done with them."""

    def __init__(self, label: str, tip: str) -> None:
        super().__init__(
            "elements",
            label,
            tip,
            tr("element"),
            tr("Elements"),
            (
                tr("Add a plano-convex lens of fixed shape behind the last element"),
                tr("Add a plane mirror behind the last element"),
                tr("Add a copy of the chosen element behind the last element"),
                tr("Remove the chosen element"),
                tr("Exchange the chosen element with the one before it, along z too"),
                tr("Exchange the chosen element with the one behind it, along z too"),
            ),
            (tr("Add lens"), tr("Add mirror")),
        )
        self._scene: Scene | None = None

    def show_elements(self, scene: Scene) -> None:
        """Show the elements of a scene."""
        self._scene = scene
        self.show_parts(scene.elements, "")

    def _new(self, which: int) -> AnyElement:
        last, kind = self._parts[-1], _KINDS[which]
        size = max(last.half_width)
        faces: tuple[dict[str, Any], ...] = ({"shape": "plane"},)
        if kind is Lens:
            faces += ({"shape": "conic", "radius": -_rounded(_RADIUS * size)},)
        name = self._free_name(kind.__name__.lower())
        return _element(kind, faces, last, name=name, position=_behind(last))

    def _copy(self, part: AnyElement) -> AnyElement:
        return part.model_copy(
            update={"name": self._free_name(part.name), "position": _behind(self._parts[-1])}
        )

    def _place_of_copy(self) -> int:
        return len(self._parts)

    def _exchanged(self, first: AnyElement, second: AnyElement) -> tuple[AnyElement, AnyElement]:
        """Both together take the same length along z as before."""
        to_front, to_end = first.front_z - second.front_z, second.highest - first.highest
        return _shifted(second, to_front), _shifted(first, to_end)

    def _chosen_among(self, parts: tuple[AnyElement, ...]) -> int:
        """The one of the same name, or at the same place of as many; else the designed one."""
        before, names = self._parts, [part.name for part in parts]
        if before and before[self.current].name in names:
            return names.index(before[self.current].name)
        if len(before) == len(parts):
            return self.current
        return next((number for number, part in enumerate(parts) if part.designed), 0)

    def _summary(self, part: AnyElement) -> str:
        assert self._scene is not None  # shown before anything can be clicked
        kind = inside(tr(title_of(type(part))))
        words = [kind if part.name == part.kind else f"{part.name}: {kind}"]
        if part.designed:
            words.append(tr("designed"))
        words.append(f"z = {written(part.position[2], self._scene.unit)}")
        return ", ".join(words)

    def _free_name(self, name: str) -> str:
        taken = [part.name for part in self._parts]
        return another_name(name, taken, "-") if name in taken else name


def of_kind(kind: type[Part], before: AnyElement) -> AnyElement:
    """Return an element of another kind at the same place, with the same last face."""
    last = before.placed_faces[-1].face
    faces = ({"shape": "plane"}, last) if kind is Lens else (last,)
    same = {name: getattr(before, name) for name in ("name", "position", "tilt", "outline")}
    return _element(kind, faces, before, **same)


def _element(
    kind: type[Part], faces: tuple[Any, ...], like: AnyElement, **fields: Any
) -> AnyElement:
    """An element with these faces, as large as another one."""
    fields["half_width"] = like.half_width
    if kind is Mirror:
        return Mirror(kind="mirror", face=faces[0], **fields)
    thickness = _rounded(_THICKNESS * max(like.half_width))
    return Lens(kind="lens", material=_MATERIAL, thickness=thickness, faces=faces, **fields)


def _behind(element: AnyElement) -> tuple[float, float, float]:
    """Where the next element may stand: a gap behind it, the way that light goes on."""
    x, y, _ = element.position
    gap = _GAP * max(element.half_width)
    z = element.highest + gap if element.onwards > 0 else element.lowest - gap
    return x, y, float(f"{z:.6g}")


def _shifted(element: AnyElement, by: float) -> AnyElement:
    x, y, z = element.position
    return element.model_copy(update={"position": (x, y, float(f"{z + by:.12g}"))})


def _rounded(length: float) -> float:
    return float(f"{length:.3g}")
