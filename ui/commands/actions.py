"""Commands of the table as actions, in menus and toolbar, and choices kept in the settings."""

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QHBoxLayout, QMainWindow, QMenu, QMenuBar, QToolButton, QWidget

from ui.commands.command_search import SEPARATOR
from ui.commands.panes import PANES
from ui.commands.table import CHOICES, COMMANDS, LOCKS, TOOLS, VIEWS, WORKSPACE_CHOICES, Command
from ui.commands.toolbar import Toolbar
from ui.widgets import theme
from ui.words import tr


def _listed(*entries: Any) -> list[Any]:
    """Entries of a menu: names from lines, in which | is a separator, and menus as they are."""
    lines = (entry.split() if isinstance(entry, str) else [entry] for entry in entries)
    return [None if each == "|" else each for line in lines for each in line]


_RUN = "start continue pause stop"
_TOOLS, _LOCKS, _VIEWS = " ".join(TOOLS), " ".join(LOCKS), " ".join(f"{v}_view" for v in VIEWS)

# Menus by name; None is a separator, a tuple a menu within. The window adds recent files, saved
# layouts and docks.
MENUS: dict[str, list[Any]] = {
    "&File": _listed(
        "new new_window open",
        ("Open &recent", []),
        "| save save_as revert | export plan cut report photograph inspect | close quit",
    ),
    "&Edit": _listed("undo redo | paste_picture | copy_plot save_plot | preferences"),
    "&Design": _listed(
        f"{_TOOLS} | mark_region | picture_aspect second_face other_face |",
        f"brush_larger brush_smaller | {_LOCKS} | check",
    ),
    "&Run": _listed(f"{_RUN} | follow sweep | save_video restore_run compare_runs delete_run"),
    "&View": _listed(
        f"fit_view {_VIEWS} | exploded perspective",
        ("&Rays", [*CHOICES["rays"], None, *CHOICES["by_weight"]]),
        ("F&aces", [*CHOICES["faces"], None, "relief"]),
        "save_scene copy_scene",
        ("&Colours of light", [*CHOICES["colours"]]),
        "|",
        ("&Workspace", ["workspace_start", *WORKSPACE_CHOICES]),
        ("&Go to", [*(f"go_{name}" for name in PANES), None, "next_pane", "previous_pane"]),
        ("Lay&outs", ["save_layout", "delete_layout", None]),
        "reset_layout |",
    ),
    "&Help": _listed("tour manual shortcuts palette | about"),
}
SCENE_MENU = _listed(
    "fit_view lens_view screen_view | &Rays F&aces exploded perspective |",
    f"{_TOOLS} | copy_scene",
)
"""Names, separators and menus of the 3D view."""
_FILES, _STEPS, _LOOKS = "new open save export", "undo redo", "mark_region fit_view"
TOOLBAR = [*map(str.split, (_FILES, _STEPS, f"{_RUN} follow", _TOOLS, _LOOKS))]
"""Groups of the toolbar."""
NAMED_FIRST = [*map(str.split, (_RUN, "follow", _TOOLS, _LOOKS, _FILES, _STEPS))]
"""Groups whose names stand beside their icons, as many as the width holds."""
_ONE_OF = [*map(list, CHOICES.values()), list(TOOLS), ["workspace_start", *WORKSPACE_CHOICES]]
LOOK = ["exploded", "perspective", "relief", *(name for of in CHOICES.values() for name in of)]
"""Those whose state is part of how a design is looked at, and travels with it."""


class Commands:
    """Actions by the names of their commands; disabled until they are connected."""

    def __init__(self, window: QMainWindow) -> None:
        self._window = window
        self._called = "lens"
        self._actions = {name: self._action(self.command(name)) for name in COMMANDS}
        self._connected: set[str] = set()
        for names in _ONE_OF:
            one_of = QActionGroup(window)
            for name in names:
                one_of.addAction(self[name])
        faces = self["faces_material"].actionGroup()  # a second click leads back to the material
        faces.setExclusionPolicy(QActionGroup.ExclusionPolicy.ExclusiveOptional)
        faces.triggered.connect(self._show_faces)
        self["faces_by_limits"].setIconText(tr("Limits in 3D"))
        self.menus: dict[str, QMenu] = {}
        for title, entries in MENUS.items():
            self._fill(window.menuBar(), title, entries)
        self.scene_menu = QMenu(window)
        for each in SCENE_MENU:
            if each is None:
                self.scene_menu.addSeparator()
            elif each in self.menus:
                self.scene_menu.addMenu(self.menus[each])
            else:
                self.scene_menu.addAction(self[each])
        for name in _STEPS.split():  # without the step itself, whose name may be long
            self[name].setIconText(self[name].iconText())
        groups, named = (
            [[self[name] for name in group] for group in which] for which in (TOOLBAR, NAMED_FIRST)
        )
        self.toolbar = Toolbar(window, groups, named)
        window.addToolBar(self.toolbar)
        window.menuBar().setCornerWidget(self._workspaces(), Qt.Corner.TopRightCorner)
        self.colour_icons()

    def __getitem__(self, name: str) -> QAction:
        return self._actions[name]

    def command(self, name: str) -> Command:
        """Return a command with its texts for the element of the design."""
        return COMMANDS[name].in_words(self._called)

    def name_optic(self, called: str) -> None:
        if called == self._called:
            return
        self._called = called
        for name, command in COMMANDS.items():
            if command.names_optic:
                action, words = self[name], self.command(name)
                action.setText(words.text)
                action.setToolTip(_tip(action, words))
                action.setStatusTip(words.tip)

    def connect(self, slots: Mapping[str, Callable[[], object]]) -> None:
        for name, slot in slots.items():
            self[name].triggered.connect(lambda _, slot=slot: slot())
        self._open(slots.keys())

    def connect_toggles(self, slots: Mapping[str, Callable[[bool], object]]) -> None:
        for name, slot in slots.items():
            self[name].toggled.connect(slot)
        self._open(slots.keys())

    def connect_choices(self, slots: Mapping[str, Callable[[], object]]) -> None:
        """Connect each choice to a function, and call the functions of checked commands."""
        for name, slot in slots.items():
            self[name].toggled.connect(lambda on, slot=slot: slot() if on else None)
            if self[name].isChecked():
                slot()
        self._open(slots.keys())

    def allow(self, allowed: Mapping[str, bool]) -> None:
        for name, allow in allowed.items():
            self[name].setEnabled(allow and name in self._connected)

    def explain(self, sentences: Mapping[str, str]) -> None:
        """Add a sentence to tips, such as why a command is disabled."""
        for name, sentence in sentences.items():
            tip = _tip(self[name], self.command(name))
            self[name].setToolTip(f"{tip}\n{sentence}" if sentence else tip)

    def reword(self, texts: Mapping[str, str]) -> None:
        for name, text in texts.items():
            self[name].setText(text)
        self.toolbar.follow_texts()

    def entries(self) -> list[tuple[str, QAction]]:
        bar = self._window.menuBar()
        return [entry for action in bar.actions() for entry in _entries(action, "")]

    def colour_icons(self) -> None:
        for name, command in COMMANDS.items():
            if command.icon:
                self[name].setIcon(theme.icon(command.icon, self._window.palette()))

    def _show_faces(self, chosen: QAction) -> None:
        if not chosen.isChecked():
            self["faces_material"].setChecked(True)

    def _workspaces(self) -> QWidget:
        bar = QWidget(self._window.menuBar())
        row = QHBoxLayout(bar)
        row.setContentsMargins(0, 0, 0, 0)
        for number, name in enumerate(("workspace_start", *WORKSPACE_CHOICES)):
            if number:
                self[name].setIconText(f"{number} {self[name].text()}")
            button = QToolButton()
            button.setAutoRaise(True)
            button.setDefaultAction(self[name])
            row.addWidget(button)
        return bar

    def _open(self, names: Iterable[str]) -> None:
        self._connected.update(names)
        self.allow(dict.fromkeys(names, True))

    def _action(self, command: Command) -> QAction:
        action = QAction(command.text, self._window)
        action.setEnabled(False)
        if command.checked is not None:
            action.setCheckable(True)
            action.setChecked(command.checked)
        action.setShortcut(QKeySequence(command.shortcut))
        action.setToolTip(_tip(action, command))
        action.setStatusTip(command.tip)
        self._window.addAction(action)
        return action

    def _fill(self, place: QMenuBar | QMenu, title: str, entries: list[Any]) -> None:
        menu = QMenu(tr(title), self._window)
        menu.setToolTipsVisible(True)
        place.addMenu(menu)
        self.menus[title] = menu
        for entry in entries:
            if entry is None:
                menu.addSeparator()
            elif isinstance(entry, tuple):
                self._fill(menu, *entry)
            else:
                menu.addAction(self[entry])


def _tip(action: QAction, command: Command) -> str:
    keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
    return f"{command.tip} ({keys})" if keys else command.tip


def _entries(action: QAction, before: str) -> list[tuple[str, QAction]]:
    name = before + action.text().replace("&", "").rstrip("…")
    menu = action.menu()
    if isinstance(menu, QMenu):
        return [e for each in menu.actions() for e in _entries(each, name + SEPARATOR)]
    return [] if action.isSeparator() else [(name, action)]


_COLOURS_KEY = "view/colours"


def keep_colours(settings: QSettings, commands: Commands) -> None:
    """Restore the stored colours of light, and store choices of the user, not those of a design."""
    kept = settings.value(_COLOURS_KEY)
    for command, name in CHOICES["colours"].items():
        if name == kept:
            commands[command].setChecked(True)
        commands[command].triggered.connect(
            lambda _, name=name: settings.setValue(_COLOURS_KEY, name)
        )
