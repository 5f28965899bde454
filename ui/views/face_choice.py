"""Choices above views: freeform face, and image of the scene; keys shared by views."""

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QComboBox

from ui.words import tr
from workbench.geometry.surface import freeform_nets
from workbench.scene import Optic


class FaceChoice(QComboBox):
    """Choice of a freeform face; hidden if there is only one."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(tr("Face"))
        self.setToolTip(tr("Which of the freeform faces of the lens is meant"))
        self.hide()

    @property
    def face(self) -> str:
        """Name of the chosen face; empty before an element is known."""
        return str(self.currentData() or "")

    @property
    def needed(self) -> str:
        """Title of the chosen face; empty if there is only one."""
        return self.currentText() if self.count() > 1 else ""

    def choose(self, face: str) -> None:
        """Choose a face by name."""
        self.setCurrentIndex(self.findData(face))

    def offer(self, optic: Optic) -> None:
        """Offer the faces of an element; a chosen face stays if it exists."""
        faces = list(freeform_nets(optic))
        if faces == [self.itemData(number) for number in range(self.count())]:
            return
        chosen = self.face if self.face in faces else optic.face
        with QSignalBlocker(self):
            self.clear()
            for face in faces:
                name = tr(optic.face_in_words(face))
                self.addItem(f"{name[0].upper()}{name[1:]}", face)
            self.choose(chosen)
        self.setVisible(len(faces) > 1)
