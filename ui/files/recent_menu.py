"""The menu of the files that were open last."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtWidgets import QMenu

from ui.files.recent import RecentFiles


class RecentMenu:
    """Has an action for each file.

    Parameters
    ----------
    menu : QMenu
        Gets them.
    recent : RecentFiles
        The files.
    open_file : callable
        Opens one of them.
    """

    def __init__(
        self, menu: QMenu, recent: RecentFiles, open_file: Callable[[Path], object]
    ) -> None:
        self._menu, self._recent, self._open_file = menu, recent, open_file
        self._shown: list[Path] = []

    def show(self, allowed: bool) -> None:
        """Name the files of now; whether they may be opened."""
        paths = self._recent.paths()
        if paths != self._shown:
            self._shown = paths
            self._menu.clear()
            for number, path in enumerate(paths, 1):
                text = f"&{number % 10} " + str(path).replace("&", "&&")  # a digit opens it
                self._menu.addAction(text, partial(self._open_file, path))
        for action in self._menu.actions():
            action.setEnabled(allowed)  # also in the palette, which asks no menu
        self._menu.setEnabled(allowed and bool(paths))
