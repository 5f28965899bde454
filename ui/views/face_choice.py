"""A choice between the freeform faces of an optic."""

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QComboBox

from ui.words import tr
from workbench.geometry.surface import freeform_nets
from workbench.scene import Element


class FaceChoice(QComboBox):
    """Hidden while there is no choice: the optic has one freeform face."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(tr("Face"))
        self.setToolTip(tr("Which of the freeform faces of the lens is meant"))
        self.hide()

    @property
    def face(self) -> str:
        """The name of the chosen face; empty before an optic is known."""
        return str(self.currentData() or "")

    @property
    def needed(self) -> str:
        """What the chosen face is called; empty where the optic has one alone."""
        return self.currentText() if self.count() > 1 else ""

    def choose(self, face: str) -> None:
        """Choose one by its name."""
        self.setCurrentIndex(self.findData(face))

    def offer(self, optic: Element) -> None:
        """Let the faces of an optic be chosen; one that is chosen stays if it has that."""
        faces = list(freeform_nets(optic))
        if faces == [self.itemData(number) for number in range(self.count())]:
            return
        chosen = self.face if self.face in faces else optic.designed_face
        with QSignalBlocker(self):
            self.clear()
            for face in faces:
                name = tr(optic.face_in_words(face))
                self.addItem(f"{name[0].upper()}{name[1:]}", face)
            self.choose(chosen)
        self.setVisible(len(faces) > 1)
