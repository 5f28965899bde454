"""Frees cyclic garbage in the window's thread alone.

Python frees it in whichever thread allocates at that moment. A worker's thread would then delete
timers and widgets of the window, which Qt forbids: timers no longer fire, or the program crashes.
"""

import gc

from PySide6.QtCore import QObject, QTimerEvent

_EVERY_MS = 100


class GarbageCollector(QObject):
    """Collects cyclic garbage between events of the window, at Python's thresholds.

    Python collects in whichever thread allocates. A worker's thread would then delete timers and
    widgets of the window, which Qt forbids: timers stop, or the program crashes.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = self.startTimer(_EVERY_MS)

    def timerEvent(self, event: QTimerEvent) -> None:  # noqa: D102
        counts = zip(gc.get_count(), gc.get_threshold(), strict=True)
        full = [generation for generation, (count, most) in enumerate(counts) if count > most]
        if full:
            gc.collect(full[-1])

    def close(self) -> None:
        """Return the collection to Python."""
        self.killTimer(self._timer)
        gc.enable()
