"""The least error that any lens can reach with the source of the design on show, in the status."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ui.document.document import Document
from ui.threads.background import Background, Task
from ui.threads.failure import sentence_of
from ui.words import tr

if TYPE_CHECKING:
    from workbench.extended.bound import Bound
    from workbench.files.session import Session


class BoundOfDesign(QObject):
    """Finds the bound of each new task in a thread of its own.

    Attributes
    ----------
    figures_changed : Signal(str, str)
        The bound in a few words, and in a sentence; empty where the source sets none, and until it
        is found.
    failed : Signal(str)
        Why there is none.
    """

    figures_changed = Signal(str, str)
    failed = Signal(str)

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._task: Session | None = None  # whose bound is shown, or looked for
        self._background = Background("bound", self)
        self._background.done.connect(lambda _, found: self.figures_changed.emit(*found))
        self._background.failed.connect(
            lambda _, error: self.failed.emit(sentence_of(error, tr("bound")))
        )
        document.session_changed.connect(self.follow)

    def close(self) -> None:
        """End the search and wait for its thread; safe to call twice."""
        self._background.close()

    def follow(self, session: "Session") -> None:
        """Look for the bound of another task, unless it is that of the last one."""
        from workbench.extended.bound import Bound  # late: takes long to import

        bound, last = Bound(session.scene, session.target), self._task
        self._task = session
        if last is not None and last.target is session.target:
            before = Bound(last.scene, last.target)
            if (before.blur, before.certified) == (bound.blur, bound.certified):
                return
        self._background.cancel()
        self.figures_changed.emit("", "")
        if bound.certified:
            self._background.begin(partial(_in_words, bound), session)


def _in_words(bound: "Bound", task: Task) -> tuple[str, str]:
    """The bound in words; meant for the thread, which leaves it once it shall stop."""
    from workbench.extended.bound import percent  # late: takes long to import

    if task.follow(bound.finding()) is None:
        return "", ""
    allowed = task.follow(bound.finding_half_as_wide())
    if allowed is None:
        return "", ""
    return (
        tr("at best {error}").format(error=percent(bound.relative_l2)),
        tr(
            "There can be {bound}; {error} with a source half as wide. This is the "
            "least relative L2 error, certified; freeform bound tells more."
        ).format(bound=bound.short, error=percent(allowed)),
    )
