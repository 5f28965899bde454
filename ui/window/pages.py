"""Pages of a window: the start page, or the desk with the panes of a design."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QMainWindow, QStackedWidget

from ui.commands.actions import Commands
from ui.dialogs.start_page import StartPage
from ui.window.workspaces import Workspaces


class Pages(QStackedWidget):
    """Shows one page; the toolbar belongs to the desk."""

    start_shown = Signal(bool)

    def __init__(self, window: QMainWindow) -> None:
        super().__init__()
        window.setCentralWidget(self)  # before all else: each move polishes what moves
        self.desk = QMainWindow()
        self.addWidget(self.desk)

    def put(self, start: StartPage, workspaces: Workspaces, commands: Commands) -> None:
        """Put the start page, and follow what the workspaces show on the desk."""
        self._start, self._workspaces, self._commands = start, workspaces, commands
        self.addWidget(start)
        start.left.connect(self.show_desk)
        workspaces.changed.connect(self.show_desk)
        self.desk.setFocus()  # else Qt gives the keyboard to the first button

    @property
    def at_start(self) -> bool:
        return self.currentWidget() is self._start

    def show_start(self) -> None:
        self.setCurrentWidget(self._start)
        self._commands.toolbar.hide()
        self._commands["workspace_start"].setChecked(True)
        self._start.begin_anew()
        self.start_shown.emit(True)

    def show_desk(self, name: str = "") -> None:
        """Show the desk, in the present workspace or in another one."""
        if self.currentWidget() is not self.desk:
            self.setCurrentWidget(self.desk)
            self.desk.setFocus()
        self._commands.toolbar.show()
        self._workspaces.choose(name or self._workspaces.name)
        self._commands[f"workspace_{self._workspaces.name}"].setChecked(True)
        self.start_shown.emit(False)
