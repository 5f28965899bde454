"""Commands of the help menu."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QSettings
from PySide6.QtWidgets import QMainWindow, QMessageBox, QWidget

import workbench
from ui.commands.actions import Commands
from ui.commands.palette import CommandPalette
from ui.commands.pane_focus import PaneFocus
from ui.commands.shortcuts import Shortcuts
from ui.help.manual import Manual
from ui.help.tour import STOPS, Tour
from ui.widgets.message_bar import MessageBar
from ui.words import tr

TITLE = "Freeform Lens Workbench"
_OFFERED = "tour_offered"


class Help(QObject):
    """Functions of the help menu."""

    def __init__(
        self, window: QMainWindow, commands: Commands, panes: PaneFocus, messages: MessageBar
    ) -> None:
        super().__init__(window)
        self._window, self._commands, self._panes = window, commands, panes
        self._messages = messages
        self._tour: Tour | None = None

    def slots(self) -> dict[str, Callable[[], object]]:
        """Functions of commands."""
        return {
            "palette": lambda: CommandPalette(self._commands.entries(), self._window).open(),
            "shortcuts": lambda: Shortcuts(self._commands.entries(), self._window).show(),
            "tour": self.begin_tour,
            "manual": lambda: Manual(self._window).show(),
            "about": self._show_about,
        }

    def offer_tour(self, settings: QSettings) -> None:
        """Offer the tour at the first start."""
        if not settings.value(_OFFERED):
            settings.setValue(_OFFERED, True)
            self._messages.note(
                tr(
                    "New here? A tour of {count} steps shows what is where. Help > Tour "
                    "begins it at any time."
                ).format(count=len(STOPS)),
                (tr("Show me around"), self.begin_tour),
            )

    def begin_tour(self) -> None:
        """Begin the tour, unless it is running."""
        if self._tour is None:
            self._messages.clear()
            self._tour = Tour(self._window, self._place, self._panes.show, self._hide)
            self._tour.ended.connect(self._forget_tour)

    def _place(self, name: str) -> QWidget:
        if name == "menus":
            return self._window.menuBar()
        return self._commands.toolbar if name == "toolbar" else self._panes.place(name)

    def _hide(self, name: str) -> None:
        self._panes.place(name).hide()

    def _forget_tour(self) -> None:
        self._tour = None

    def _show_about(self) -> None:
        QMessageBox.about(
            self._window,
            tr("About {title}").format(title=TITLE),
            tr(
                "<h3>{title} {version}</h3><p>Shapes a freeform lens until it throws the "
                "wanted image of light.</p><p>MIT licence</p>"
            ).format(title=TITLE, version=workbench.__version__),
        )
