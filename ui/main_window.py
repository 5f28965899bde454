"""The main window: puts document, forms, views and runner together, and nothing else."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QSettings, Qt, Signal
from PySide6.QtGui import (
    QCloseEvent,
    QDragEnterEvent,
    QDragLeaveEvent,
    QDropEvent,
    QKeyEvent,
    QPaintEvent,
)
from PySide6.QtWidgets import QMainWindow

from resources import Example
from ui.background import close_threads
from ui.commands.table import WORKSPACE_CHOICES
from ui.dialogs.help import TITLE, Help
from ui.dialogs.measured import Measured
from ui.dialogs.preferences import PreferencesDialog
from ui.dialogs.start_page import StartPage
from ui.document.document import Document
from ui.files.actions import Answer, FileActions, RecentFiles
from ui.files.dialogs import ChosenFiles
from ui.files.exporter import Exporter, Reporter
from ui.manufacture.cutter import ask_options
from ui.manufacture.plan import PlanDialog
from ui.run.control import NO_LENS, CurrentLens
from ui.window.docks import EarlyParts, PaneFocus
from ui.window.edit_notices import CarriedLens, TargetImage, UnitChange
from ui.window.layouts import Layouts
from ui.window.pages import Pages
from ui.window.window_state import WindowState
from ui.window.workspaces import ViewState, Workspaces
from ui.words import tr
from workbench.files.session import Session

if TYPE_CHECKING:
    from ui.dialogs.sweep import SweepDialog
    from ui.window.loaded_parts import LoadedParts


class MainWindow(QMainWindow):
    """A window of the workbench, with a design of its own.

    It shows at once, with placeholders; `build` adds runner and views, which load slowly.
    """

    painted = Signal()
    built = Signal()
    closed = Signal()
    stayed = Signal()
    new_window_asked = Signal()
    quit_asked = Signal()

    def __init__(self, document: Document, settings: QSettings) -> None:
        super().__init__()
        self.document = document
        document.setParent(self)  # so that it goes after all that listens to it
        self.pages = pages = Pages(self)
        self.early = early = EarlyParts(self, pages.desk, document, settings)
        self.commands, self.messages, self.log = early.commands, early.messages, early.log
        self.forms, self.panes, self.status = early.forms, early.panes, early.status
        self.forms.remember(settings)
        self._carried = CarriedLens(document, self.messages, self)
        self._carried.noted.connect(self.log.add)
        UnitChange(document, self.messages, self)
        self._image = TargetImage(document, self.messages, self)
        steps = document.undo_stack
        steps.forgot.connect(
            lambda count: self.log.add(
                tr("The {count} oldest steps can no longer be undone (memory limit)").format(
                    count=count
                )
            )
        )
        self._settings = settings
        self._recent = recent = RecentFiles(settings)
        self._lens = CurrentLens(document, self)
        self.dialogs = dialogs = early.dialogs
        self._chosen = ChosenFiles(self.forms, dialogs)
        self.files = FileActions(self._lens, recent, dialogs)
        self.files.offer = self._chosen.offer
        self.exporter = Exporter(self._lens, dialogs)
        self.exporter.ask_options = partial(ask_options, self, settings)
        self.reporter = Reporter(self._lens, dialogs)
        self.measured = Measured(dialogs, settings)
        self.sweep: SweepDialog | None = None  # once it was asked for
        self.start_page = StartPage(self.files, recent, self._new, dialogs, settings)
        self._focus = PaneFocus(self.panes, self.commands.toolbar, self)
        self.help = Help(self, self.commands, self.panes.place)
        self.workspaces = Workspaces(pages.desk, self.panes, settings)
        pages.put(self.start_page, self.workspaces, self.commands)
        self._layouts = Layouts(settings, self.commands, self.workspaces, self)
        self._view_state = ViewState(self.commands, self.workspaces, self.log.add)
        self.loaded: LoadedParts | None = None
        self._leaving = False  # whatever would be lost
        self._to_open: Path | None = None  # as soon as the run has ended
        self.closing = False  # as soon as the run has ended
        self.setAcceptDrops(True)
        self._state = WindowState(early, self._lens)
        self._add_menus()
        self._connect()
        early.shelf.follow(self)
        self._show_title()
        self._show_recent()
        self._show_state()

    def build(self) -> None:
        """Add runner and views; imports slow libraries."""
        from ui.window.loaded_parts import LoadedParts

        self.loaded = loaded = LoadedParts(self.early, self._settings, self)
        self._state.loaded = loaded
        loaded.state_changed.connect(self._show_state)
        loaded.state_changed.connect(self._show_recent)
        loaded.state_changed.connect(self._watch_run)
        loaded.check.asked.connect(lambda: self.workspaces.reveal("check", "check"))
        loaded.control.ended.connect(self._end_run)
        self.pages.start_shown.connect(partial(loaded.follow.hold, "start page"))
        loaded.follow.hold("start page", self.pages.at_start)
        self._lens.follow(loaded.control)
        self._carried.followed = loaded.follow.follows
        loaded.follow.message.connect(self._show_following)
        self._view_state.attach(loaded.views.scene)
        self.early.shelf.follow(self)
        self._show_state()
        self.built.emit()

    def start(self) -> None:
        if self.loaded is not None:
            self.early.begin(self.loaded.control.start)

    def discard_and_close(self) -> None:
        """Close without a question; a run and unsaved changes are lost."""
        self._leaving = True
        self.close()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        self.painted.emit()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask before anything is lost; then end thread and plotter."""
        if not self._leaving and not self._may_close():
            event.ignore()
            return
        self.workspaces.keep()
        self.hide()  # threads are waited for, which can take as long as a kernel is compiled
        for dock in self.panes.docks.values():
            dock.hide()  # one that floats does not go with the window
        if self.loaded is not None:
            self.loaded.close()
            self.loaded = self._state.loaded = None  # nothing can be started any more
        close_threads(self)
        super().closeEvent(event)
        self.closed.emit()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        urls = event.mimeData().urls()
        if len(urls) == 1 and urls[0].isLocalFile():
            event.acceptProposedAction()
            self.start_page.await_drop(True)

    def dragLeaveEvent(self, event: QDragLeaveEvent) -> None:
        self.start_page.await_drop(False)

    def dropEvent(self, event: QDropEvent) -> None:
        """Open a design or scene; use a light file as source, any other file as target."""
        event.acceptProposedAction()
        self.start_page.await_drop(False)
        path = Path(event.mimeData().urls()[0].toLocalFile())
        if not self._chosen.take(path):
            self._open(path)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.ActivationChange:
            self._show_recent()
            self._layouts.show()
        if event.type() == QEvent.Type.PaletteChange:
            self.commands.colour_icons()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Revert refused entries, or cancel a check, by Escape."""
        if event.key() != Qt.Key.Key_Escape:
            super().keyPressEvent(event)
        elif not self.forms.revert_all() and self.loaded is not None:
            self.loaded.check.cancel()

    @property
    def _busy(self) -> bool:
        return self.loaded is not None and self.loaded.control.busy

    def _may_close(self) -> bool:
        self.forms.commit()
        if not self._busy:
            return self.files.may_leave()
        called = self.document.session.scene.optic.called
        question = tr(
            "A run of {design} is in progress. Stop it and save the best {optic}?", optic=called
        ).format(design=self.document.name)
        if self.forms.postponed_edits:
            question += tr(" Changes that wait for the end of the run are discarded.")
        answer = self.files.ask(question)
        if answer != Answer.Save:
            return answer == Answer.Discard
        self.forms.drop_postponed_edits()
        if not self._busy:  # it ended while the question stood
            return self.files.save()
        self.closing = True
        assert self.loaded is not None  # or nothing would be under way
        self.loaded.control.runner.stop()
        return False

    def _end_run(self) -> None:
        self.status.settle()
        if self.closing:
            self.closing = False
            if not (self.files.save() and self.close()):
                self.stayed.emit()
            return
        if self.loaded is not None:
            self.loaded.postponed.make()
        path, self._to_open = self._to_open, None
        if path is not None:
            self.files.open(path)

    def _open(self, path: Path) -> None:
        if self._busy:
            text = tr("A run of {design} is in progress. Stop it to open {file}.").format(
                file=path.name, design=self.document.name
            )
            self.messages.note(text, (tr("Stop and open"), partial(self._stop_and_open, path)))
        else:
            self.files.open(path)

    def _stop_and_open(self, path: Path) -> None:
        if self.loaded is not None and self._busy:
            self._to_open = path
            self.loaded.control.runner.stop()
        else:  # it has ended since
            self.files.open(path)

    def focusNextPrevChild(self, next: bool) -> bool:
        """Move the focus by Tab, but not into docks behind others."""
        began = self.focusWidget()
        while moved := super().focusNextPrevChild(next):
            if self.focusWidget() is began or not self.panes.covers(self.focusWidget()):
                break
        return moved

    def _add_menus(self) -> None:
        for dock in self.panes.docks.values():
            self.commands.menus["&View"].addAction(dock.toggleViewAction())
        self.commands.menus["&View"].addAction(self.panes.strip.toggleViewAction())

    def _connect(self) -> None:
        self.commands.connect(
            {
                "new": self.pages.show_start,
                "workspace_start": self.pages.show_start,
                "open": self.files.choose_and_open,
                "save": lambda: self._save(self.files.save),
                "save_as": lambda: self._save(self.files.save_as),
                "export": lambda: self._commit_and(self.exporter.choose_and_export),
                "cut": lambda: self._with_lens(self.exporter.choose_and_cut),
                "plan": lambda: self._with_lens(self._plan),
                "photograph": lambda: self._with_lens(self.measured.choose_photograph),
                "inspect": lambda: self._with_lens(self.measured.choose_surfaces),
                "report": lambda: self._commit_and(self.reporter.choose_and_report),
                "sweep": self._sweep,
                "new_window": self.new_window_asked.emit,
                "close": self.close,
                "quit": self.quit_asked.emit,
                "undo": self._undo,
                "redo": self.document.undo_stack.redo,
                "second_face": self.forms.switch_entrance,
                "picture_aspect": self.forms.adopt_aspect,
                **self._chosen.slots(),
                "revert": self.files.revert,
                "preferences": lambda: PreferencesDialog(self._settings, self).open(),
                "reset_layout": self.workspaces.reset,
                **{
                    command: partial(self.pages.show_desk, name)
                    for command, name in WORKSPACE_CHOICES.items()
                },
                **self._layouts.slots(),
                **self._focus.slots(),
                **self.help.slots(),
            }
        )
        self.start_page.begun.connect(partial(self.help.show_marks_once, self._settings))
        self.messages.message.connect(self.start_page.show_message)
        self._chosen.use_picture, self._chosen.use_light = self._use_picture, self._use_light
        self.pages.start_shown.connect(lambda shown: setattr(self._chosen, "ask", not shown))
        self.workspaces.follow(self.document.session)
        self.document.session_changed.connect(self.workspaces.follow)
        self.document.session_changed.connect(self._show_state)
        self.document.path_changed.connect(self._show_title)
        self.document.path_changed.connect(self._show_state)
        self.document.dirty_changed.connect(self.setWindowModified)
        self.document.dirty_changed.connect(self._show_state)
        self.files.view_data = self._view_state.to_data
        self.files.opened.connect(self._show_opened)
        self.files.opened.connect(self._image.report)
        self.document.undo_stack.indexChanged.connect(self._show_state)
        self.forms.refusals_changed.connect(self._show_state)
        self.files.recent_changed.connect(self._show_recent)
        self.files.saved.connect(self._show_saved)

    def _undo(self) -> None:
        if not self.forms.revert_latest():
            self.document.undo_stack.undo()

    def _use_picture(self, path: Path) -> None:
        (self.start_page.use_picture if self.pages.at_start else self.forms.choose_image)(path)

    def _use_light(self, path: Path) -> None:
        if self.pages.at_start:
            self.pages.show_desk("task")
        self.forms.choose_light(path)

    def _new(self, example: Example) -> None:
        if self.files.new(example) and example.dock:
            self.panes.show(example.dock)

    def _sweep(self) -> None:
        self.forms.commit()
        if self.sweep is None:
            from ui.dialogs.sweep import SweepDialog  # late: it draws with matplotlib

            self.sweep = SweepDialog(self.document, self)
            self.sweep.open_asked.connect(self._open)
            self.early.shelf.follow(self.sweep)
        self.sweep.show_design()

    def _plan(self, session: Session) -> None:
        dialog = PlanDialog(session, self.forms.edit, self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.open()

    def _save(self, save: Callable[[], bool]) -> None:
        self.forms.commit()
        if not save():
            return
        if self.forms.refused:
            self.messages.note(tr("Saved with the last valid value of each marked field."))
        elif self.forms.postponed_edits and self.loaded is not None:
            self.loaded.postponed.remind(tr("Saved with the task of the run."))

    def _show_saved(self, sentence: str) -> None:
        self.log.add(sentence)
        self.status.show_briefly(sentence)

    def _commit_and(self, take: Callable[[], None]) -> None:
        self.forms.commit()
        take()

    def _with_lens(self, use: Callable[[Session], None]) -> None:
        self.forms.commit()
        session = self._lens.session
        if session is None:
            self.messages.note(tr(NO_LENS))
        else:
            use(session)

    def _show_title(self) -> None:
        name = self.document.name.replace("[*]", "[*][*]")  # Qt's mark for what is modified
        self.setWindowTitle(f"{name}[*] - {TITLE}")
        self.setWindowModified(self.document.dirty)

    def _show_recent(self) -> None:
        menu = self.commands.menus["Open &recent"]
        self._recent.fill(menu, self.files.open_recent, allowed=not self._busy)

    def _show_opened(self) -> None:
        session = self.document.session
        if self.pages.at_start or (
            session.heights is not None and self.workspaces.name in ("task", "make")
        ):
            self.pages.show_desk("task" if session.heights is None else "design")
        self._view_state.restore(session.view)

    def _watch_run(self) -> None:
        running = self.loaded is not None and self.loaded.state == "running"
        if running and (self.pages.at_start or self.workspaces.name in ("task", "make")):
            self.pages.show_desk("design")

    # Slots of the window itself: nothing calls them any more while its parts are taken down.
    def _show_state(self) -> None:
        self._state.show()

    def _show_following(self, text: str) -> None:
        self._state.show_following(text)
