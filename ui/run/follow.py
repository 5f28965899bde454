"""Live update: designs a lens after every edit of the task, except during a run.

1. One thread designs. An edit lets the current design reach its first result, if that comes soon;
   then the latest edit is next. Where a first result takes long, a design waits for a pause between
   edits. A design that undo or a new task has made useless ends at once.
2. Each lens is part of the step of its edit (`Document.improve`), and undo reverts both. A finished
   lens is a kept run, and the next edit is a step of its own.
3. An edit changes the document once. After more changes (undo, opening a file) the lens before is
   no start.
4. An edit that does not change the lens, such as a region, continues the design from its best lens.
5. Runs, and checks that a person asks for, have priority. Edits during such a check are designed
   after it. The checked lens counts as stopped: continuing its design would replace it. The next
   edit cancels the check of a finished lens (`RunCheck`).
"""

from dataclasses import dataclass, field, replace
from functools import partial
from time import monotonic

from PySide6.QtCore import QObject, QTimer, Signal

from ui.background import Background, Task
from ui.document.document import Document
from ui.document.frame import Frame
from ui.run.control import RunControl
from ui.run.kept_runs import called, with_followed
from ui.run.worker import RunJob, Seen, frame_of, work
from ui.words import later, tr
from workbench.design.live import LiveDesign, asks_for_another_lens
from workbench.design.snapshot import STOPPED, Result
from workbench.files.session import Session
from workbench.messages import Message

_GRACE_MS = 500  # that a design has for its first result once an edit waits for its end
_LATE_MS = 3000  # without a first result, before the status reports a slow task
_SOON = 1.0  # seconds within which a first result comes on a machine that keeps up
_SHARE, _LONGEST = 0.5, 4.0  # pause after an edit: part of what a first result takes, and seconds
_UNDER_WAY = later("Updating the {optic}")
_SLOW = later("Updating the {optic}: slow task, edits are applied after a pause")


@dataclass(eq=False)
class _Design(RunJob):
    own_step: bool = False
    own_edit: bool = False
    task: Task = field(init=False)  # once it is queued
    began: float = 0.0
    has_lens: bool = False


class Follow(QObject):
    """Live update of the document's lens."""

    message = Signal(str)
    settled = Signal()
    failed = Signal(str)

    def __init__(
        self,
        document: Document,
        control: RunControl,
        parent: QObject,
        live: LiveDesign | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._control = document, control
        self._live = live or LiveDesign()  # its snapshots are for the thread alone
        self._on = False
        self._holders: set[str] = set()  # what it pauses for
        self.text = ""
        self._changes = 0  # of the document, since what is followed was put there
        # The same object as long as the lens made last is one of the design before the next edit.
        self._chain: object = None
        self._wanted: Session | None = None  # whose lens is to follow
        self._design: _Design | None = None  # in the thread
        self._next: _Design | None = None
        self._seen: Frame | None = None  # of what follows
        self._background = Background(later("live update"), self, finish_first=True)
        self._background.progressed.connect(self._show_seen)
        self._background.done.connect(lambda *_: self._end())
        self._background.failed.connect(self._fail)
        self._late = QTimer(self, singleShot=True, interval=_LATE_MS)
        self._late.timeout.connect(lambda: self._show_text(_SLOW))
        self._pause = 0.0  # seconds without an edit before its design begins
        self._waiting: _Design | None = None  # for such a pause
        self._rested = QTimer(self, singleShot=True)
        self._rested.timeout.connect(self._queue)
        self._grace = QTimer(self, singleShot=True, interval=_GRACE_MS)
        self._grace.timeout.connect(self._give_up)
        document.edited.connect(self._follow)
        document.begun.connect(self._begin_new)
        document.session_changed.connect(self._note_change)
        control.runner.state_changed.connect(self._rest_for_run)

    def follows(self, session: Session) -> bool:
        """Whether live update designs a lens for this session."""
        return self._on and session.scene.run.method == "auto"

    def switch(self, on: bool) -> None:
        """Switch live update; a missing lens is designed at once."""
        self._on = on
        session = self._document.session
        if not on:
            self.rest()
        elif session.result is None and self.follows(session) and not self._control.busy:
            self._begin(session, own_step=session.heights is not None)

    def hold(self, holder: str, held: bool) -> None:
        """Pause for a check or a page; edits meanwhile and a missing lens are designed after it."""
        before = bool(self._holders)
        (self._holders.add if held else self._holders.discard)(holder)
        if bool(self._holders) == before:
            return
        waiting = self._wanted
        if held:
            self._show_best()
            self._document.seal()  # what is checked can be returned to
            self.rest()
            if self._document.session.result is None:
                self._wanted = waiting
        elif waiting is not None and not self._changes:
            self._begin(waiting)

    def close(self) -> None:
        self._on = False
        self.rest()
        self._background.close()
        self._design = None

    def _show_best(self) -> None:
        """Show the document's lens where a later, worse one is shown; rare, 0.1 s for 480 x 480."""
        seen, session = self._seen, self._document.session
        if self._wanted is None or seen is None or session.result is None:
            return
        if seen.state.heights != session.result.state.heights:
            self._control.show(frame_of(session, session.result))

    def _note_change(self, session: Session) -> None:
        self._changes += 1
        QTimer.singleShot(0, self, self._rest_after_change)
        if self._rested.isActive():  # an edit begins the pause anew after this
            self._rested.start(0)
        opened = not self._document.undo_stack.count()
        if opened and session.heights is None and self.follows(session):
            self._begin(session, abandons=True)

    def _rest_after_change(self) -> None:
        if self._changes and self._wanted is not None and not self._holders:  # by somebody else
            self.rest()

    def _begin_new(self, session: Session) -> None:
        if self.follows(session):
            self._begin(session, abandons=True)

    def _follow(self, before: Session, after: Session) -> None:
        alone, self._changes = self._changes == 1, 0
        if not self.follows(after):
            self._chain = None
            self.rest()
        elif asks_for_another_lens(before, after):
            self._begin(after, self._chain if alone else None, before=before)
        elif alone and self._wanted is not None:
            self._begin(after)  # the lens under way is wanted as before
        else:
            self._chain = None
            self.rest()

    def _begin(
        self,
        session: Session,
        chain: object = None,
        *,
        before: Session | None = None,
        own_step: bool = False,
        abandons: bool = False,
    ) -> None:
        """Design a lens once the current design has one; at once if that design is abandoned."""
        self._changes = 0
        if self._holders:
            self._wanted, self._chain = session, None
            return
        self._chain = chain = chain or object()
        self._wanted, self._control.followed = session, True
        self._waiting = _Design(
            session,
            generate=lambda *_: self._live.snapshots(session, chain, before),
            own_step=own_step,
            own_edit=before is not None,
        )
        if abandons:
            self._give_up()
        if before is None or not self._pause:
            self._queue()
        else:
            self._rested.start(round(1000 * self._pause))
        self._show_text(_UNDER_WAY)

    def _queue(self) -> None:
        self._rested.stop()
        if self._changes:  # by somebody else
            self.rest()
            return
        self._next, self._waiting = self._waiting, None
        if self._next is None:
            return
        self._next.task = self._background.begin(partial(work, self._next))
        if self._design is None:
            self._take_next()
        elif self._design.has_lens:
            self._give_up()
        elif self._next.own_edit and not self._grace.isActive():
            self._grace.start()

    def _give_up(self) -> None:
        design = self._design
        if design is None:
            return
        design.task.give_up()
        if not design.has_lens:  # its first result would have taken longer still
            self._pause = max(self._pause, _pause_after(monotonic() - design.began))

    def _take_next(self) -> None:
        self._design, self._next = self._next, None
        self._late.stop()
        self._grace.stop()
        if self._design is not None:
            self._design.began = monotonic()
            self._late.start()

    def _show_seen(self, _: object, seen: Seen) -> None:
        design, (best, frame) = self._design, seen
        if design is None or self._wanted is None or self._holders or self._changes:
            return
        self._seen = frame
        self._control.show(frame)
        if frame.snapshot.iteration:
            self._note_lens(design)
        if best is not None and best.iterations and design.session is self._wanted:
            # Whatever ends the design before it does so itself, it can go on from there.
            self._put(design, replace(best, ended=Message(STOPPED)))

    def _note_lens(self, design: _Design) -> None:
        if not design.has_lens:
            design.has_lens = True
            self._late.stop()
            self._pause = _pause_after(monotonic() - design.began)
        if self._next is not None:
            self._give_up()

    def _put(self, design: _Design, best: Result) -> None:
        session, displaced = with_followed(self._document.session, best)
        if design.own_step:
            design.own_step = False
            self._document.change(
                session, tr("design of the missing {optic}", optic=session.scene.optic.called)
            )
            self._changes = 0
        else:
            self._document.improve(session)
        for run in displaced:
            self._control.displaced.emit(called(run))
        self._show_text(_UNDER_WAY)

    def _end(self) -> None:
        design = self._design
        assert design is not None  # since its work has ended
        best = design.history.result()
        wanted = self._is_wanted(design)
        if wanted and best is not None and best.iterations:
            self._put(design, best)  # with why it ended
            self._document.seal()
        self._take_next()
        if wanted:
            self.rest()
            self.settled.emit()

    def _fail(self, sentence: str) -> None:
        wanted = self._design is not None and self._is_wanted(self._design)
        self._take_next()
        if wanted:
            self.rest()
            self.failed.emit(sentence)

    def _is_wanted(self, design: _Design) -> bool:
        elsewhere = self._changes or self._holders or design.task.given_up
        return design.session is self._wanted and not elsewhere

    def _rest_for_run(self, state: str) -> None:
        if state == "running":
            self.rest()

    def rest(self) -> None:
        """Stop until the next edit, and show the document's lens."""
        self._background.stop()
        self._next = self._waiting = None
        self._rested.stop()
        self._give_up()
        self._late.stop()
        self._grace.stop()
        self._seen = None
        if self._wanted is not None:
            self._wanted, self._control.followed = None, False
            self._control.preview()
            self._show_text("")

    def _show_text(self, text: str) -> None:
        self.text = tr(text, optic=self._document.session.scene.optic.called)
        self.message.emit(self.text)


def _pause_after(seconds: float) -> float:
    return 0.0 if seconds < _SOON else min(_SHARE * seconds, _LONGEST)
