"""The images of a scene as a list, in their order."""

from ui.panels.part_list import PartListRow
from ui.words import inside, tr
from workbench.scene import Image, Scene, Screen
from workbench.scene.kinds import title_of

_FARTHER = 1.2  # times as far from the lens as the receiver before


class ImageListRow(PartListRow[Image]):
    """The images one below the other, and what can be done with them."""

    def __init__(self, label: str, tip: str) -> None:
        super().__init__(
            "images",
            label,
            tip,
            tr("image"),
            tr("Images"),
            (
                tr("Add an image farther away, with the target of the last one"),
                tr("Add a copy of the chosen image behind it"),
                tr("Remove the chosen image"),
                tr("Move the chosen image up"),
                tr("Move the chosen image down"),
            ),
        )
        self._scene: Scene | None = None

    def show_images(self, scene: Scene) -> None:
        """Show the images of a scene."""
        self._scene = scene
        of_first = tr("The panels Target and Receiver have the settings of image 1.")
        self.show_parts(scene.images, of_first if len(scene.images) > 1 else "")

    def _new(self, which: int) -> Image:
        """Like the last one, farther away where it is at a distance."""
        assert self._scene is not None  # shown before anything can be clicked
        last, near = self._scene.images[-1], self._scene.optic.leaving_z
        receiver = last.receiver
        if isinstance(receiver, Screen):
            away = _FARTHER * (receiver.plane_z - near)
            receiver = receiver.moved_to(float(f"{near + away:.6g}"))
        return Image(receiver=receiver, target=last.target)

    def _summary(self, part: Image) -> str:
        receiver = part.receiver
        place = f"z = {receiver.plane_z:.6g}" if receiver.at_distance else tr(receiver.called)
        return tr("{place}, {target}, weight {weight:g}").format(
            place=place, target=inside(tr(title_of(type(part.target)))), weight=part.weight
        )
