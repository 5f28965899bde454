"""The main window: puts document, forms, views and runner together, and nothing else."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QSettings, QSize, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QPaintEvent
from PySide6.QtWidgets import QMainWindow, QMessageBox

import workbench
from resources import EXAMPLES, Example
from ui.commands import NEW, RAYS, Commands
from ui.document import ENDING, Document
from ui.exporter import Exporter
from ui.file_actions import Answer, FileActions
from ui.gallery import Gallery
from ui.log_view import LogView
from ui.message_bar import MessageBar
from ui.palette import CommandPalette
from ui.panels.forms import Forms
from ui.recent import RecentFiles
from ui.run_status import RunStatus
from ui.workspace import Workspace

if TYPE_CHECKING:
    from ui.check import Check
    from ui.frame import Frame
    from ui.run_control import RunControl
    from ui.views.derivative_view import DerivativeView
    from ui.views.look_back import LookBack
    from ui.views.scene_view import SceneView

TITLE = "Freeform Lens Workbench"
_SHARE_OF_SCREEN = 0.85
_SIZE = QSize(1280, 800)  # which smaller screens need whole

# Not while a run works on the design as it was when it began.
_CHANGING = [*NEW, "gallery", "open", "save", "save_as"]

_STATES = {
    "loading": "Loading…",
    "idle": "Ready",
    "running": "Designing…",
    "paused": "Paused",
    "stopping": "Stopping…",
}


class MainWindow(QMainWindow):
    """The workbench's only window.

    It shows at once, with placeholders; `build` adds runner and views, whose libraries take
    seconds to load.

    Parameters
    ----------
    document : Document
        The open design; the window owns it from now on.
    settings : QSettings
        Where recent files are kept.
    """

    painted = Signal()
    built = Signal()

    def __init__(self, document: Document, settings: QSettings) -> None:
        super().__init__()
        self.document = document
        document.setParent(self)  # so that it goes after all that listens to it
        self.commands = Commands(self)
        self.messages = MessageBar()
        self.log = LogView()
        self.messages.said.connect(self.log.add)
        self.forms = Forms(document)
        steps = document.undo_stack
        self.workspace = Workspace(self, self.forms, self.messages, steps, self.log)
        self._recent = RecentFiles(settings)
        self.files = FileActions(document, self._recent, self.messages, self)
        self.exporter = Exporter(document, self.messages, self)
        self._status = RunStatus(self.statusBar())
        self.control: RunControl | None = None
        self.check: Check | None = None
        self._scene_view: SceneView | None = None
        self._derivative_view: DerivativeView | None = None
        self._look_back: LookBack | None = None
        self._leaving = False  # whatever would be lost
        self._closing = False  # as soon as the run has ended
        self.setAcceptDrops(True)
        self._add_menus()
        self._connect()
        self._show_title()
        self._show_recent()
        self._show_state()
        room = self.screen().availableSize()
        self.resize((room * _SHARE_OF_SCREEN).expandedTo(_SIZE).boundedTo(room))
        self.workspace.arrange()

    def build(self) -> None:
        """Add runner and views; imports what they stand on."""
        from ui.check import Check
        from ui.run_control import RunControl
        from ui.run_log import RunLog
        from ui.views.derivative_view import DerivativeView
        from ui.views.error_view import ErrorView
        from ui.views.image_link import ImageLink
        from ui.views.irradiance_view import IrradianceView
        from ui.views.light_view import LightView
        from ui.views.look_back import LookBack
        from ui.views.loss_view import LossView
        from ui.views.scene_view import SceneView
        from ui.views.section_view import SectionView
        from ui.views.target_view import TargetView

        link, loss_view, self._look_back = ImageLink(self), LossView(), LookBack()
        loss_view.add_below(self._look_back)
        self._scene_view, self._derivative_view = SceneView(), DerivativeView()
        others = {
            "irradiance": IrradianceView(link),
            "target": TargetView(link),
            "error": ErrorView(link),
            "derivative": self._derivative_view,
            "loss": loss_view,
            "section": SectionView(link),
            "light": LightView(),
        }
        self.workspace.raise_curtain(self._scene_view, others)
        shown = self.workspace.docks["derivative"].visibilityChanged
        shown.connect(self._derivative_view.uncover)
        self._derivative_view.chosen.connect(self._scene_view.mark)
        self._scene_view.picked.connect(self._derivative_view.choose)
        self.control = RunControl(self.document, self)
        RunLog(self.document, self.control, self.log.add)
        runner = self.control.runner
        self.check = Check(self)
        self.check.figures_changed.connect(self._status.show_check)
        self.check.told.connect(self.log.add)
        self.check.failed.connect(self.messages.warn)
        runner.frame_ready.connect(self.check.show_frame)
        runner.unshown.connect(self.check.show_nothing)
        self._look_back.looked.connect(self.check.show_frame)
        for view in (self._scene_view, *others.values()):
            view.show_design(self.document.session)
            self.document.session_changed.connect(view.show_design)
            runner.frame_ready.connect(view.show_frame)
            runner.unshown.connect(view.show_nothing)
            self._look_back.looked.connect(view.show_frame)
        runner.frame_ready.connect(self._show_frame)
        runner.state_changed.connect(self._show_state)
        self._look_back.looked.connect(self._show_frame)
        self._look_back.went_on.connect(
            lambda frame: self._begin(lambda control: control.go_on_from(frame))
        )
        moments = self.control.moments
        moments.changed.connect(lambda: self._look_back.show_frames(moments.frames))
        runner.unshown.connect(self._status.show_nothing)
        runner.failed.connect(self.messages.warn)
        self.control.ended.connect(self._end_run)
        self._show_state()
        self.built.emit()

    def start(self) -> None:
        """Design the lens from its start."""
        self._begin(lambda control: control.start())

    def discard_and_close(self) -> None:
        """Close without a question, a run and unsaved changes lost."""
        self._leaving = True
        self.close()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Tell that the window can be seen."""
        super().paintEvent(event)
        self.painted.emit()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Ask before anything is lost; then end thread and plotter."""
        if not self._leaving and not self._may_close():
            event.ignore()
            return
        if self.control is not None:
            self.control.close()
            self.control = None  # nothing can be started any more
        if self.check is not None:
            self.check.close()
        self.exporter.close()
        if self._scene_view is not None:
            self._scene_view.close_plotter()
        if self._derivative_view is not None:
            self._derivative_view.close_thread()
        super().closeEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """Take one local file."""
        urls = event.mimeData().urls()
        if len(urls) == 1 and urls[0].isLocalFile():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        """A design or scene is opened; any other file becomes the target image."""
        event.acceptProposedAction()
        path = Path(event.mimeData().urls()[0].toLocalFile())
        if self._busy:
            self.messages.note("Stop the run first; then drop the file again.")
        elif path.suffix.lower() in (ENDING, ".json"):
            self.files.open(path)
        else:
            self.forms.choose_image(path)

    def changeEvent(self, event: QEvent) -> None:
        """Light or dark: draw the icons again."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.commands.colour_icons()

    @property
    def _busy(self) -> bool:
        return self.control is not None and self.control.busy

    def _may_close(self) -> bool:
        self.forms.commit()
        if not self._busy:
            return self.files.may_leave()
        name = self.document.name
        answer = self.files.ask(f"{name} is still being designed. Stop, and save its best lens?")
        if answer is not Answer.SAVE:
            return answer is Answer.DISCARD
        if not self._busy:  # it ended while the question stood
            return self.files.save()
        self._closing = True
        self._steer(lambda control: control.runner.stop())
        return False

    def _begin(self, begin: "Callable[[RunControl], None]") -> None:
        self.forms.commit()
        if self.forms.refused:
            self.messages.warn("A marked field is refused; correct it, or press Esc in it, first.")
        else:
            self.messages.clear()
            self._steer(begin)

    def _steer(self, order: "Callable[[RunControl], None]") -> None:
        if self.control is not None:
            order(self.control)

    def _end_run(self) -> None:
        self._status.settle()
        if self._closing:
            self._closing = False
            if self.files.save():
                self.close()

    def _add_menus(self) -> None:
        for dock in self.workspace.docks.values():
            self.commands.menus["&View"].addAction(dock.toggleViewAction())
        self.commands["scene_view"].setChecked(True)
        self.commands["rays_15"].setChecked(True)

    def _connect(self) -> None:
        steer, begin = self._steer, self._begin
        slots: dict[str, Callable[[], object]] = {
            **{name: partial(self._new, example) for name, example in NEW.items()},
            "gallery": self._show_gallery,
            "open": self.files.choose_and_open,
            "save": lambda: self._save(self.files.save),
            "save_as": lambda: self._save(self.files.save_as),
            "export": self._export,
            "quit": self.close,
            "undo": self.document.undo_stack.undo,
            "redo": self.document.undo_stack.redo,
            "start": self.start,
            "continue": lambda: begin(lambda control: control.go_on()),
            "pause": lambda: steer(lambda control: control.toggle_pause()),
            "stop": lambda: steer(lambda control: control.runner.stop()),
            "check": lambda: None if self.check is None else self.check.begin(),
            "fit_view": self._fit_view,
            **{f"{view}_view": partial(self._fit_view, view) for view in ("side", "top", "axis")},
            **{name: partial(self._show_rays, rays) for name, rays in RAYS.items()},
            "palette": lambda: CommandPalette(self.commands.entries(), self).open(),
            "about": self._show_about,
        }
        for name, slot in slots.items():
            self.commands[name].triggered.connect(lambda _, slot=slot: slot())
        self.commands["scene_view"].toggled.connect(self.workspace.show_scene_view)
        self.commands["exploded"].toggled.connect(self._explode)
        self.document.session_changed.connect(self._show_state)
        self.document.path_changed.connect(self._show_title)
        self.document.dirty_changed.connect(self.setWindowModified)
        self.document.undo_stack.indexChanged.connect(self._show_state)
        self.files.recent_changed.connect(self._show_recent)

    def _show_gallery(self) -> None:
        gallery = Gallery(EXAMPLES, self)
        gallery.chosen.connect(self._new)
        gallery.open()

    def _new(self, example: Example) -> None:
        if self.files.new(example) and example.dock:
            dock = self.workspace.docks[example.dock]
            dock.show()
            dock.raise_()

    def _save(self, save: Callable[[], bool]) -> None:
        self.forms.commit()
        if save() and self.forms.refused:
            self.messages.note("Saved with the last valid value of each marked field.")

    def _export(self) -> None:
        self.forms.commit()
        self.exporter.choose_and_export()

    def _show_title(self) -> None:
        self.setWindowTitle(f"{self.document.name}[*] - {TITLE}")
        self.setWindowModified(self.document.dirty)

    def _show_recent(self) -> None:
        menu = self.commands.menus["Open &recent"]
        menu.clear()
        for path in self._recent.paths():
            menu.addAction(str(path).replace("&", "&&"), partial(self.files.open_recent, path))
        menu.setEnabled(not menu.isEmpty())

    def _show_frame(self, frame: "Frame") -> None:
        self._status.show_snapshot(frame.snapshot, self._busy)

    def _show_state(self) -> None:
        """What can be done depends on the run, on the result and on the undo stack."""
        state = "loading" if self.control is None else self.control.runner.state
        idle, running = state == "idle", state in ("running", "paused")
        stack, commands = self.document.undo_stack, self.commands
        editable = not (running or state == "stopping")
        self.forms.set_running(not editable)
        commands.enable(_CHANGING, editable)
        commands["start"].setEnabled(idle)
        designed = self.document.session.result is not None
        commands["continue"].setEnabled(idle and designed)
        commands["export"].setEnabled(designed)
        commands.enable(["exploded", *RAYS], state != "loading")
        commands["check"].setEnabled(state in ("idle", "paused"))
        commands["pause"].setEnabled(running)
        commands["stop"].setEnabled(running)
        commands["undo"].setEnabled(editable and stack.canUndo())
        commands["redo"].setEnabled(editable and stack.canRedo())
        commands["undo"].setText(f"&Undo {stack.undoText()}")
        commands["redo"].setText(f"&Redo {stack.redoText()}")
        commands["pause"].setChecked(state == "paused")
        self.workspace.history.setEnabled(editable)
        if self._look_back is not None:
            self._look_back.allow(look=state in ("idle", "paused"), go_on=idle)
        self._status.show_state(_STATES[state])

    def _fit_view(self, view: str = "") -> None:
        if self._scene_view is not None:
            self._scene_view.fit(view)

    def _explode(self, exploded: bool) -> None:
        if self._scene_view is not None:
            self._scene_view.explode(exploded)

    def _show_rays(self, rays: int) -> None:
        if self._scene_view is not None:
            self._scene_view.show_rays(rays)

    def _show_about(self) -> None:
        QMessageBox.about(
            self,
            f"About {TITLE}",
            f"<h3>{TITLE} {workbench.__version__}</h3><p>Shapes a freeform lens until it throws "
            "the wanted image of light.</p><p>MIT licence</p>",
        )
