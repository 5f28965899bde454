"""Steps of a design that can be undone, as many as memory holds."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass

import numpy as np
from PySide6.QtCore import QObject, QSignalBlocker, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from workbench.files.session import Session


def blocks(value: object) -> Iterator[tuple[int, int]]:
    """Identity and size of each array and file in nested values; some may come more than once."""
    if isinstance(value, np.ndarray):
        yield id(value), value.nbytes
    elif isinstance(value, bytes):
        yield id(value), len(value)
    elif isinstance(value, tuple):
        for each in value:
            yield from blocks(each)
    elif isinstance(value, Mapping):
        yield from blocks((*value.values(),))
    elif is_dataclass(value):
        for field in fields(value):
            yield from blocks(getattr(value, field.name))


def distinct_bytes(*values: object) -> int:
    """Bytes of all arrays and files in some values, each counted once."""
    return sum(dict(blocks(values)).values())


Show = Callable[[Session], None]

_BUDGET = 64 << 20  # bytes
_SMALL = 16 << 10  # bytes of a step without arrays of its own: scene, text, Qt's part


class UndoSteps(QUndoStack):
    """The undo stack of a document.

    Sessions share arrays: a step costs what the session before it holds alone. The oldest steps are
    dropped when all together exceed the budget.
    """

    forgot = Signal(int)

    def __init__(self, show: Show, parent: QObject, budget: int = _BUDGET) -> None:
        super().__init__(parent)
        self._go_to, self._budget = show, budget

    @property
    def cost(self) -> int:
        return sum(step.cost for step in self._all())

    def take(
        self,
        before: Session,
        after: Session,
        text: str,
        key: str = "",
        exchange: Callable[[], None] | None = None,
    ) -> None:
        self.push(_Step(self._go_to, before, after, text, key, exchange))
        self._forget_oldest()

    def amend(self, after: Session) -> None:
        """Replace the session that the last step leads to, if there is a step."""
        if not self.canUndo():
            return
        self._all()[self.index() - 1].lead_to(after)
        if self.isClean():
            self.resetClean()
        self._forget_oldest()

    def seal(self) -> None:
        """Keep later steps separate from the last one."""
        if self.canUndo():
            self._all()[self.index() - 1].key = ""

    def origin(self, key: str) -> Session | None:
        """Return the session before the step that one with this key would be merged with."""
        if not key or self.isClean() or not self.canUndo():
            return None
        last = self._all()[self.index() - 1]
        return last.before if last.key == key else None

    def _all(self) -> "list[_Step]":
        steps = [self.command(number) for number in range(self.count())]
        return [step for step in steps if isinstance(step, _Step)]

    def _forget_oldest(self) -> None:
        steps = self._all()
        over, forgotten = self.cost - self._budget, 0
        while over > 0 and forgotten < len(steps) - 1:  # the last one can always be taken back
            over -= steps[forgotten].cost
            forgotten += 1
        if not forgotten:
            return
        # A stack forgets all or nothing by itself; what is kept is put on an empty one.
        kept = [step.again() for step in steps[forgotten:-1]]
        last = steps[-1].again(steps[-1].key)
        clean = self.cleanIndex() - forgotten
        with QSignalBlocker(self):
            self.clear()
            if clean != 0:
                self.resetClean()
            for number, step in enumerate(kept, 1):
                self.push(step)
                if number == clean:
                    self.setClean()
        self.push(last)
        self.forgot.emit(forgotten)


class _Step(QUndoCommand):
    _MERGING = 1  # Qt offers only commands of the same id to each other

    def __init__(
        self,
        show: Show,
        before: Session,
        after: Session,
        text: str,
        key: str,
        exchange: Callable[[], None] | None,
        done: bool = False,
    ) -> None:
        super().__init__(text)
        self._show, self._exchange, self._done = show, exchange or _nothing, done
        self.before, self.after, self.key = before, after, key
        self.cost = _cost(before, after)

    def again(self, key: str = "") -> "_Step":
        """The same step, already done, for an empty stack; without a key it stays separate."""
        return _Step(
            self._show, self.before, self.after, self.text(), key, self._exchange, done=True
        )

    def lead_to(self, after: Session) -> None:
        self.after = after
        self.cost = _cost(self.before, after)

    def redo(self) -> None:
        if self._done:
            self._done = False
        else:
            self._exchange()
            self._show(self.after)

    def undo(self) -> None:
        self._exchange()
        self._show(self.before)

    def id(self) -> int:
        return self._MERGING if self.key else -1

    def mergeWith(self, other: QUndoCommand) -> bool:
        if not isinstance(other, _Step) or other.key != self.key:
            return False
        self.lead_to(other.after)
        self.setText(other.text())
        # Qt deletes the other in the midst of `push`, after which PySide keeps its shell for ever.
        del other.before, other.after
        return True


def _nothing() -> None:
    """Exchange nothing: most steps keep the file of their design."""


def _cost(before: Session, after: Session) -> int:
    kept = dict(blocks(after))
    left = {block: size for block, size in dict(blocks(before)).items() if block not in kept}
    return _SMALL + sum(left.values())
