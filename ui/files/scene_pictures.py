"""Takes the picture of the 3D scene to a file or to the clipboard."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QBuffer, QIODevice, QObject, Qt
from PySide6.QtGui import QCursor, QGuiApplication, QImage, QImageWriter

from ui.commands.table import PICTURES
from ui.document.document import Document
from ui.files.dialogs import FileDialogs
from ui.widgets.colours import rgb_image
from ui.widgets.message_bar import MessageBar
from ui.words import error_text, later, tr
from workbench.errors import Refused
from workbench.files.atomic import replacing

if TYPE_CHECKING:
    from ui.views.scene_view import SceneView

_ENDING = ".png"
_FILTER = later("Picture ({endings})")


class ScenePictures(QObject):
    """Copies and saves what the 3D view shows."""

    def __init__(
        self,
        view: "SceneView",
        document: Document,
        messages: MessageBar,
        dialogs: FileDialogs,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._view, self._document = view, document
        self._messages, self._dialogs = messages, dialogs

    def slots(self) -> dict[str, Callable[[], object]]:
        """What commands do here."""
        return {
            "copy_scene": self.copy,
            **{name: partial(self.choose_and_save, times) for name, times in PICTURES.items()},
        }

    def copy(self) -> None:
        """Put the picture on the clipboard."""
        image = self._image(1)
        if image is not None:
            QGuiApplication.clipboard().setImage(image)
            self._messages.done(tr("A picture of the 3D scene is on the clipboard."))

    def choose_and_save(self, times: int) -> None:
        """Ask for a file and save the picture there, so many times as large as it is seen."""
        path = self.ask_for_name() if self._seen() else None
        if path is not None:
            self.save(path, times)

    def save(self, path: Path, times: int) -> None:
        """Save the picture as PNG."""
        image = self._image(times)
        if image is None:
            return
        buffer = QBuffer()
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        QImageWriter(buffer, b"png").write(image)
        try:
            with replacing(path) as file:
                file.write(bytes(buffer.data().data()))
        except Refused as refused:
            self._messages.warn(error_text(refused))
        else:
            self._messages.done(
                tr("{path} is written, {width} × {height} pixels.").format(
                    path=path, width=image.width(), height=image.height()
                )
            )

    def ask_for_name(self) -> Path | None:
        """Ask for a file."""
        name = f"{self._document.name} 3D"
        return self._dialogs.to_save(
            "plot",
            tr("Save picture of 3D"),
            name,
            {tr(_FILTER).format(endings=f"*{_ENDING}"): _ENDING},
        )

    def _seen(self) -> bool:
        if not self._view.isVisible():
            self._messages.note(tr("The 3D scene is hidden; View > 3D scene shows it."))
        return self._view.isVisible()

    def _image(self, times: int) -> QImage | None:
        if not self._seen():
            return None
        QGuiApplication.setOverrideCursor(QCursor(Qt.CursorShape.WaitCursor))
        try:
            pixels = self._view.picture(times)
        finally:
            QGuiApplication.restoreOverrideCursor()
        return None if pixels is None else rgb_image(pixels)
