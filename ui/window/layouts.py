"""Arrangements of the docks that a person saved under names."""

import json
from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSettings
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QInputDialog, QWidget

from ui.commands.actions import Commands
from ui.window.workspaces import CUSTOM, Workspaces
from ui.words import tr

_KEY = "window/layouts"


class Layouts:
    """Saves arrangements in the settings, and offers them in the menu of their commands."""

    def __init__(
        self, settings: QSettings, commands: Commands, workspaces: Workspaces, window: QWidget
    ) -> None:
        self._settings, self._workspaces, self._window = settings, workspaces, window
        self._menu = commands.menus["Lay&outs"]
        self._custom, self._delete = commands["workspace_custom"], commands["delete_layout"]
        self._shown: list[QAction] = []

    def slots(self) -> dict[str, Callable[[], object]]:
        return {"save_layout": self._ask_to_save, "delete_layout": self._ask_to_delete}

    def show(self) -> None:
        """Offer the layouts, some of which may come from another window."""
        for action in self._shown:
            self._menu.removeAction(action)
        self._shown = [
            self._menu.addAction(name.replace("&", "&&"), partial(self._choose, name))
            for name in self._kept
        ]
        self._delete.setEnabled(bool(self._shown))

    @property
    def _kept(self) -> dict[str, str]:
        kept = json.loads(str(self._settings.value(_KEY, "{}")))
        return dict(sorted(kept.items()))

    def _choose(self, name: str) -> None:
        self._custom.trigger()
        self._workspaces.restore(CUSTOM, self._kept[name])

    def _ask_to_save(self) -> None:
        layout, kept = self._workspaces.to_text(), self._kept
        name = self._ask(tr("Save layout"), tr("Name; an existing one is replaced"), editable=True)
        if name:
            self._store({**kept, name: layout})

    def _ask_to_delete(self) -> None:
        name = self._ask(tr("Delete layout"), tr("Layout"), editable=False)
        self._store({each: layout for each, layout in self._kept.items() if each != name})

    def _ask(self, title: str, label: str, *, editable: bool) -> str:
        name, accepted = QInputDialog.getItem(
            self._window, title, label, [*self._kept], editable=editable
        )
        return name.strip() if accepted else ""

    def _store(self, layouts: dict[str, str]) -> None:
        self._settings.setValue(_KEY, json.dumps(layouts))
        self.show()
