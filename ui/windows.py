"""Import of slow libraries and loading of kernels while the window is already shown."""

import importlib
from collections.abc import Iterator
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QPoint, QSettings, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from resources import EXAMPLES
from ui.background import Background, Task
from ui.document.document import Document
from ui.files.recovery import LeftBehind, Recovery, find_left_behind, offer_left_behind
from ui.main_window import MainWindow
from ui.words import later, tr
from workbench.files.session import open_design

# All that the views and the runner stand on, without Qt, which is for the window's thread alone.
_SLOW = ("workbench.pictures.lens", "workbench.pictures.axes", "workbench.design.run")


def warm_up(task: Task) -> None:
    """Import what is slow, in a thread; report that, then load kernels."""
    try:
        for module in _SLOW:
            if not task.stopped:
                importlib.import_module(module)
        from workbench.analysis.kernels import compile_all
    finally:
        task.report(None)
    # From disk in a moment, or anew in half a minute; runs that begin before wait for it.
    compile_all(lambda: not task.stopped)


_STEP = QPoint(32, 32)  # from one window to the next, so that both can be seen


class Windows(QObject):
    """All windows, each with its own document, run and recovery file."""

    loaded = Signal()
    forgotten = Signal()  # once a closed window is gone

    def __init__(self, settings: QSettings, folder: Path) -> None:
        super().__init__()
        self._settings, self._folder = settings, folder
        self._recoveries: dict[MainWindow, Recovery] = {}
        self._loading = Background(later("start"), self)
        self._warm = False  # whether views can be built without holding the windows up
        self._loading.progressed.connect(self.loaded)
        self._loading.failed.connect(self.log)
        self.loaded.connect(self._build_all)
        self._quitting = self._leaving = False

    def open(self, *, at_start: bool = True) -> MainWindow:
        """Show a window, at its start page or with the first example."""
        example = EXAMPLES[0].file
        window = MainWindow(Document(open_design(example), example.stem), self._settings)
        recovery = Recovery(window.document, self._folder, window)
        recovery.view_data = window.files.view_data
        recovery.failed.connect(window.messages.warn)
        window.files.find_other = partial(self._other_with, window)
        window.new_window_asked.connect(self.open_beside)
        window.quit_asked.connect(self.quit)
        window.stayed.connect(self._stay)
        window.closed.connect(partial(self._forget, window))
        window.built.connect(partial(self._follow, window))
        once = Qt.ConnectionType.SingleShotConnection
        window.painted.connect(lambda: QTimer.singleShot(0, window, self._build_if_warm), once)
        self._recoveries[window] = recovery
        if at_start:
            window.pages.show_start()
        window.show()
        return window

    def open_beside(self) -> MainWindow:
        """Show another window, a step away from the one that is active."""
        beside = self.active()
        window = self.open()
        if beside is not None:
            window.move(beside.pos() + _STEP)
        self._recoveries[window].start()
        return window

    def active(self) -> MainWindow | None:
        active = QApplication.activeWindow()
        if isinstance(active, MainWindow) and active in self._recoveries:
            return active
        return next(reversed(self._recoveries), None)

    def warm_up(self) -> None:
        """Load what is slow, then build the views of the windows."""
        self._loading.begin(warm_up)

    def recover(self, window: MainWindow) -> bool:
        """Offer unsaved work, the first in ``window``; whether any was opened."""
        first = self._recoveries[window]
        free = [window]

        def recover(work: LeftBehind) -> bool:
            place = free.pop() if free else self.open_beside()
            opened = place.files.recover(work)
            return opened and self._recoveries[place].keep_now()

        first.start()
        return offer_left_behind(find_left_behind(self._folder), recover, window)

    def open_given(self, path: Path, window: MainWindow, recovered: bool) -> MainWindow | None:
        """Open the file that the program was started with."""
        own = next(self._with(path), None)
        if own is not None:
            own.activateWindow()
            own.messages.note(
                tr("{name} is open with the recovered changes.").format(name=path.name)
            )
            return None
        place = self.open_beside() if recovered else window
        return place if place.files.open(path) else None

    def quit(self) -> None:
        """Close all windows, each with its question; one that stays keeps the rest open."""
        self._quitting = True
        for window in list(self._recoveries):
            if not window.close():
                self._quitting = window.closing  # goes on when its run has ended
                return

    def leave(self) -> None:
        """Close without questions; unsaved work is offered at the next start."""
        self._leaving = True
        for window, recovery in list(self._recoveries.items()):
            recovery.close(leave=True)
            window.discard_and_close()

    def wait(self) -> None:
        """Wait for the present import or compilation: Python may crash if it ends within one."""
        self._loading.close()

    def show_unexpected_error(self, sentence: str, details: str) -> None:
        window = self.active()
        if window is not None:
            copy = partial(QGuiApplication.clipboard().setText, details)
            window.messages.warn(sentence, (tr("Copy details"), copy))
            window.log.add_details(details)

    def log(self, sentence: str) -> None:
        window = self.active()
        if window is not None:
            window.log.add(sentence)

    def log_details(self, text: str) -> None:
        window = self.active()
        if window is not None:
            window.log.add_details(text)

    def _build_all(self) -> None:
        self._warm = True
        for window in self._recoveries:
            if window.loaded is None:
                window.build()

    def _build_if_warm(self) -> None:
        if self._warm:
            self._build_all()

    def _follow(self, window: MainWindow) -> None:
        if window.loaded is not None:
            self._recoveries[window].follow(window.loaded.control)

    def _other_with(self, window: MainWindow, path: Path) -> MainWindow | None:
        return next((other for other in self._with(path) if other is not window), None)

    def _with(self, path: Path) -> Iterator[MainWindow]:
        path = path.resolve()
        for window in self._recoveries:
            own = window.document.path
            if own is not None and own.resolve() == path:
                yield window

    def _forget(self, window: MainWindow) -> None:
        recovery = self._recoveries.pop(window, None)
        if recovery is None or self._leaving:  # a question of the window may still stand
            return
        recovery.close()
        window.destroyed.connect(lambda: QTimer.singleShot(0, self, self.forgotten.emit))
        window.deleteLater()
        if self._quitting and self._recoveries:
            QTimer.singleShot(0, self, self.quit)

    def _stay(self) -> None:
        self._quitting = False
