"""Imports the slow libraries while the window is already there."""

import importlib
import threading

from PySide6.QtCore import QObject, Signal

# All that the views and the runner stand on, without Qt, which is for the window's thread alone.
_SLOW = ("workbench.pictures.lens", "workbench.pictures.style", "workbench.design.run")


class WarmUp(QObject):
    """Imports in a thread of its own; a library that fails is reported when it is really needed."""

    done = Signal()

    def start(self) -> None:
        """Begin importing."""
        threading.Thread(target=self._run, name="warm-up", daemon=True).start()

    def _run(self) -> None:
        try:
            for module in _SLOW:
                importlib.import_module(module)
        finally:
            self.done.emit()  # queued: the receiver lives in the window's thread
