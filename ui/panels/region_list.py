"""The regions of a scene as a list."""

from ui.panels.part_list import PartListRow, another_name
from ui.words import inside, tr
from workbench.powers import written
from workbench.scene import AnyRegion, RectangleRegion, Scene
from workbench.scene.kinds import title_of
from workbench.units import sized


class RegionListRow(PartListRow[AnyRegion]):
    """The regions one below the other, and what can be done with them."""

    def __init__(self, label: str, tip: str) -> None:
        super().__init__(
            "regions",
            label,
            tip,
            tr("region"),
            tr("Regions"),
            (
                tr("Add a region in the middle"),
                tr("Add a copy of the chosen region behind it"),
                tr("Remove the chosen region"),
                tr("Move the chosen region up"),
                tr("Move the chosen region down"),
            ),
        )
        self._scene: Scene | None = None

    def show_regions(self, scene: Scene) -> None:
        """Show the regions of a scene."""
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
        """Name, kind and how far it goes, in the receiver's own coordinates."""
        assert self._scene is not None
        receiver = self._scene.receiver
        low, high = part.outline.min(axis=0), part.outline.max(axis=0)
        width, height = (high - low) * receiver.half_extent * 2
        unit = receiver.measure.sign_in(self._scene.unit)
        size = sized(f"{written(width)} × {written(height)}", unit)
        return f"{part.name}: {inside(tr(title_of(type(part))))}, {size}"
