"""Frees cyclic garbage in the window's thread alone.

Python frees it in whichever thread allocates at that moment. A worker's thread would then delete
timers and widgets of the window, which Qt forbids: timers no longer fire, or the program crashes.
"""

import gc

from PySide6.QtCore import QObject, QTimer, Slot

_EVERY_MS = 100


class GarbageCollector(QObject):
    """Does what Python does of itself, at the same thresholds, between two events of the window.

    Parameters
    ----------
    parent : QObject
        Lives as long as Qt objects are made.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        gc.disable()
        self._timer = QTimer(self, interval=_EVERY_MS)
        self._timer.timeout.connect(self._collect)
        self._timer.start()

    @Slot()
    def keep_what_is_there(self) -> None:
        """Search no more in what lives for good, once the slow libraries are imported.

        They make 300,000 objects, through which each full search would take 0.2 s.
        """
        gc.collect()
        gc.freeze()

    def close(self) -> None:
        """Leave it to Python again."""
        self._timer.stop()
        gc.enable()

    @Slot()
    def _collect(self) -> None:
        full = [
            generation
            for generation, (count, threshold) in enumerate(
                zip(gc.get_count(), gc.get_threshold(), strict=True)
            )
            if count > threshold
        ]
        if full:
            gc.collect(full[-1])
