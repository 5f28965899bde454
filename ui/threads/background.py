"""One piece of work at a time, in a thread of its own."""

import threading
from collections.abc import Callable

from PySide6.QtCore import QObject, Signal, Slot

from ui.threads.failure import sentence_of


class Background(QObject):
    """Does work that would hold the window up.

    Parameters
    ----------
    name : str
        What the work is, for the thread and for the sentence of an unexpected failure.

    Attributes
    ----------
    done : Signal(object)
        What the work returned.
    failed : Signal(str)
        Why it came to nothing, in one sentence.
    """

    done = Signal(object)
    failed = Signal(str)

    _ended = Signal(object, object)

    def __init__(self, name: str, parent: QObject) -> None:
        super().__init__(parent)
        self._name = name
        self._thread: threading.Thread | None = None
        self._ended.connect(self._end)

    @property
    def busy(self) -> bool:
        """Whether work has begun whose end has not been told."""
        return self._thread is not None

    def begin(self, work: Callable[[], object]) -> None:
        """Begin work.

        Raises
        ------
        RuntimeError
            If other work is under way.
        """
        if self.busy:
            raise RuntimeError(f"the {self._name} is under way already")
        self._thread = threading.Thread(target=self._run, args=(work,), name=self._name)
        self._thread.start()

    def close(self) -> None:
        """Wait for the work; nothing is told any more. Safe to call twice."""
        if self._thread is not None:
            self._thread.join()
            self._thread = None

    def _run(self, work: Callable[[], object]) -> None:
        try:
            result = work()
        except Exception as error:  # of any kind: it has to reach the person
            self._ended.emit(None, error)  # queued: the receiver lives in the window's thread
        else:
            self._ended.emit(result, None)

    @Slot(object, object)
    def _end(self, result: object, error: Exception | None) -> None:
        if self._thread is None:  # closed, with this already under way
            return
        self._thread.join()
        self._thread = None
        if error is not None:
            self.failed.emit(sentence_of(error, self._name))
        else:
            self.done.emit(result)
