"""The regions of a scene as a list."""

from dataclasses import replace

from ui.panels.fields import PairsRow, Row
from ui.panels.lists import ListedPanel, another_name
from ui.panels.rows import Rows
from ui.words import in_sentence, tr
from workbench.powers import written
from workbench.scene import AnyRegion, FieldDescription, Kinds, RectangleRegion, Scene
from workbench.scene.part import title_of
from workbench.units import sized


class RegionsPanel(ListedPanel[AnyRegion]):
    """Bound to ``scene.regions``."""

    def __init__(self, field: FieldDescription) -> None:
        self._field = field
        super().__init__(
            tr(field.title),
            replace(field, title=tr("Regions")),
            "regions",
            tr("region"),
            (
                tr("Add a region in the middle"),
                tr("Add a copy of the selected region"),
                tr("Remove the selected region"),
                tr("Move the selected region up"),
                tr("Move the selected region down"),
            ),
        )

    def parts_of(self, scene: Scene) -> tuple[AnyRegion, ...]:
        return scene.regions

    def remark(self, scene: Scene) -> str:
        return "" if scene.regions else tr("None.")

    def new(self, which: int) -> AnyRegion:
        count = len(self.session.scene.regions) + 1
        return RectangleRegion(name=tr("Region {count}").format(count=count))

    def copy(self, part: AnyRegion) -> AnyRegion:
        taken = (region.name for region in self.session.scene.regions)
        return part.model_copy(update={"name": another_name(part.name, taken, " ")})

    def summary(self, part: AnyRegion) -> str:
        scene = self.session.scene
        low, high = part.outline.min(axis=0), part.outline.max(axis=0)
        width, height = (high - low) * scene.receiver.half_extent * 2
        unit = scene.receiver.measure.sign_in(scene.unit)
        size = sized(f"{written(width)} × {written(height)}", unit)
        return f"{part.name}: {in_sentence(tr(title_of(type(part))))}, {size}"

    def name_of(self, number: int) -> str:
        return tr("Region {number}").format(number=number + 1)

    def rows_of(self, number: int) -> list[Row]:
        kinds = self._field.mark(Kinds)
        assert kinds is not None  # they are of several kinds
        rows = Rows(lambda: self.session.scene, {"corners": _corner_rows})
        return rows.of_kinds(self._field, kinds, f"regions[{number}]", tr("Shape"))


def _corner_rows(field: FieldDescription, path: str) -> list[Row]:
    tip = f"{tr(field.tip)} {tr('As x, y; x, y; …')}"
    return [PairsRow(replace(field, tip=tip), path)]
