"""Which one of a scene's images is shown, where there are several."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QComboBox

from ui.views.image_link import ImageLink
from ui.words import tr

if TYPE_CHECKING:
    from workbench.scene import AnyReceiver, Scene


class ImageChoice(QComboBox):
    """All views with the same link show the image that is chosen in any of them.

    Parameters
    ----------
    link : ImageLink
        Keeps the choice.
    """

    def __init__(self, link: ImageLink) -> None:
        super().__init__()
        self._link = link
        self.setAccessibleName(tr("Image that is shown"))
        self.setToolTip(tr("Which of the scene's images is shown"))
        self.activated.connect(link.show_image)
        self.hide()

    def show_scene(self, scene: "Scene") -> None:
        """Offer the images of a scene; nothing where there is only one."""
        titles = [
            tr("Image {number}, {place}").format(number=number, place=_place(receiver, scene.unit))
            for number, receiver in enumerate(scene.receivers, start=1)
        ]
        with QSignalBlocker(self):
            if titles != [self.itemText(number) for number in range(self.count())]:
                self.clear()
                self.addItems(titles)
            self.setCurrentIndex(self._link.number_in(scene))
        self.setVisible(len(titles) > 1)


def _place(receiver: "AnyReceiver", unit: str) -> str:
    return f"z = {receiver.plane_z:.4g} {unit}" if receiver.at_distance else tr(receiver.called)
