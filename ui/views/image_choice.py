"""Which one of a scene's images is shown, where there are several."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QComboBox

from ui.shown.image_titles import image_titles
from ui.views.image_link import ImageLink
from ui.words import tr

if TYPE_CHECKING:
    from workbench.scene import Scene


class ImageChoice(QComboBox):
    """Choice of an image of the scene, shared by views with the same link."""

    def __init__(self, link: ImageLink) -> None:
        super().__init__()
        self._link = link
        self.setAccessibleName(tr("Image that is shown"))
        self.setToolTip(tr("Which of the scene's images is shown"))
        self.activated.connect(link.show_image)
        self.hide()

    def show_scene(self, scene: "Scene") -> None:
        """Offer the images of a scene; hidden if there is only one."""
        titles = image_titles(scene)
        with QSignalBlocker(self):
            if titles != [self.itemText(number) for number in range(self.count())]:
                self.clear()
                self.addItems(titles)
            self.setCurrentIndex(self._link.number_in(scene))
        self.setVisible(len(titles) > 1)
