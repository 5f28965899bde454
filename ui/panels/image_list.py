"""The further images of a scene as a list, in their order."""

from ui.panels.part_list import PartListRow
from ui.words import inside, tr
from workbench.scene import FurtherImage, Scene
from workbench.scene.kinds import title_of

_FARTHER = 1.2  # times as far from the lens as the receiver before


class ImageListRow(PartListRow[FurtherImage]):
    """The further images one below the other, and what can be done with them."""

    def __init__(self, label: str, tip: str) -> None:
        super().__init__(
            "further_images",
            label,
            tip,
            tr("further image"),
            tr("Further images"),
            (
                tr("Add an image farther away, with the target of the last one"),
                tr("Remove the chosen image"),
                tr("Move the chosen image up"),
                tr("Move the chosen image down"),
            ),
        )
        self._scene: Scene | None = None

    def show_images(self, scene: Scene) -> None:
        """Show the further images of a scene."""
        self._scene = scene
        images = scene.further_images
        count = tr("{count} images in all, each by its weight; the first one has 1.").format(
            count=len(images) + 1
        )
        self.show_parts(images, count if images else tr("None: there is one image."))

    def _new(self) -> FurtherImage:
        """Like the last one, farther away where it is at a distance."""
        assert self._scene is not None  # shown before anything can be clicked
        last = self._scene.single[-1]
        screen, near = last.screen, last.optic.leaving_z
        if screen is not None:
            screen = screen.moved_to(float(f"{near + _FARTHER * (screen.z - near):.6g}"))
        return FurtherImage(screen=screen, far_field=last.far_field, target=last.target)

    def _summary(self, part: FurtherImage) -> str:
        receiver = part.receiver
        place = f"z = {receiver.plane_z:.6g}" if receiver.at_distance else tr(receiver.called)
        return tr("{place}, {target}, weight {weight:g}").format(
            place=place, target=inside(tr(title_of(type(part.target)))), weight=part.weight
        )
