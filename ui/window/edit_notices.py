"""Messages about edits: refused and postponed fields, the lens kept, target image, unit."""

from abc import abstractmethod
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QObject, Signal

from ui.document.document import Document
from ui.panels.edits import Edit, edited_scene
from ui.panels.forms import Forms
from ui.run.control import RunControl
from ui.widgets.messages import Messages, Offer
from ui.words import capitalised, error_text, later, tr
from workbench.design.task import changed_on_disk, why_not_kept
from workbench.errors import Refused
from workbench.files.session import Session
from workbench.geometry.approximation import deviation, nearest_finer
from workbench.geometry.surface import ControlNet, nets_of
from workbench.powers import written
from workbench.scene import AutoNet, Scene
from workbench.scene.faces import LARGEST_NET
from workbench.scene.paths import value_at
from workbench.units import ratio

_NO_LENS = later(
    "The {optic} does not fit the new outline. Start designs another one; Undo restores it."
)
_ANOTHER_FACE = later(
    "The entrance face is freeform now, and still flat. Continue shapes both faces; Undo reverts."
)
_ONE_FACE_LESS = later(
    "The entrance face is flat now; the exit face is unchanged. Continue reshapes the exit face; "
    "Undo reverts."
)
_WITHIN_LIMITS = later(
    "The {optic} was moved by up to {moved} to keep the new limits. Continue improves it; Undo "
    "reverts."
)
_OTHER_NET = later(
    "The net now has {size} control points; the {optic} was transferred to it. Continue improves "
    "it; Undo reverts."
)
_A_START = later(
    "The {optic} was designed for another task. Continue starts from it; Start over does not"
)
RUN_FIRST = later("Not possible during a run. Stop it first")


class Notice(QObject):
    """A message about an edit, withdrawn as soon as the document has another session."""

    def __init__(self, document: Document, messages: Messages, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._messages, self._text = document, messages, ""
        self._about: Session | None = None  # the session during which the message stays
        document.session_changed.connect(self._withdraw_for)
        document.edited.connect(self._report)

    @abstractmethod
    def _report(self, before: Session, after: Session) -> None:
        """Report what an edit did, if a person has to know."""

    def _note(self, text: str, *offers: Offer) -> None:
        self._text = text
        guarded = ((name, partial(self._accept, name, act)) for name, act in offers)
        self._messages.note(text, *guarded)

    def _accept(self, name: str, act: Callable[[], object]) -> None:
        """Do what a button offers; a run goes on with the task that it began with."""
        if self._document.in_run:
            self._note(tr(RUN_FIRST), (name, act))
        else:
            act()

    def _withdraw_for(self, session: Session) -> None:
        if session is not self._about:
            self._messages.withdraw(self._text)
            self._text = ""


class RefusedFields(QObject):
    """Reports refused fields, as long as there are any."""

    def __init__(self, forms: Forms, messages: Messages, parent: QObject) -> None:
        super().__init__(parent)
        self._forms, self._messages, self._text = forms, messages, ""
        forms.refusals_changed.connect(self._follow)

    def show(self) -> None:
        self._messages.withdraw(self._text)
        first, *others = self._forms.refusals
        more = tr(" ({count} more refused)").format(count=len(others)) if others else ""
        self._text = tr("{first}{others}. Correct it, or press Esc.").format(
            first=first, others=more
        )
        self._messages.warn(self._text)

    def _follow(self) -> None:
        if any(notice.text == self._text for notice in self._messages.notices):
            if self._forms.refusals:
                self.show()
            else:
                self._messages.withdraw(self._text)


class PostponedEdits(QObject):
    """Reports which edits wait for the end of a run, and offers to stop it."""

    def __init__(
        self, forms: Forms, control: RunControl, messages: Messages, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._forms, self._control, self._messages, self._text = forms, control, messages, ""
        forms.postponed.connect(self._offer)

    def make(self) -> None:
        self._messages.withdraw(self._text)
        self._forms.make_postponed_edits()

    def remind(self, sentence: str) -> None:
        """Show a sentence, and that edits still wait."""
        self._offer(f"{sentence} {self._forms.postponed_text}")

    def _offer(self, sentence: str) -> None:
        self._messages.withdraw(self._text)
        self._text = sentence
        stop = (tr("Stop and apply"), self._control.runner.stop)
        self._messages.note(sentence, stop, (tr("Discard"), self._forms.drop_postponed_edits))


class CarriedLens(Notice):
    """Reports how an edit of the task changed the lens.

    A lens that another control net cannot represent is approximated. The message gives the
    deviation and offers the nearest net that represents it exactly.
    """

    noted = Signal(str)

    def __init__(self, document: Document, messages: Messages, parent: QObject) -> None:
        super().__init__(document, messages, parent)
        # Whether live update designs another lens for a session: then there is no message.
        self.followed: Callable[[Session], bool] = lambda _: False
        # Where the last change of a net began: another change right after it replaces it.
        self._before: Session | None = None
        self._noted: tuple[Session, str] | None = None  # once for all edits of one step

    def _report(self, before: Session, after: Session) -> None:
        if before is self._about and self._before is not None:
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
            self._report_once(after, self._named(_NO_LENS))
        elif set(new) - set(old):
            self._report_once(after, tr(_ANOTHER_FACE))
        elif set(old) - set(new):
            self._report_once(after, tr(_ONE_FACE_LESS))
        elif changed is None and new is not old:
            moved = max(float(np.abs(new[face] - old[face]).max()) for face in new)
            words = written(moved, after.scene.unit, 2)
            self._report_once(after, self._named(_WITHIN_LIMITS).format(moved=words))
        elif changed is not None and changed.automatic:
            size = _size(changed.new.shape)
            self._report_once(after, self._named(_OTHER_NET).format(size=size))
        elif changed is not None:
            self._before, self._about = before, after
            if changed.new.contains(changed.old):
                text = tr("{name} is unchanged on {size} control points.")
                self._note(text.format(size=_size(changed.new.shape), name=changed.name))
            else:
                off = deviation(changed.old, old[changed.face], changed.new, new[changed.face])
                self._offer_exact(before, after, changed, off)
        elif before.result is not None:
            text = self._named(_A_START)
            if self._noted is None or self._noted[0] is not before or self._noted[1] != text:
                self._noted = before, text
                self.noted.emit(text)

    def _offer_exact(
        self, before: Session, after: Session, changed: "_ChangedNet", off: float
    ) -> None:
        wanted, unit = changed.new.shape, after.scene.unit
        exact = nearest_finer(changed.old, wanted, LARGEST_NET)
        offers: list[Offer] = []
        if exact != changed.old.shape:
            use = partial(self._use, before, after, changed.path, exact)
            offers = [(tr("Use {size}, exact").format(size=_size(exact)), use)]
        text = tr(
            "{name} is approximated on {size} control points: deviation up to {off}. Continue "
            "improves it; Undo reverts."
        )
        text = text.format(size=_size(wanted), name=changed.name, off=written(off, unit, 2))
        self._note(text, *offers)

    def _use(self, before: Session, after: Session, path: str, size: tuple[int, int]) -> None:
        text = tr("change of {name}").format(name=tr("control points"))
        scene = edited_scene(after.scene, [Edit(path, text, {path: list(size)})])
        self._document.change(before.with_scene(scene, after.target), text)

    def _report_once(self, after: Session, text: str) -> None:
        self._before, self._about = None, after
        self._note(text)

    def _named(self, text: str) -> str:
        return tr(text, optic=self._document.session.scene.optic.called)


class _ChangedNet(NamedTuple):
    face: str
    old: ControlNet
    new: ControlNet
    path: str
    name: str
    automatic: bool


def _changed_net(before: Scene, after: Scene) -> _ChangedNet | None:
    old, new = nets_of(before), nets_of(after)
    changed = [face for face in new if face in old and old[face] != new[face]]
    if not changed:
        return None
    *_, face = changed
    if len(after.optics) > 1:
        name = capitalised(tr(after.face_in_words(face)))
    elif face == after.optic.designed_face:
        name = tr("The {optic}", optic=after.optic.called)
    else:
        name = tr("The entrance face")
    path = f"{after.face_path(face)}.control_points"
    automatic = isinstance(value_at(after, path), AutoNet)
    return _ChangedNet(face, old[face], new[face], path, name, automatic)


def _size(shape: tuple[int, int]) -> str:
    return f"{shape[0]} × {shape[1]}"


class TargetImage(Notice):
    """Reports that the target's image is not stored, or has changed on disk."""

    def report(self) -> None:
        session = self._document.session
        if self._document.path is None:  # drawn from its file a moment ago
            self._report_if_not_kept(session)
            self._report_remarks(session)
        self._report_if_changed(session)

    def _report(self, before: Session, after: Session) -> None:
        if after.target is before.target:
            return
        if after.scene.image != before.scene.image:
            self._report_if_not_kept(after)
        if after.picture_remarks != before.picture_remarks:
            self._report_remarks(after)
        self._report_if_changed(after)

    def _report_if_not_kept(self, session: Session) -> None:
        why = why_not_kept(session.scene, session.picture)
        if why:
            self._messages.note(why)

    def _report_remarks(self, session: Session) -> None:
        if session.picture_remarks:
            self._messages.note("; ".join(map(tr, session.picture_remarks)))

    def _report_if_changed(self, session: Session) -> None:
        if changed_on_disk(session.scene, session.picture):
            text = tr("{image} has changed on disk. The design keeps the earlier picture.")
            reload = (tr("Reload"), self._reload)
            self._note(text.format(image=session.scene.image), reload)

    def _reload(self) -> None:
        try:
            self._document.read_image_again()
        except Refused as refused:
            self._messages.warn(error_text(refused))


class UnitChange(Notice):
    """Reports that a change of unit converted all lengths, and offers to keep the numbers."""

    def _report(self, before: Session, after: Session) -> None:
        old, new = before.scene.unit, after.scene.unit
        if old == new:
            return
        self._about = after
        text = tr("All lengths were converted: 1 {old} = {ratio:.6g} {new}.")
        text = text.format(old=old, ratio=float(ratio(old, new)), new=new)
        self._note(text, (tr("Keep the numbers"), partial(self._keep_numbers, before, after)))

    def _keep_numbers(self, before: Session, after: Session) -> None:
        scene = before.scene.model_copy(update={"unit": after.scene.unit})
        self._document.change(before.with_scene(scene, before.target), tr("change of unit alone"))
