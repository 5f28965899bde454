"""Choices of an image and of a face of the scene; hidden where there is only one."""

from PySide6.QtWidgets import QComboBox

from ui.document.frame import image_titles
from ui.views.shared_view import SharedView
from ui.widgets.controls import Choice
from ui.words import capitalised, tr
from workbench.geometry.surface import nets_of
from workbench.scene import Scene


class ImageChoice(Choice):
    """Choice of an image of the scene, shared by all views."""

    def __init__(self, shared: SharedView) -> None:
        super().__init__(tr("Image that is shown"), tr("Choose the image to show"))
        self._shared = shared
        self.activated.connect(shared.slot("number"))
        self.hide()

    def show_scene(self, scene: Scene) -> None:
        self.offer(dict(enumerate(image_titles(scene))), self._shared.number_in(scene))


class FaceChoice(Choice):
    """Choice of a freeform face."""

    def __init__(self) -> None:
        super().__init__(tr("Face"), tr("Choose the freeform face"))
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.hide()

    @property
    def face(self) -> str:
        """Id of the chosen face; empty before a scene is known."""
        return str(self.currentData() or "")

    @property
    def needed(self) -> str:
        """Title of the selected face; empty for a single one."""
        return self.currentText() if self.count() > 1 else ""

    def choose(self, face: str) -> None:
        self.setCurrentIndex(self.findData(face))

    def show_scene(self, scene: Scene) -> None:
        """Offer the freeform faces of a scene; the selection stays where possible."""
        titles = {face: capitalised(tr(scene.face_in_words(face))) for face in nets_of(scene)}
        self.offer(titles, self.face if self.face in titles else scene.optic.designed_face)
