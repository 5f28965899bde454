"""Messages after a run: coarse net, lost light, narrow bounds, total reflection."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ui.background import Background, Task
from ui.document.document import Document
from ui.panels.edits import Edit, edited_scene
from ui.widgets.messages import MessageBar, Offer
from ui.window.edit_notices import Notice
from ui.words import later, tr
from workbench.design.limits import Shortfall, wider_entrance
from workbench.files.session import Session
from workbench.messages import Message
from workbench.scene.losses import kind_and_element

if TYPE_CHECKING:
    from ui.document.frame import Frame
    from ui.run.control import RunControl
    from workbench.geometry.faces import ControlHeights
    from workbench.optics.paths import TotalReflection

_MORE = 0.05  # of a needed range, at each end
_LEAST = 1e-6  # of the light; less is rounding


class CoarseNetNotice(Notice):
    """Reports after a run that the net is too coarse, and offers a finer one."""

    def __init__(
        self,
        document: Document,
        control: "RunControl",
        messages: MessageBar,
        start_over: Callable[[], object],
    ) -> None:
        super().__init__(document, messages, control)
        self._start_over = start_over
        control.ended.connect(self._report)

    def _report(self) -> None:
        # Late: torch comes with it, and the window shows before that.
        from workbench.design.checks import coarse_net

        session = self._document.session
        if session.result is None or self._messages.taken:
            return
        coarse = coarse_net(session.scene, session.target, session.result)
        if coarse is not None:
            self._warn(tr(coarse.sentence), (tr("Refine and start over"), self._refine))

    def _refine(self) -> None:
        scene = self._document.session.scene
        path = f"{scene.face_path()}.control_points"
        edit = Edit(path, tr("automatic control points"), {path: "auto"})
        self._document.edit(edited_scene(scene, [edit]), edit.text, "")
        self._start_over()


class LostLightNotice(Notice):
    """Reports after a run why little light reaches the receiver, and a remedy."""

    def __init__(self, document: Document, control: "RunControl", messages: MessageBar) -> None:
        super().__init__(document, messages, control)
        control.ended.connect(self.report)

    def report(self) -> None:
        scene, result = self._document.session.scene, self._document.session.result
        advice = None if result is None else result.state.account.advice(scene)
        self._text = "" if advice is None else tr(advice)
        if self._text and not self._messages.taken:
            self._messages.warn(self._text)


class ShortfallNotice(Notice):
    """Reports limits that are too narrow, in a run or an open lens, and offers wider ones."""

    def __init__(
        self,
        document: Document,
        control: "RunControl",
        messages: MessageBar,
        start_over: Callable[[], object],
        go_on: Callable[[], object],
    ) -> None:
        super().__init__(document, messages, control)
        self._control, self._start_over, self._go_on = control, start_over, go_on
        self._shown: Shortfall | None = None
        self._text_of_run = ""
        self._stopped_for: Shortfall | None = None
        control.runner.frame_ready.connect(self._report_in_run)
        control.ended.connect(self._end)
        self.follow(document.session)

    def _report_in_run(self, frame: "Frame") -> None:
        shortfall = frame.state.shortfall
        if shortfall is None or not self._control.busy or self._text_of_run:
            return
        self._text_of_run = f"{self._sentence(shortfall)} {tr('The run goes on within them.')}"
        widen = (tr("Stop and widen"), partial(self._stop_and_widen, shortfall))
        self._warn(self._text_of_run, *([widen] if self._wider(shortfall) else []))

    def _end(self) -> None:
        # The best lens may keep the limits; otherwise `follow` has reported already.
        self._messages.withdraw(self._text_of_run)
        self._text_of_run = ""
        if self._stopped_for is not None:
            shortfall, self._stopped_for = self._stopped_for, None
            self._widen(shortfall)

    def _withdraw_for(self, session: Session) -> None:
        self.follow(session)

    def follow(self, session: Session) -> None:
        """Report on the open lens; remove the report on another one."""
        shortfall = None if session.result is None else session.result.state.shortfall
        if shortfall is self._shown:
            return
        self._messages.withdraw(self._text)
        self._shown, self._text = shortfall, ""
        if shortfall is not None:
            self._warn(self._sentence(shortfall), *self._offers(shortfall))

    def _offers(self, shortfall: Shortfall) -> list[Offer]:
        if self._wider(shortfall):
            return [(tr("Widen"), partial(self._widen, shortfall))]
        if shortfall.cause == "height_range":  # the next run takes a wider one by itself
            return [(tr("Continue"), self._go_on)]
        return []

    def _wider(self, shortfall: Shortfall) -> Edit | None:
        scene = self._document.session.scene
        path = f"{scene.face_path()}.height_range"
        if shortfall.cause == "height_range" and scene.optic.height_range is not None:
            return Edit(path, tr("automatic height range"), {path: None})
        if shortfall.cause == "height_range" and shortfall.needed is not None:
            low, high = shortfall.needed
            more = _MORE * (high - low)
            return Edit(path, tr("wider height range"), {path: [low - more, high + more]})
        if shortfall.cause == "entrance_range" and (wider := wider_entrance(scene)) is not None:
            path = f"{scene.optic_path}.faces[0].height_range"
            return Edit(path, tr("wider entrance range"), {path: list(wider)})
        return None

    def _sentence(self, shortfall: Shortfall) -> str:
        scene = self._document.session.scene
        if shortfall.cause == "height_range" and self._wider(shortfall):  # the cure is a button
            return f"{tr(shortfall.sentence(scene))}."
        return f"{tr(shortfall.in_full(scene))}."

    def _stop_and_widen(self, shortfall: Shortfall) -> None:
        self._stopped_for = shortfall
        self._control.runner.stop()

    def _widen(self, shortfall: Shortfall) -> None:
        edit = self._wider(shortfall)
        if edit is None:  # the scene was edited meanwhile
            return
        scene = self._document.session.scene
        self._document.edit(edited_scene(scene, [edit]), edit.text, "")
        scene = self._document.session.scene
        change = tr("The height range is automatic now")
        if shortfall.cause == "height_range" and scene.optic.height_range is not None:
            low, high = scene.optic.height_range
            change = tr("The height range is {low:.3g} to {high:.3g} {unit} now").format(
                low=low, high=high, unit=scene.unit
            )
        elif shortfall.cause == "entrance_range":
            low, high = scene.optic.entrance_offsets
            change = tr("The entrance range is {low:.3g} to {high:.3g} {unit} now").format(
                low=low, high=high, unit=scene.unit
            )
        # Continuing from a lens that was clipped at its bounds takes long and often ends worse.
        text = tr(
            "{change}; the {optic} is unchanged. Start over usually gives the better result.",
            optic=scene.optic.called,
        )
        start_over, go_on = (tr("Start over"), self._start_over), (tr("Continue"), self._go_on)
        self._note(text.format(change=change), start_over, go_on)


class TotalReflectionNotice(QObject):
    """Reports after a run where light is totally reflected."""

    reported = Signal(str)
    withdrawn = Signal(str)  # as reported, of a lens that is no longer there
    located = Signal(object, object)  # ControlHeights, points (n, 3)

    def __init__(self, document: Document, control: "RunControl") -> None:
        super().__init__(control)
        self._document = document
        self._text = ""
        self._heights: ControlHeights | None = None  # of what the text is about
        self._background = Background(later("search for total reflection"), self)
        self._background.done.connect(self._show)
        self._background.failed.connect(self.reported)
        control.ended.connect(self.report)
        document.session_changed.connect(self._withdraw)

    def _withdraw(self, session: Session) -> None:
        self._background.cancel()
        if session.heights != self._heights:
            self.withdrawn.emit(self._text)

    def report(self) -> None:
        session = self._document.session
        result = session.result
        lost = {} if result is None else result.state.account.lost
        total = (f for key, f in lost.items() if kind_and_element(key)[0] == "total_reflection")
        if sum(total) > _LEAST:
            self._background.begin(partial(_find, session), session)

    def close(self) -> None:
        self._background.close()

    def _show(self, session: Session, found: "TotalReflection | None") -> None:
        heights = session.heights
        if found is None or heights is None:
            return
        self.located.emit(heights, found.places)
        message = Message(
            "{where}, as marked in the 3D scene: {cure}.",
            where=found.sentence(session.scene),
            cure=found.loss.cure_in(session.scene),
        )
        self._text, self._heights = tr(message), heights
        self.reported.emit(self._text)


def _find(session: Session, task: Task) -> "TotalReflection | None":
    # Late: torch comes with it, and the window shows before that.
    from workbench.optics.paths import total_reflection

    heights = session.heights
    return None if heights is None else total_reflection(session.scene, heights)
