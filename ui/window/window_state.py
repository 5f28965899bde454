"""What goes on in a window, shown by its commands, forms and status bar."""

from typing import TYPE_CHECKING

from PySide6.QtGui import QKeySequence

from ui.commands.availability import Situation
from ui.run.lens_on_show import LensOnShow
from ui.window.early_parts import EarlyParts
from ui.words import later, tr
from workbench.design.endings import STOPPED

if TYPE_CHECKING:
    from ui.window.loaded_parts import LoadedParts

_STATES = later(
    {
        "loading": "Loading…",
        "idle": "Ready",
        "running": "Designing…",
        "paused": "Paused",
        "stopping": "Stopping…",
    }
)


class WindowState:
    """Allows what can be done now, and says what is being done, whenever the window calls it.

    Parameters
    ----------
    early : EarlyParts
        Its commands, forms and status bar show the state.
    lens : LensOnShow
        What would be exported.

    Attributes
    ----------
    loaded : LoadedParts, optional
        Runner and views, while the window has them.
    """

    def __init__(self, early: EarlyParts, lens: LensOnShow) -> None:
        self._early, self._document, self._lens = early, early.document, lens
        self._has_lens = self._follows = False  # as shown last
        self.loaded: LoadedParts | None = None

    def show(self) -> None:
        """What can be done depends on the run, on the result and on the undo stack."""
        early, now = self._early, self._situation()
        self._has_lens, self._follows = now.has_lens, now.following
        commands = early.commands
        commands.name_optic(now.optic.called)
        commands.allow(now.allows())
        commands.explain(now.reasons())
        commands.reword(now.texts() | self._undo_texts())
        commands["pause"].setChecked(now.state == "paused")
        early.forms.set_running(not now.editable, paused=now.state == "paused")
        early.workspace.history.setEnabled(now.editable)
        if self.loaded is not None:
            self.loaded.allow(look=now.resting, go_on=now.state == "idle")
        self._show_status(now)

    def show_following(self, text: str) -> None:
        """Say how far a lens is, many times a second; little else changes by it."""
        has_lens = self._document.session.heights is not None
        if text and self._follows and self._has_lens == has_lens:
            self._early.status.go_on(text)
        else:
            self.show()

    def _situation(self) -> Situation:
        document, stack = self._document, self._document.undo_stack
        return Situation(
            optic=document.session.scene.optic,
            state="loading" if self.loaded is None else self.loaded.state,
            has_lens=document.session.heights is not None,
            lens=self._lens.text,
            can_undo=stack.canUndo(),
            can_redo=stack.canRedo(),
            can_revert=document.path is not None and document.dirty,
            has_refused=self._early.forms.refused,
            following=self.loaded is not None and bool(self.loaded.follow.text),
        )

    def _undo_texts(self) -> dict[str, str]:
        stack = self._document.undo_stack
        steps = self._early.forms.refused_entry or stack.undoText(), stack.redoText()
        undo, redo = (text.replace("&", "&&") for text in steps)
        return {
            "undo": tr("&Undo {undo}").format(undo=undo) if undo else tr("&Undo"),
            "redo": tr("&Redo {redo}").format(redo=redo) if redo else tr("&Redo"),
        }

    def _show_status(self, now: Situation) -> None:
        result = self._document.session.result
        following = "" if self.loaded is None else self.loaded.follow.text
        ended = "" if result is None else tr(result.ended)
        if following:
            self._early.status.go_on(following)
        elif now.state == "idle" and result is not None and result.ended == STOPPED:
            self._early.status.show_state(self._stopped(now.optic.called))
        elif now.state == "idle" and ended:
            self._early.status.show_state(ended[0].upper() + ended[1:])
        else:
            self._early.status.show_state(tr(_STATES[now.state]))

    def _stopped(self, called: str) -> str:
        """Of a lens that can still get better, and by what."""
        go_on = self._early.commands["continue"]
        return tr("Stopped: {command} ({keys}) can make the {optic} better", optic=called).format(
            command=go_on.text().replace("&", ""),
            keys=go_on.shortcut().toString(QKeySequence.SequenceFormat.NativeText),
        )
