"""What a window has from the first moment: commands, forms, docks, messages, log, status."""

from collections.abc import Callable

from PySide6.QtCore import QObject, QSettings
from PySide6.QtWidgets import QMainWindow

from ui.commands.actions import Commands
from ui.document.document import Document
from ui.files.dialogs import FileDialogs
from ui.notices.refused_fields import RefusedFields
from ui.panels.forms import Forms
from ui.run.status import RunStatus
from ui.widgets.log_view import LogView
from ui.widgets.message_bar import MessageBar
from ui.window.workspace import DockWorkspace
from ui.words import later, tr

_COMPILING = later(
    "The run waits for its tracing kernels: they are compiled once after "
    "installing, for about half a minute"
)


class EarlyParts(QObject):
    """Makes what needs no slow library, and puts it into the window."""

    def __init__(self, window: QMainWindow, document: Document, settings: QSettings) -> None:
        super().__init__(window)
        self.document = document
        self.commands = Commands(window)
        self.messages = messages = MessageBar()
        self.log = LogView()
        messages.message.connect(self.log.add)
        self.forms = Forms(document)
        self.forms.message.connect(self.log.add)
        self.forms.file_refused.connect(messages.warn)
        self._refused = RefusedFields(self.forms, messages, self)
        self.workspace = DockWorkspace(window, self.forms, messages, document.undo_stack, self.log)
        self.workspace.name_light(document.session)
        document.session_changed.connect(self.workspace.name_light)
        self.dialogs = FileDialogs(document, settings, window)
        self._bar = window.statusBar()
        self.status = RunStatus(self._bar)

    def begin(self, begin: Callable[[], None]) -> None:
        """Begin a run, unless something that was typed is refused."""
        self.forms.commit()
        if self.forms.refused:
            self._refused.tell()
        else:
            self.messages.make_way()
            begin()

    def show_waiting(self, waiting: bool) -> None:
        """Say why a run shows nothing yet, until it does."""
        if waiting:
            self.log.add(tr(_COMPILING))
            self._bar.showMessage(tr(_COMPILING))
        else:
            self._bar.clearMessage()
