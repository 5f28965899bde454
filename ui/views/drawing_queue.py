"""Whose turn it is to draw.

1. Two views that draw in one turn of the event loop hold the window up twice as long. Here one
   draws at a time, and the loop runs in between.
2. What a view costs depends on the machine, most of all in software OpenGL. It is measured around
   a synchronous repaint, and after each drawing everything rests for a multiple of its time: slow
   machines show fewer pictures instead of a window that does not answer. While somebody drags
   something and looks what becomes of it, the pictures are the answer: then nothing rests.
"""

from collections import OrderedDict
from time import perf_counter
from typing import Protocol

from PySide6.QtCore import QObject, QTimer

from ui.widgets.application import application

_REST = 2.0  # seconds of rest for each second of drawing
_LONGEST = 1.0  # seconds; the first drawing also loads what is drawn with


class Drawer(Protocol):
    """Something that draws in its turn."""

    def draw_now(self) -> None:
        """Draw now, if needed and visible."""


class DrawingQueue(QObject):
    """Queue of views that wait for drawing."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._waiting: OrderedDict[int, Drawer] = OrderedDict()
        self._rested_at = 0.0
        self._hurried = self._drawn = False
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self._next)

    def ask(self, drawer: Drawer) -> None:
        """Enqueue a view once."""
        self._waiting.setdefault(id(drawer), drawer)
        self._wait()

    def leave(self, drawer: Drawer) -> None:
        """Remove a view."""
        self._waiting.pop(id(drawer), None)
        if not self._waiting:
            self._timer.stop()

    def may_draw(self, drawer: Drawer) -> bool:
        """Whether a view may draw at once, or waits for others in this turn of the loop."""
        if self._drawn:
            self.ask(drawer)
            return False
        self._drawn = True
        QTimer.singleShot(0, self, self._end_turn)
        return True

    def hurry(self, hurried: bool) -> None:
        """Draw without pauses, or with pauses again."""
        self._hurried = hurried

    def _end_turn(self) -> None:
        self._drawn = False

    def _next(self) -> None:
        _, drawer = self._waiting.popitem(last=False)
        began = perf_counter()
        try:
            drawer.draw_now()
        finally:  # whoever fails to draw must not keep the others from it
            ended = perf_counter()
            rest = 0.0 if self._hurried else _REST
            self._rested_at = ended + min(rest * (ended - began), _LONGEST)
            if self._waiting:
                self._wait()

    def _wait(self) -> None:
        if not self._timer.isActive():
            self._timer.start(max(0, round(1000 * (self._rested_at - perf_counter()))))


def drawing_queue() -> DrawingQueue:
    """The application's queue."""
    owner = application()
    return owner.findChild(DrawingQueue) or DrawingQueue(owner)
