"""Message about the lens after an edit of the task."""

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QObject, Signal

from ui.document.document import Document
from ui.panels.edits import Edit, edited_scene, value_at
from ui.widgets.message_bar import MessageBar, Offer
from ui.words import later, tr
from workbench.files.session import Session
from workbench.geometry.approximation import deviation, nearest_finer
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.powers import written
from workbench.scene import AutoNet, Optic
from workbench.scene.net import LARGEST_NET

_NO_LENS = later(
    "The {optic} does not fit the new outline: Start designs another one, Undo brings it back."
)
_ANOTHER_FACE = later(
    "The entrance face is freeform now, and flat so far. Continue shapes "
    "both faces, and Undo takes the change back."
)
_ONE_FACE_LESS = later(
    "The entrance face is flat now; the exit face stays as it was, but it "
    "was made for the light of both. Continue shapes it alone, and Undo "
    "takes the change back."
)
_WITHIN_LIMITS = later(
    "The {optic} is changed by up to {moved} to be within its new limits. Continue goes on from "
    "there, and Undo takes the change back."
)
_OTHER_NET = later(
    "The program takes {size} control points now. Continue goes on from the {optic} that was "
    "there, carried over, and Undo takes the change back."
)
_A_START = later(
    "The {optic} was designed for another task and is a start for this one: Continue goes on from "
    "it, Start over does not"
)


class CarriedLens(QObject):
    """Reports what an edit did to the lens.

    If another control net approximates the lens, the message gives the deviation and offers the
    nearest net that represents it exactly. ``followed`` says whether live update designs the edited
    session: then there is no message.
    """

    noted = Signal(str)

    def __init__(self, document: Document, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._messages = document, messages
        self.followed: Callable[[Session], bool] = lambda _: False
        # The last change of a net: another one right after it is a change of mind.
        self._before: Session | None = None
        self._after: Session | None = None
        self._text = ""
        self._noted: tuple[Session, str] | None = None  # said once of all edits of one step
        document.edited.connect(self._tell)
        document.session_changed.connect(self._withdraw)

    def _tell(self, before: Session, after: Session) -> None:
        if before is self._after and self._before is not None:
            before = self._before
        old, new = before.heights, after.heights
        if old is None or self.followed(after) or after.result is before.result is not None:
            return
        if before.scene.unit != after.scene.unit:  # converted, the lens with all the rest
            return
        changed = _changed_net(before.scene.optic, after.scene.optic)
        if after.result is not None and changed is None:  # within its new limits
            return
        if new is None:
            self._say_of(after, self._named(_NO_LENS))
        elif set(new) - set(old):
            self._say_of(after, tr(_ANOTHER_FACE))
        elif set(old) - set(new):
            self._say_of(after, tr(_ONE_FACE_LESS))
        elif changed is None and new is not old:
            unit = after.scene.unit
            moved = max(float(np.abs(new[face] - old[face]).max()) for face in new)
            said = self._named(_WITHIN_LIMITS).format(moved=written(moved, unit, 2))
            self._say_of(after, said)
        elif changed is not None and changed.automatic:
            said = self._named(_OTHER_NET).format(size=_size(changed.new.shape))
            self._say_of(after, said)
        elif changed is not None:
            self._before, self._after = before, after
            if changed.new.contains(changed.old):
                self._say(
                    tr("On {size} control points {name} is the same.").format(
                        size=_size(changed.new.shape), name=changed.name
                    )
                )
            else:
                off = deviation(changed.old, old[changed.face], changed.new, new[changed.face])
                self._ask(before, after, changed, off)
        elif before.result is not None:
            self._tell_once(before, self._named(_A_START))

    def _ask(self, before: Session, after: Session, changed: "_ChangedNet", off: float) -> None:
        wanted, unit = changed.new.shape, after.scene.unit
        exact = nearest_finer(changed.old, wanted, LARGEST_NET)
        offers: list[Offer] = []
        if exact != changed.old.shape:
            take = partial(self._take, before, after, changed.path, exact)
            offers = [(tr("Take {size}, exact").format(size=_size(exact)), take)]
        self._say(
            tr(
                "On {size} control points {name} is off by up to {off}. "
                "Continue goes on from there, Start over from nothing, and Undo takes "
                "the change back."
            ).format(size=_size(wanted), name=changed.name, off=written(off, unit, 2)),
            *offers,
        )

    def _take(self, before: Session, after: Session, path: str, size: tuple[int, int]) -> None:
        text = tr("change of {name}").format(name=tr("control points"))
        scene = edited_scene(after.scene, [Edit(path, text, {path: list(size)})])
        self._document.change(before.with_scene(scene, after.target), text)

    def _tell_once(self, before: Session, text: str) -> None:
        if self._noted is None or self._noted[0] is not before or self._noted[1] != text:
            self._noted = before, text
            self.noted.emit(text)

    def _say_of(self, after: Session, text: str) -> None:
        self._before, self._after = None, after
        self._say(text)

    def _say(self, text: str, *offers: Offer) -> None:
        self._text = text
        self._messages.note(self._text, *offers)

    def _named(self, text: str) -> str:
        return tr(text, optic=self._document.session.scene.optic.called)

    def _withdraw(self, session: Session) -> None:
        if session is not self._after:
            self._messages.withdraw(self._text)


class _ChangedNet(NamedTuple):
    face: str
    old: ControlNet
    new: ControlNet
    path: str
    name: str
    automatic: bool


def _changed_net(before: Optic, after: Optic) -> _ChangedNet | None:
    old, new = freeform_nets(before), freeform_nets(after)
    changed = [face for face in new if face in old and old[face] != new[face]]
    if after.face in changed:
        face, name, path = (
            after.face,
            tr("the {optic}", optic=after.called),
            f"{after.called}.control_points",
        )
        points: object = after.control_points
    elif changed:
        (face,), name, path = changed, tr("the entrance face"), "lens.entrance.control_points"
        points = value_at(after, "entrance.control_points")
    else:
        return None
    return _ChangedNet(face, old[face], new[face], path, name, isinstance(points, AutoNet))


def _size(shape: tuple[int, int]) -> str:
    return f"{shape[0]} × {shape[1]}"
