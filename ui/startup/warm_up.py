"""Import of slow libraries and loading of kernels while the window is already shown."""

import importlib

from PySide6.QtCore import QObject, Signal

from ui.threads.background import Background, Task
from ui.threads.failure import sentence_of
from ui.words import tr

# All that the views and the runner stand on, without Qt, which is for the window's thread alone.
_SLOW = ("workbench.pictures.lens", "workbench.pictures.axes", "workbench.design.run")


class WarmUp(QObject):
    """Imports in another thread."""

    imported = Signal()
    failed = Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self._background = Background("warm-up", self)
        self._background.progressed.connect(self.imported)
        self._background.failed.connect(
            lambda _, error: self.failed.emit(sentence_of(error, tr("start")))
        )

    def start(self) -> None:
        """Begin importing."""
        self._background.begin(_warm_up)

    @property
    def under_way(self) -> bool:
        """Whether it has begun and not ended."""
        return self._background.running

    def wait(self) -> None:
        """Wait for the imports; exiting during an import may crash."""
        self._background.close()


def _warm_up(task: Task) -> None:
    try:
        for module in _SLOW:
            importlib.import_module(module)
        from workbench.analysis.kernels import compile_all
    finally:
        task.report(None)
    # From disk in a moment, or anew in half a minute; runs that begin before wait for it.
    compile_all(lambda: not task.stopped)
