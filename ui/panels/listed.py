"""A list of parts of the scene, and the settings of the one that is chosen."""

from abc import abstractmethod
from itertools import pairwise
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from ui.panels.fields import Row
from ui.panels.panel import Panel
from ui.panels.part_list import PartListRow
from workbench.files.session import Session


class ListedPanel(Panel):
    """Shows rows of one part of a list; a panel says which.

    Parameters
    ----------
    title : str
        What a person reads above it.
    parts : PartListRow
        The list.
    """

    def __init__(self, title: str, parts: PartListRow[Any]) -> None:
        self._parts = parts
        self._bound = -1  # the part whose rows are there
        self._called = ""  # in their names
        super().__init__(title, [parts])
        parts.chosen.connect(self._choose)

    def prepare(self, session: Session) -> None:
        """Have rows for the chosen part, if there is one."""
        self._session = session
        self.show_list(session)
        self._bind(self._parts.current)

    @abstractmethod
    def show_list(self, session: Session) -> None:
        """List the parts of a session."""

    @abstractmethod
    def name_of(self, number: int) -> str:
        """What a person reads for a part."""

    @abstractmethod
    def rows_of(self, number: int) -> list[Row]:
        """The rows of a part."""

    def _choose(self) -> None:
        """Show another part; what was refused in the one before is taken back."""
        self._bind(self._parts.current)
        self.reverted.emit(self._parts.path)

    def _bind(self, number: int) -> None:
        name = self.name_of(number) if number >= 0 else ""
        if number != self._bound:
            self._remove_rows(list(self.rows[1:]))
            self._bound = number
            if number >= 0:
                self._add_rows(self.rows_of(number), name)
                self._put_in_tab_order()
        elif name != self._called:
            self._name_rows(self.rows[1:], name)
        self._called = name

    def _put_in_tab_order(self) -> None:
        """Let Tab reach the new rows behind the list; they would come last of all panels."""
        stops = [
            widget
            for row in self.rows
            for widget in row.findChildren(QWidget)
            if widget.focusPolicy() & Qt.FocusPolicy.TabFocus
            and widget.focusProxy() is None
            and widget.window() is self.window()  # not the lists that choosers open
        ]
        for before, after in pairwise(stops):
            self.setTabOrder(before, after)
