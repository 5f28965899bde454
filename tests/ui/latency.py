"""How long the event loop is held up."""

import time

import numpy as np
from PySide6.QtCore import Qt, QTimer


class LatencyProbe:
    """A 5 ms timer that notes how long the event loop lets it wait."""

    def __init__(self):
        self._last = None
        self.gaps_ms = []
        self._timer = QTimer(interval=5, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)

    def start(self):
        self._last = None
        self._timer.start()

    def stop(self):
        self._timer.stop()

    def report(self, name):
        gaps = np.array(self.gaps_ms)
        p95, most = np.quantile(gaps, 0.95), gaps.max()
        return f"{name}: p95 {p95:.1f} ms, max {most:.0f} ms over {gaps.size} ticks"

    def _tick(self):
        now = time.perf_counter()
        if self._last is not None:
            self.gaps_ms.append(1000 * (now - self._last))
        self._last = now
