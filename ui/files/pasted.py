"""A picture from the clipboard, as a file that a target can name."""

import hashlib
from pathlib import Path

from PySide6.QtCore import QBuffer, QIODevice
from PySide6.QtGui import QGuiApplication, QImage, QImageWriter

from workbench.files.atomic import replacing


def pasted_picture(folder: Path) -> Path | None:
    """The picture on the clipboard.

    Parameters
    ----------
    folder : Path
        Gets a file of a picture that is none yet, named by what it holds.

    Returns
    -------
    Path or None
        The file that was copied, or the one that was written; None if no picture was copied.

    Raises
    ------
    Refused
        If the file cannot be written.
    """
    copied = QGuiApplication.clipboard().mimeData()
    files = [Path(url.toLocalFile()) for url in copied.urls() if url.isLocalFile()]
    if files:
        return files[0]
    image = QGuiApplication.clipboard().image()
    return None if image.isNull() else _written(image, folder)


def _written(image: QImage, folder: Path) -> Path:
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, b"png").write(image)
    content = bytes(buffer.data().data())
    path = folder / f"pasted-{hashlib.sha256(content).hexdigest()[:12]}.png"
    folder.mkdir(parents=True, exist_ok=True)
    with replacing(path) as file:
        file.write(content)
    return path
