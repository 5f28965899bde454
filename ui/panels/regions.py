"""The regions of a scene as a list."""

from ui.panels.fields import PairsRow, Row
from ui.panels.lists import ListedPanel, PartListRow, another_name
from ui.panels.rows import Rows
from ui.words import in_sentence, tr
from workbench.files.session import Session
from workbench.powers import written
from workbench.scene import AnyRegion, FieldDescription, Kinds, RectangleRegion, Scene
from workbench.scene.part import title_of
from workbench.units import sized


class RegionListRow(PartListRow[AnyRegion]):
    """List of the regions."""

    def __init__(self, label: str, tip: str) -> None:
        super().__init__(
            "regions",
            label,
            tip,
            tr("region"),
            tr("Regions"),
            (
                tr("Add a region in the middle"),
                tr("Add a copy of the selected region"),
                tr("Remove the selected region"),
                tr("Move the selected region up"),
                tr("Move the selected region down"),
            ),
        )
        self._scene: Scene | None = None

    def show_regions(self, scene: Scene) -> None:
        self._scene = scene
        self.show_parts(scene.regions, "" if scene.regions else tr("None."))

    def _new(self, which: int) -> AnyRegion:
        assert self._scene is not None  # shown before anything can be clicked
        return RectangleRegion(name=tr("Region {count}").format(count=len(self._scene.regions) + 1))

    def _copy(self, part: AnyRegion) -> AnyRegion:
        assert self._scene is not None  # shown before anything can be clicked
        taken = (region.name for region in self._scene.regions)
        return part.model_copy(update={"name": another_name(part.name, taken, " ")})

    def _summary(self, part: AnyRegion) -> str:
        assert self._scene is not None
        receiver = self._scene.receiver
        low, high = part.outline.min(axis=0), part.outline.max(axis=0)
        width, height = (high - low) * receiver.half_extent * 2
        unit = receiver.measure.sign_in(self._scene.unit)
        size = sized(f"{written(width)} × {written(height)}", unit)
        return f"{part.name}: {in_sentence(tr(title_of(type(part))))}, {size}"


class RegionsPanel(ListedPanel):
    """Bound to ``scene.regions``."""

    def __init__(self, field: FieldDescription) -> None:
        self._field = field
        self._list = RegionListRow(tr("Regions"), tr(field.tip))
        super().__init__(tr(field.title), self._list)

    def show_list(self, session: Session) -> None:
        self._list.show_regions(session.scene)

    def name_of(self, number: int) -> str:
        return tr("Region {number}").format(number=number + 1)

    def rows_of(self, number: int) -> list[Row]:
        """Shape, place and size of a region."""
        kinds = self._field.mark(Kinds)
        assert kinds is not None  # they are of several kinds
        rows = Rows(lambda: self.session.scene, {"corners": _corner_rows})
        return rows.of_kinds(self._field, kinds, f"regions[{number}]", tr("Shape"))


def _corner_rows(field: FieldDescription, path: str) -> list[Row]:
    return [
        PairsRow(
            path,
            tr(field.title),
            f"{tr(field.tip)} {tr('As x, y; x, y; …')}",
            measure=field.measure,
        )
    ]
