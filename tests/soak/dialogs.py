"""What a monkey does with a dialog or a menu that has opened."""

from pathlib import Path
from random import Random

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QDialog,
    QFileDialog,
    QLineEdit,
    QMenu,
    QMessageBox,
    QWidget,
)
from shiboken6 import isValid

LEAVING = ("Quit", "Close")
_SURE = ("Discard", "OK", "Yes", "Cancel")
_EXPORTS = ("stl", "obj", "ply", "glb", "step", "xyz", "dat", "npy", "csv", "png", "tiff", "what")


def open_dialog() -> QWidget | None:
    """The menu or dialog that has to be answered before anything else."""
    return QApplication.activePopupWidget() or QApplication.activeModalWidget()


def answer(dialog: QWidget, rng: Random, folder: Path, calm: bool) -> str:
    """Answer it; what was done.

    Parameters
    ----------
    folder : Path
        Files are saved and looked for here.
    calm : bool
        Nothing is begun: menus are left, changes discarded.
    """
    if isinstance(dialog, QMessageBox):
        return _press(dialog, rng, calm)
    if calm or rng.random() < 0.2:
        name = _name(dialog)
        QTest.keyClick(dialog, Qt.Key.Key_Escape)
        if isValid(dialog) and dialog.isVisible():  # a field of it may have taken the key
            dialog.close()
        return f"leave {name}"
    if isinstance(dialog, QFileDialog):
        return _choose_file(dialog, rng, folder)
    if isinstance(dialog, QMenu):
        return _choose(dialog, rng)
    return _fill(dialog, rng)


def _press(box: QMessageBox, rng: Random, calm: bool) -> str:
    buttons = {button.text().replace("&", ""): button for button in box.buttons()}
    name = rng.choice(list(buttons))
    if "Recover" in buttons:
        name = "Recover"
    elif calm:
        name = next((sure for sure in _SURE if sure in buttons), name)
    reported = box.text().replace("\n", " ")
    buttons[name].click()
    return f"{name!r} to {reported!r}"


def _choose_file(dialog: QFileDialog, rng: Random, folder: Path) -> str:
    if dialog.acceptMode() == QFileDialog.AcceptMode.AcceptSave:
        endings = ["freeform"] if "freeform" in dialog.nameFilters()[0] else list(_EXPORTS)
        name = f"{rng.choice('abcde')}.{rng.choice(endings)}"
    else:
        there = sorted(path.name for path in folder.iterdir())
        name = rng.choice([*there, "not-there.freeform"])
    field = dialog.findChild(QLineEdit, "fileNameEdit")
    field.setText(str(folder / name))
    QTest.keyClick(field, Qt.Key.Key_Return)
    return f"{dialog.windowTitle()}: {name}"


def _choose(menu: QMenu, rng: Random) -> str:
    able = [
        action
        for action in menu.actions()
        if action.isEnabled() and not action.isSeparator() and not action.menu()
    ]
    able = [action for action in able if action.text().replace("&", "") not in LEAVING]
    if not able:
        menu.close()
        return "leave menu"
    chosen = rng.choice(able)
    menu.close()
    chosen.trigger()
    return f"menu: {chosen.text()}"


def _fill(dialog: QWidget, rng: Random) -> str:
    """Type, choose and press at random; it may close of that."""
    name = _name(dialog)
    lists = [each for each in dialog.findChildren(QAbstractItemView) if each.isVisible()]
    fields = [each for each in dialog.findChildren(QLineEdit) if each.isVisible()]
    buttons = [each for each in dialog.findChildren(QAbstractButton) if each.isVisible()]
    done = []
    if fields:
        QTest.keyClicks(rng.choice(fields), rng.choice(["fit", "undo", "ray", "1", "x y", "view"]))
        done.append("type")
    if lists:
        for _ in range(rng.randrange(8)):
            QTest.keyClick(rng.choice(lists), rng.choice([Qt.Key.Key_Down, Qt.Key.Key_Right]))
        done.append("move")
    able = [button for button in buttons if button.isEnabled()]
    if able and rng.random() < 0.6:
        button = rng.choice(able)
        done.append(button.text())
        button.click()
    elif isinstance(dialog, QDialog) and not (fields and _about_to_leave(lists)):
        QTest.keyClick(fields[0] if fields else dialog, Qt.Key.Key_Return)
        done.append("Return")
    return f"{name}: {', '.join(done)}"


def _about_to_leave(lists: list[QAbstractItemView]) -> bool:
    texts = [str(each.currentIndex().data() or "") for each in lists]
    return any(word in text for text in texts for word in LEAVING)


def _name(widget: QWidget) -> str:
    return widget.windowTitle() or type(widget).__name__
