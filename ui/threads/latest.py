"""Answers to the latest question in a thread; another one, or none any more, ends it soon."""

from collections.abc import Callable
from threading import Event

from PySide6.QtCore import QObject, Signal

from ui.threads.background import Background

Work = Callable[[Event], object]


class Latest(QObject):
    """One question at a time; only the answer to the latest is told.

    Parameters
    ----------
    name : str
        What the work is; see `Background`.

    Attributes
    ----------
    answered : Signal(object, object)
        The question, and what the work on it returned.
    failed : Signal(object, str)
        The question, and why there is no answer.
    """

    answered = Signal(object, object)
    failed = Signal(object, str)

    def __init__(self, name: str, parent: QObject) -> None:
        super().__init__(parent)
        self._wanted: tuple[object, Work] | None = None
        self._begun: tuple[object, Work] | None = None  # in the thread
        self._left = Event()
        self._background = Background(name, self)
        self._background.done.connect(self._take)
        self._background.failed.connect(self._give_up)

    @property
    def busy(self) -> bool:
        """Whether an answer is still to come."""
        return self._wanted is not None

    def ask(self, question: object, work: Work) -> None:
        """Answer this instead of what was asked before.

        Parameters
        ----------
        question : object
            What the answer will be told with.
        work : callable
            Finds it, in the thread; the event that it gets says when nobody wants it any more.
        """
        self.forget()
        self._wanted = question, work
        self._next()

    def wants(self, question: object) -> bool:
        """Whether this is the question whose answer is still to come."""
        return self._wanted is not None and self._wanted[0] is question

    def forget(self) -> None:
        """Tell nothing more of what is under way."""
        self._wanted = None
        self._left.set()

    def close(self) -> None:
        """Leave what is under way and wait for the thread; safe to call twice."""
        self.forget()
        self._background.close()

    def _next(self) -> None:
        if self._wanted is None or self._background.busy:
            return
        self._begun, self._left = self._wanted, Event()
        (_, work), left = self._begun, self._left
        self._background.begin(lambda: work(left))

    def _take(self, answer: object) -> None:
        if (question := self._ended()) is not None:
            self.answered.emit(question, answer)

    def _give_up(self, sentence: str) -> None:
        if (question := self._ended()) is not None:
            self.failed.emit(question, sentence)

    def _ended(self) -> object | None:
        """The question whose work has ended, if it is still the latest; else the next begins."""
        if self._begun is None or self._begun is not self._wanted:
            self._next()
            return None
        self._wanted = None
        return self._begun[0]
