"""Choices of an image and of a face of the scene; hidden where there is only one."""

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QComboBox

from ui.document.frame import image_titles
from ui.views.shared_view import SharedView
from ui.words import capitalised, tr
from workbench.geometry.surface import nets_of
from workbench.scene import Scene


class ImageChoice(QComboBox):
    """Choice of an image of the scene, shared by all views."""

    def __init__(self, shared: SharedView) -> None:
        super().__init__()
        self._shared = shared
        self.setAccessibleName(tr("Image that is shown"))
        self.setToolTip(tr("Choose the image to show"))
        self.activated.connect(shared.slot("number"))
        self.hide()

    def show_scene(self, scene: Scene) -> None:
        titles = image_titles(scene)
        with QSignalBlocker(self):
            if titles != [self.itemText(number) for number in range(self.count())]:
                self.clear()
                self.addItems(titles)
            self.setCurrentIndex(self._shared.number_in(scene))
        self.setVisible(len(titles) > 1)


class FaceChoice(QComboBox):
    """Choice of a freeform face."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(tr("Face"))
        self.setToolTip(tr("Choose the freeform face"))
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
        faces = list(nets_of(scene))
        if faces == [self.itemData(number) for number in range(self.count())]:
            return
        chosen = self.face if self.face in faces else scene.optic.designed_face
        with QSignalBlocker(self):
            self.clear()
            for face in faces:
                self.addItem(capitalised(tr(scene.face_in_words(face))), face)
            self.choose(chosen)
        self.setVisible(len(faces) > 1)
