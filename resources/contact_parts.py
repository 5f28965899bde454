"""Parts of the window for the contact sheets: docks, forms, menus, dialogs, start page."""

from collections.abc import Callable, Iterator
from functools import partial

from PySide6.QtCore import QLockFile, Qt, QTimer
from PySide6.QtGui import QPixmap
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QDialog, QLineEdit, QPushButton

import resources
from resources.make_screenshot import dialog_of, settle
from ui.commands.panes import PANES
from ui.commands.table import TOOLS
from ui.dialogs.coach import MARKS, CoachMarks
from ui.files.recovery import About, LeftBehind, ask
from ui.main_window import MainWindow

_MOMENT, _WHILE = 300, 1500  # milliseconds: to draw, and to compute what only eyes ask for
_MAPS = ("surface", "manufacture")  # docks with a choice of maps
_FORMS = ("flame-stages", "tophat-sparse-random", "flame-x3")  # examples with other rows
_MESSAGE = (
    "A message as long as some are: the design task and the lens of the run before are here "
    "again, and what was changed since can be brought back by Undo."
)
_OPEN = ("palette", "shortcuts")  # commands whose dialogs let the window go on
_HOLD = ("about", "open", "save_as", "export", "report", "save_plot", "save_scene")


def docks(window: MainWindow) -> Iterator[QPixmap]:
    """Each dock by itself, then the window with all of them and a message."""
    yield window.grab()
    for name in PANES:
        window.commands[f"go_{name}"].trigger()
        settle(_WHILE)
        if name != "scene":
            yield window.panes.place(name).grab()
        if name in _MAPS:
            yield from _maps(window, name)
    window.messages.warn(_MESSAGE, ("Do it", window.messages.clear))
    settle(_WHILE)
    yield window.grab()
    window.messages.clear()
    window.commands["reset_layout"].trigger()


def curve(window: MainWindow) -> Iterator[QPixmap]:
    """The light through focus with its curve."""
    dock = window.panes.images
    window.commands["go_focus"].trigger()
    (button,) = (each for each in dock.findChildren(QPushButton) if each.isCheckable())
    button.click()
    settle(4 * _WHILE)
    yield dock.grab()
    button.click()
    window.commands["reset_layout"].trigger()


def tools(window: MainWindow) -> Iterator[QPixmap]:
    """The window with each tool of the 3D scene."""
    for name in TOOLS:
        window.commands[name].trigger()
        window.commands["go_scene"].trigger()
        settle(_MOMENT)
        yield window.grab()
    window.commands[TOOLS[0]].trigger()


def forms(window: MainWindow) -> Iterator[QPixmap]:
    """All rows that forms can have, some of them refused."""
    for name in _FORMS:
        window.document.open(resources.path("examples", f"{name}.json"))
        settle(_MOMENT)
        yield _whole_form(window)
    for field in window.forms.findChildren(QLineEdit):
        if field.isVisible() and not field.isReadOnly():
            field.setText("-1")
            field.editingFinished.emit()
    settle(_MOMENT)
    yield _whole_form(window)


def menus(window: MainWindow) -> Iterator[QPixmap]:
    """Every menu: those of the bar, and those within."""
    for menu in window.commands.menus.values():
        menu.popup(window.pos())
        settle(_MOMENT)
        yield menu.grab()
        menu.close()


def dialogs(window: MainWindow) -> Iterator[QPixmap]:
    """Every dialog, questions too."""
    for command in _OPEN:
        yield dialog_of(window, command)
    file = resources.path("examples", "flame.json")
    lock = QLockFile("")  # of nothing
    asked: list[Callable[[], object]] = [
        *(window.commands[command].trigger for command in _HOLD),
        partial(window.files.ask, "Save the changes to flame?"),
        *(
            partial(ask, LeftBehind(file, About("flame", ended=ended), lock), window)
            for ended in (False, True)
        ),
    ]
    for each in asked:
        yield _of_what_holds(each)


def tour(window: MainWindow) -> Iterator[QPixmap]:
    """Each coach mark, and the start page."""
    window.commands["tour"].trigger()
    (marks,) = window.findChildren(CoachMarks)
    for _ in MARKS:
        settle(_MOMENT)
        yield marks.grab()
        marks.on.click()
    window.commands["new"].trigger()
    settle(_MOMENT)
    yield window.grab()
    window.commands["workspace_task"].trigger()


def _maps(window: MainWindow, name: str) -> Iterator[QPixmap]:
    dock = window.panes.place(name)
    chooser = dock.findChildren(QComboBox)[0]
    for number in range(1, chooser.count()):
        chooser.setCurrentIndex(number)
        settle(_WHILE)
        yield dock.grab()
    chooser.setCurrentIndex(0)


def _whole_form(window: MainWindow) -> QPixmap:
    form = window.forms.widget()
    assert form is not None
    return form.grab()


def _of_what_holds(begin: Callable[[], object]) -> QPixmap:
    """The dialog that a call opens and waits for."""
    taken: list[QPixmap] = []

    def take() -> None:
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QDialog)
        taken.append(dialog.grab())
        QTest.keyClick(dialog, Qt.Key.Key_Escape)

    QTimer.singleShot(2 * _MOMENT, take)
    begin()
    (picture,) = taken
    return picture
