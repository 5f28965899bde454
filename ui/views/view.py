"""Base of all views, and the queue in which they are drawn.

One view draws in a turn of the event loop. The cost is measured around a synchronous repaint, and
all views rest for a multiple of it: slow machines draw fewer frames and stay responsive. During a
drag nothing rests.
"""

from collections import OrderedDict
from dataclasses import dataclass
from functools import partial
from time import perf_counter
from typing import Any

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtGui import QCloseEvent, QHideEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ui.background import Background, Task, close_threads
from ui.document.document import Document
from ui.document.frame import Frame, same_light, shows
from ui.document.shown_lens import ShownLens
from ui.views.shared_view import SharedView
from ui.widgets import theme
from ui.widgets.labels import Veil
from ui.widgets.native import application
from ui.words import tr
from workbench.files.session import Session

_REST = 2.0  # seconds of rest for each second of drawing
_REST_MS = 250  # before a computation; longer than between two frames or two steps of a hand
_LONGEST = 1.0  # seconds; the first drawing also loads what is drawn with


class DrawingQueue(QObject):
    """Queue of views that wait for drawing."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._waiting: OrderedDict[int, View] = OrderedDict()
        self._rested_at = 0.0
        self._hurried = False
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self._next)

    def ask(self, view: "View") -> None:
        self._waiting.setdefault(id(view), view)
        self._wait()

    def leave(self, view: "View") -> None:
        self._waiting.pop(id(view), None)
        if not self._waiting:
            self._timer.stop()

    def hurry(self, hurried: bool) -> None:
        """Draw without pauses, or with pauses again."""
        self._hurried = hurried

    def _next(self) -> None:
        _, view = self._waiting.popitem(last=False)
        began = perf_counter()
        try:
            view.draw_now()
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


class View(QWidget):
    """Shows one aspect of the design.

    Until the first frame of another design arrives, the old picture is greyed and marked as
    outdated.
    """

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__()
        self._shared = shared or SharedView(self)
        self._session: Session | None = None
        self._frame: Frame | None = None
        self._to_draw = False
        self._box = QVBoxLayout(self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self._of_another = False  # whether the frame is of another design
        self._resting = True  # whether the shown lens is final
        self._veil = Veil(self)

    @property
    def outdated(self) -> bool:
        return not self._veil.isHidden()

    def add_below(self, widget: QWidget) -> None:
        self._box.addWidget(widget)

    def follow(self, document: Document, shown: ShownLens) -> None:
        """Show the design of a document, and all frames of its lens."""
        self.show_design(document.session)
        document.session_changed.connect(self.show_design)
        shown.frame_changed.connect(self.show_frame)
        shown.emptied.connect(self.show_nothing)
        shown.outdated_changed.connect(self.show_outdated)

    def allow(self, resting: bool) -> None:
        self._resting = resting

    def show_design(self, session: Session) -> None:
        self._session = session
        if self._frame is None:
            self._ask()

    def show_frame(self, frame: Frame) -> None:
        before, self._frame = self._frame, frame
        if self._differs(before, frame):
            self._ask()

    def show_nothing(self, session: Session) -> None:
        self._session, self._frame = session, None
        self._show_veil()
        self._ask()

    def show_outdated(self, outdated: bool) -> None:
        self._of_another = outdated
        self._show_veil()

    def draw_now(self) -> None:
        if not self._to_draw or not self.isVisible() or self.window().isMinimized():
            return
        session = self._session if self._frame is None else self._frame.session
        if session is not None:
            self._to_draw = False
            self._draw(session, self._frame)

    def is_dark(self) -> bool:
        return theme.is_dark(self.palette())

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._to_draw:
            drawing_queue().ask(self)

    def hideEvent(self, event: QHideEvent) -> None:
        drawing_queue().leave(self)
        super().hideEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._recolour()
            self._ask()

    def _ask(self) -> None:
        self._to_draw = True
        if self.isVisible():
            drawing_queue().ask(self)

    def _show_veil(self) -> None:
        self._veil.cover(self._of_another or self._is_behind())

    def _is_behind(self) -> bool:
        return False

    def _differs(self, before: Frame | None, frame: Frame) -> bool:
        """Whether a frame looks other than the one that was shown before."""
        return True

    def _number(self, session: Session) -> int:
        return self._shared.number_in(session.scene)

    def _of_image(self, session: Session, frame: Frame | None) -> tuple[Session, Frame | None]:
        number = self._number(session)
        return session.of_image(number), frame and frame.of_image(number)

    def _draw(self, session: Session, frame: Frame | None) -> None: ...

    def _recolour(self) -> None: ...


@dataclass(frozen=True, eq=False)
class Request:
    """Request for what is computed of the lens of a frame, by what is chosen beside it."""

    frame: Frame
    choice: Any = None

    def same(self, other: "Request | None") -> bool:
        if other is None or self.choice != other.choice:
            return False
        return same_light(self.frame, other.frame)


class ComputingView(View):
    """View of the answer to a request, computed in a thread while it is seen and the design rests.

    It must be the last base of a view: PySide looks for signals along the first.
    """

    _WORK, _TITLE = "", ""  # names of the work in English; the second for the list of tasks

    _covered = False

    def __init__(self, shared: SharedView | None = None) -> None:
        super().__init__(shared)
        self._rest = QTimer(self, singleShot=True, interval=_REST_MS)
        self._rest.timeout.connect(self._compute)
        self.background = Background(self._WORK, self)
        self.background.done.connect(self._store)
        self.background.failed.connect(self._fail)
        self._asked: Request | None = None  # computed now, or before
        self._answered: Request | None = None
        self._answer: Any = None

    def show_design(self, session: Session) -> None:
        super().show_design(session)
        if self._frame is not None and not shows(self._frame, session):
            self._want_nothing()

    def show_frame(self, frame: Frame) -> None:
        super().show_frame(frame)
        self._want()

    def show_nothing(self, session: Session) -> None:
        self._want_nothing()
        self._forget()
        super().show_nothing(session)

    def allow(self, resting: bool) -> None:
        super().allow(resting)
        if not resting:
            self._want_nothing()
        self._want()

    def uncover(self, uncovered: bool) -> None:
        """Start or stop computing; a dock behind another tab is covered, not hidden."""
        self._covered = not uncovered
        if uncovered:
            self._want()
        else:
            self._want_nothing()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._want()

    def hideEvent(self, event: QHideEvent) -> None:
        self._want_nothing()
        super().hideEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        close_threads(self)
        super().closeEvent(event)

    @property
    def _known(self) -> bool:
        """Whether the answer is that to the present request."""
        return self._frame is not None and self._request().same(self._answered)

    def _seen(self) -> bool:
        return self._frame is not None and self.isVisible() and not self._covered

    def _request(self) -> Request:
        assert self._frame is not None  # of what nobody sees, nothing is computed
        return Request(self._frame, self._chosen())

    def _chosen(self) -> Any:
        return None

    def _is_behind(self) -> bool:
        return self._answered is not None and self._frame is not None and not self._known

    def _want(self) -> None:
        """Compute the answer once all rests, unless it is there or computed already."""
        if self._known:
            self._rest.stop()
            self.background.cancel()
        elif not (self._resting and self._seen()):
            self._rest.stop()
        elif not (self.background.busy and self._request().same(self._asked)):
            self.background.cancel()
            self._rest.start()
        if self._frame is not None:
            self._show_veil()
            self._show_state()

    def _want_nothing(self) -> None:
        self._rest.stop()
        self.background.cancel()

    def _compute(self) -> None:
        self._asked = request = self._request()
        self.background.begin(partial(self._work, request), request, tr(self._TITLE))
        self._show_state()

    def _store(self, request: Request, answer: Any) -> None:
        if answer is not None:  # else a person has stopped the work
            self._answered, self._answer = request, answer
        self._show_veil()
        self._show_state()
        self._ask()

    def _forget(self) -> None:
        self._answered = self._answer = None

    @staticmethod
    def _work(request: Request, task: Task) -> Any:
        """Return the answer to a request, in the thread; None if stopped."""

    def _show_state(self) -> None:
        """Say whether the answer is awaited, computed or shown."""

    def _fail(self, sentence: str) -> None:
        """Say why there is no answer."""
