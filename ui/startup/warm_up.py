"""Imports the slow libraries, and gets the kernels ready, while the window is already there."""

import importlib
import threading

from PySide6.QtCore import QObject, Signal

# All that the views and the runner stand on, without Qt, which is for the window's thread alone.
_SLOW = ("workbench.pictures.lens", "workbench.pictures.style", "workbench.design.run")


class WarmUp(QObject):
    """Imports in a thread of its own; a library that fails is reported when it is really needed."""

    done = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, name="warm-up")

    def start(self) -> None:
        """Begin importing."""
        self._thread.start()

    def wait(self) -> None:
        """Let the imports end; a process that ends in the midst of one may crash."""
        self._ending.set()
        if self._thread.ident is not None:
            self._thread.join()

    def _run(self) -> None:
        try:
            for module in _SLOW:
                importlib.import_module(module)
            from workbench.analysis.kernels import compile_all
        finally:
            self.done.emit()  # queued: the receiver lives in the window's thread
        # From disk in a moment, or anew in half a minute; runs that begin before wait for it.
        compile_all(lambda: not self._ending.is_set())
