"""The question before saving takes the place of what another program has written."""

from enum import Enum, auto
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QMessageBox, QWidget

from ui.document.document import OnDisk
from ui.words import tr


class ChangedFileChoice(Enum):
    """What to do about a file that is no longer what the design was read from or saved to."""

    OVERWRITE = auto()
    SAVE_AS = auto()
    RELOAD = auto()
    CANCEL = auto()


def ask(path: Path, found: OnDisk, window: QWidget) -> ChangedFileChoice:
    """Put the question.

    Parameters
    ----------
    path : Path
        The design's file.
    found : OnDisk
        What has become of it.
    window : QWidget
        Asks.
    """
    box = QMessageBox(window)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setTextFormat(Qt.TextFormat.PlainText)  # names of files may look like markup
    roles = QMessageBox.ButtonRole
    choices: dict[QAbstractButton, ChangedFileChoice] = {}
    if found is OnDisk.CHANGED:
        box.setWindowTitle(tr("The file has changed"))
        box.setText(
            tr("Another program has changed {name} since it was last read or saved here.").format(
                name=path.name
            )
        )
        box.setInformativeText(
            tr(
                "Overwrite loses what the file holds now. Reload shows it in place of "
                "your design; Undo brings your design back."
            )
        )
        choices[box.addButton(tr("&Overwrite"), roles.DestructiveRole)] = (
            ChangedFileChoice.OVERWRITE
        )
        choices[box.addButton(tr("&Reload"), roles.ActionRole)] = ChangedFileChoice.RELOAD
    else:
        box.setWindowTitle(tr("The file is gone"))
        box.setText(
            tr("{name} has been deleted, moved or renamed since it was last saved here.").format(
                name=path.name
            )
        )
        if path.parent.is_dir():
            choices[box.addButton(tr("&Save there again"), roles.ApplyRole)] = (
                ChangedFileChoice.OVERWRITE
            )
        else:
            box.setInformativeText(
                tr("Its folder, {parent}, is gone, too.").format(parent=path.parent)
            )
    save_as = box.addButton(tr("Save &as…"), roles.AcceptRole)
    choices[save_as] = ChangedFileChoice.SAVE_AS
    box.setDefaultButton(save_as)
    box.setEscapeButton(box.addButton(QMessageBox.StandardButton.Cancel))
    box.exec()
    choice = choices.get(box.clickedButton(), ChangedFileChoice.CANCEL)
    box.deleteLater()
    return choice
