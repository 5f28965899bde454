"""Messages about edits: lens kept, target image, unit, refused and postponed edits."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from PySide6.QtCore import QObject, Signal

from ui.document.document import Document
from ui.panels.edits import Edit, edited_scene, value_at
from ui.panels.forms import Forms
from ui.widgets.messages import MessageBar, Offer
from ui.words import error_text, later, tr
from workbench.design.picture import changed_on_disk, why_not_kept
from workbench.errors import Refused
from workbench.files.session import Session
from workbench.geometry.approximation import deviation, nearest_finer
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.powers import written
from workbench.scene import AutoNet, Scene
from workbench.scene.faces import LARGEST_NET

if TYPE_CHECKING:
    from ui.run.control import RunControl
from workbench.units import ratio


class RefusedFields(QObject):
    """Reports refused fields, as long as there are any."""

    def __init__(self, forms: Forms, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._forms, self._messages = forms, messages
        self._text = ""
        forms.refusals_changed.connect(self._follow)

    def tell(self) -> None:
        """Report which fields need a correction."""
        count = len(self._forms.refusals)
        first = self._forms.refusals[0]
        others = tr(" ({count} more refused)").format(count=count - 1) if count > 1 else ""
        self._text = tr("{first}{others}. Correct it, or press Esc, first.").format(
            first=first, others=others
        )
        self._messages.warn(self._text)

    def _follow(self) -> None:
        if self._text and self._messages.text == self._text:
            if self._forms.refusals:
                self.tell()
            else:
                self._messages.clear()


class PostponedEdits(QObject):
    """Reports which edits wait for the end of a run, and offers to stop it."""

    def __init__(
        self, forms: Forms, control: "RunControl", messages: MessageBar, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._forms, self._control, self._messages = forms, control, messages
        self._text = ""
        forms.postponed.connect(self._offer)

    def make(self) -> None:
        """Apply the edits after the run."""
        self._withdraw()
        self._forms.make_postponed_edits()

    def remind(self, sentence: str) -> None:
        """Show a sentence, and that edits still wait."""
        self._offer(f"{sentence} {self._forms.postponed_text}")

    def _offer(self, sentence: str) -> None:
        self._text = sentence
        stop = self._control.runner.stop
        self._messages.note(
            sentence, (tr("Stop and apply"), stop), (tr("Take back"), self._take_back)
        )

    def _take_back(self) -> None:
        self._withdraw()
        self._forms.drop_postponed_edits()

    def _withdraw(self) -> None:
        self._messages.withdraw(self._text)


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
    """Listens to the edits of a document.

    A lens that another control net cannot hold is carried over nearly: the message says how far
    off it is, and offers the nearest net on which it would stay as it is.
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
        changed = _changed_net(before.scene, after.scene)
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


def _changed_net(before: Scene, after: Scene) -> _ChangedNet | None:
    """The first face with another net, of those that both have; the exit face before the other."""
    optic = after.optic
    old, new = freeform_nets(before.optic), freeform_nets(optic)
    changed = [face for face in new if face in old and old[face] != new[face]]
    if not changed:
        return None
    if optic.designed_face in changed:
        face, name = optic.designed_face, tr("the {optic}", optic=optic.called)
    else:
        (face,), name = changed, tr("the entrance face")
    path = f"{after.face_path(face)}.control_points"
    automatic = isinstance(value_at(after, path), AutoNet)
    return _ChangedNet(face, old[face], new[face], path, name, automatic)


def _size(shape: tuple[int, int]) -> str:
    return f"{shape[0]} × {shape[1]}"


class TargetImage(QObject):
    """Reports that the target's image is not stored, or has changed on disk."""

    def __init__(self, document: Document, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._messages = document, messages
        self._text = ""
        document.edited.connect(self._tell_of_edit)
        document.session_changed.connect(self._withdraw)

    def look(self) -> None:
        """Report on a design that was just opened."""
        session = self._document.session
        if self._document.path is None:  # drawn from its file a moment ago
            self._tell_if_not_kept(session)
            self._tell_remarks(session)
        self._tell_if_changed(session)

    def _tell_of_edit(self, before: Session, after: Session) -> None:
        if after.target is before.target:
            return
        if after.scene.image != before.scene.image:
            self._tell_if_not_kept(after)
        if after.picture_remarks != before.picture_remarks:
            self._tell_remarks(after)
        self._tell_if_changed(after)

    def _tell_if_not_kept(self, session: Session) -> None:
        why = why_not_kept(session.scene, session.picture)
        if why:
            self._messages.note(why)

    def _tell_remarks(self, session: Session) -> None:
        if session.picture_remarks:
            self._messages.note("; ".join(map(tr, session.picture_remarks)))

    def _tell_if_changed(self, session: Session) -> None:
        if changed_on_disk(session.scene, session.picture):
            self._text = tr(
                "{image} has changed. The design keeps the picture that it has."
            ).format(image=session.scene.image)
            self._messages.note(self._text, (tr("Read it again"), self._read_again))

    def _read_again(self) -> None:
        try:
            self._document.read_image_again()
        except Refused as refused:
            self._messages.warn(error_text(refused))

    def _withdraw(self) -> None:
        self._messages.withdraw(self._text)


class UnitChange(QObject):
    """Reports that a change of unit converted all lengths, and offers to keep the numbers."""

    def __init__(self, document: Document, messages: MessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._messages = document, messages
        self._after: Session | None = None
        self._text = ""
        document.edited.connect(self._tell)
        document.session_changed.connect(self._withdraw)

    def _tell(self, before: Session, after: Session) -> None:
        old, new = before.scene.unit, after.scene.unit
        if old == new:
            return
        self._after = after
        self._text = tr("All lengths are converted: 1 {old} is {ratio:.6g} {new} now.").format(
            old=old, ratio=float(ratio(old, new)), new=new
        )
        self._messages.note(
            self._text, (tr("Keep the numbers"), lambda: self._keep_numbers(before, after))
        )

    def _keep_numbers(self, before: Session, after: Session) -> None:
        scene = before.scene.model_copy(update={"unit": after.scene.unit})
        self._document.change(before.with_scene(scene, before.target), tr("change of unit alone"))

    def _withdraw(self, session: Session) -> None:
        if session is not self._after:
            self._messages.withdraw(self._text)
