"""One piece of work at a time, in a thread of its own."""

import threading
from collections.abc import Callable

from PySide6.QtCore import QObject, Signal, Slot

from workbench.errors import Refused, RunFailed


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

    _ended = Signal(object, str)

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
        """Begin work; none may be under way."""
        assert not self.busy
        self._thread = threading.Thread(target=self._run, args=(work,), name=self._name)
        self._thread.start()

    def close(self) -> None:
        """Wait for the work; nothing is told any more. Safe to call twice."""
        if self._thread is not None:
            self._thread.join()
            self._thread = None

    def _run(self, work: Callable[[], object]) -> None:
        result, sentence = None, ""
        try:
            result = work()
        except (Refused, RunFailed) as error:
            sentence = str(error)
        except Exception as error:
            # A defect has to reach the person instead of ending the thread.
            sentence = f"The {self._name} ended with an unexpected {type(error).__name__}: {error}"
        self._ended.emit(result, sentence)  # queued: the receiver lives in the window's thread

    @Slot(object, str)
    def _end(self, result: object, sentence: str) -> None:
        if self._thread is None:  # closed, with this already under way
            return
        self._thread.join()
        self._thread = None
        if sentence:
            self.failed.emit(sentence)
        else:
            self.done.emit(result)
