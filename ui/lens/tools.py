"""Tools of the 3D scene: between the document and what the user drags.

1. A drag is one undoable step, made when its lens is traced: a result includes its irradiance.
2. One lens is traced at a time, in a thread; of later requests only the latest is traced.
3. Any other change of the design ends the drag.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from PySide6.QtCore import QObject, Signal

from ui.background import Background, Task
from ui.document.document import Document
from ui.document.frame import Frame, make_frame, same_task
from ui.lens.brush_tools import Brush, Lock, Sculpt
from ui.lens.measure import Measure
from ui.lens.move_source import MoveSource
from ui.run.control import RunControl
from ui.views.scene_view import SceneView
from ui.views.tools import Tool
from ui.views.view import drawing_queue
from ui.words import error_text, later, tr
from workbench.arrays import Mask
from workbench.design.limits import HeightLimits, bounded
from workbench.design.run import Evaluator
from workbench.design.snapshot import History, Result
from workbench.errors import Refused
from workbench.files.session import Session
from workbench.geometry.faces import ControlHeights, FaceArrays
from workbench.geometry.surface import nets_of
from workbench.optics.ready import without_waiting
from workbench.scene import Scene


@dataclass(frozen=True, eq=False)
class Draft:
    """A lens during a drag."""

    session: Session
    heights: ControlHeights
    earlier: Result | None = None
    settled: bool = False


class LiveLens(Background):
    """Traces drafts in a thread, the latest next, to frames."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(later("ray trace"), parent, finish_first=True)
        self._evaluator: Evaluator | None = None

    def show(self, draft: Draft) -> None:
        self.begin(partial(self._trace, draft), draft)

    def _trace(self, draft: Draft, task: Task) -> Frame:
        session, heights = draft.session, draft.heights
        scene, target = session.scene, session.target
        with without_waiting():
            there = self._evaluator
            if there is None or not there.suits(scene, target):
                self._evaluator = there = Evaluator(scene, target, heights)
            snapshot = there.snapshot(heights, draft.earlier)
        return make_frame(session, snapshot, History(draft.earlier))


_BUSY = later("Stop the run first, then sculpt the {optic}.")
_NO_LENS = later("There is no {optic} to sculpt yet.")
_ONE_FACE = later(
    "There is only one freeform face. Design > Freeform entrance face adds a second one."
)
_NOT_TO_SCALE = later("Switch off View > Compress distances first, then move the source.")


class LensTools(QObject):
    """Tools for control points, locks and source; their drags become undoable steps."""

    message = Signal(str)
    editing_began = Signal()

    def __init__(
        self, document: Document, control: RunControl, view: SceneView, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._document, self._control, self._view = document, control, view
        self._brush = Brush(view)
        lock = Lock(view, self._brush, self._may_change, self)
        self._tools: dict[str, Tool | None] = {
            "turn": None,
            "sculpt": self._sculpt(),
            "lock": lock,
            "move_source": self._move_source(),
            "measure": Measure(view, self),
        }
        self._tool: Tool | None = None
        lock.painted.connect(self._store_locks)
        self._live = LiveLens(self)
        self._live.done.connect(self._show_traced)
        self._live.failed.connect(self._give_up)
        self._shaping = False  # a drag goes on
        self._settling: Draft | None = None  # let go, not traced yet
        self._drags = 0
        self._own = False  # whether the document changes by this
        document.session_changed.connect(self._abandon)
        control.runner.state_changed.connect(self._abandon)

    def slots(self) -> dict[str, Callable[[], object]]:
        return {
            **{name: partial(self._use, tool) for name, tool in self._tools.items()},
            "other_face": self._choose_other_face,
            "brush_larger": partial(self._resize, 1),
            "brush_smaller": partial(self._resize, -1),
            "lock_all": lambda: self._lock(np.ones_like, tr("lock all points")),
            "unlock_all": lambda: self._lock(np.zeros_like, tr("unlock all points")),
            "invert_locks": lambda: self._lock(np.logical_not, tr("invert locks")),
        }

    def close(self) -> None:
        drawing_queue().hurry(False)
        self._live.close()

    def _sculpt(self) -> Sculpt:
        tool = Sculpt(self._view, self._brush, self._heights, self)
        tool.shaped.connect(self._shape)
        tool.refused.connect(self.message)
        return tool

    def _move_source(self) -> MoveSource:
        tool = MoveSource(self._view, self._movable, self)
        tool.moved.connect(self._move)
        tool.cancelled.connect(self._move_back)
        return tool

    def _use(self, tool: Tool | None) -> None:
        self._tool = tool
        self._view.use(tool)

    def _choose_other_face(self) -> None:
        optic, nets = self._view.optic, self._view.nets
        if optic is None or len(nets.faces) < 2:
            self.message.emit(tr(_ONE_FACE))
            return
        self._view.drop()
        nets.choose(nets.faces[nets.faces.index(nets.face) - 1])
        optic = self._view.optic or optic
        self._view.fit("lens" if optic.outwards(nets.face) > 0 else "entrance")

    def _resize(self, steps: int) -> None:
        if self._tool is not None:
            self._tool.turn_wheel(steps)

    def _note(self, text: str) -> None:
        self.message.emit(tr(text, optic=self._document.session.scene.optic.called))

    def _is_idle(self) -> bool:
        if self._control.busy:
            self._note(_BUSY)
        return not self._control.busy

    def _may_change(self) -> bool:
        if not self._is_idle():
            return False
        frame, scene = self._view.frame, self._document.session.scene
        there = (
            frame is not None
            and frame.session.scene.optics == scene.optics
            and bounded(scene.focused_on(self._view.nets.face)) == self._view.optic
        )
        if not there:
            self._note(_NO_LENS)
        return there

    def _heights(self) -> ControlHeights | None:
        frame = self._view.frame
        if not self._may_change() or frame is None:
            return None
        self.editing_began.emit()
        draft = self._settling
        return frame.state.heights if draft is None else draft.heights

    def _shape(self, lens: ControlHeights, settled: bool) -> None:
        frame = self._view.frame
        if frame is None:
            return
        self._shaping = not settled
        drawing_queue().hurry(self._shaping)
        draft = Draft(self._document.session, lens, frame.result, settled)
        self._settling = draft if settled else None
        self._live.show(draft)

    def _movable(self) -> Scene | None:
        """The scene to move parts of in a new drag; None if that is not possible now."""
        if not self._is_idle():
            return None
        if self._view.exploded:
            self.message.emit(tr(_NOT_TO_SCALE))
            return None
        self._drags += 1
        return self._document.session.scene

    @property
    def _key(self) -> str:
        return f"drag {self._drags}"

    def _move(self, moved: Scene, text: str) -> None:
        try:
            scene = Scene.from_data(moved.to_data())
            self._as_own(lambda: self._document.edit(scene, tr(text), self._key))
        except Refused as refused:
            self.message.emit(error_text(refused))
            return
        session = self._document.session
        self._view.hold_camera(session.scene)
        if self._control.followed:  # what is shown next is another lens
            return
        self._live.show(Draft(session, _lens_of(session), session.result))

    def _move_back(self) -> None:
        self._live.cancel()
        if self._control.busy:  # a run that began in the midst of the drag keeps what it began with
            return
        steps = self._document.undo_stack
        if steps.origin(self._key) is not None:
            self._as_own(steps.undo)

    def _show_traced(self, draft: Draft, frame: Frame) -> None:
        shown = self._view.frame
        if shown is not None and _differ_by_source(shown.session, draft.session):
            # Views begin anew with another session. While a source is dragged they need not: all
            # that changes is in the frame.
            frame = replace(frame, session=shown.session)
        self._control.show(frame)
        if draft is self._settling:
            self._settling = None
            self._keep(frame)
        elif not self._shaping and self._settling is None:
            self._control.preview()  # of the design with its other source, once that rests

    def _keep(self, frame: Frame) -> None:
        if _lens_of(self._document.session) != frame.state.heights:
            text = tr("move control points")
            self._as_own(lambda: self._document.set_result(frame.result, text))

    def _give_up(self, sentence: str) -> None:
        if self._live.busy:  # with a later draft
            return
        self.message.emit(sentence)
        if self._settling is not None:
            self._settling = None
            self._control.preview()

    def _lock(self, change: Callable[[Mask], Mask], text: str) -> None:
        if self._is_idle():
            session = self._document.session
            self._set_locked(
                {
                    face: change(session.locked.get(face, np.zeros(net.shape, dtype=bool)))
                    for face, net in nets_of(session.scene).items()
                },
                text,
            )

    def _store_locks(self, face: str, locked: Mask, locks: bool) -> None:
        text = tr("lock points") if locks else tr("unlock points")
        self._set_locked({**self._document.session.locked, face: locked}, text)

    def _set_locked(self, masks: Mapping[str, Mask], text: str) -> None:
        before = self._document.session
        locks = FaceArrays({face: mask for face, mask in masks.items() if mask.any()})
        if locks != before.locked:
            session = replace(before, locked=locks)
            self._as_own(lambda: self._document.change(session, text))

    def _as_own(self, change: Callable[[], object]) -> None:
        self._own = True
        try:
            change()
        finally:
            self._own = False

    def _abandon(self) -> None:
        if not self._own:
            self._view.drop()
            self._settling = None  # what is taken back settles where it began
            self._live.cancel()


def _differ_by_source(one: Session, other: Session) -> bool:
    lit = other.scene.model_copy(update={"source": one.scene.source})
    return same_task(one, replace(other, scene=lit))


def _lens_of(session: Session) -> ControlHeights:
    if session.heights is not None:
        return session.heights
    limits = HeightLimits.of_scene(session.scene)
    return FaceArrays({face: each.undesigned for face, each in limits.items()})
