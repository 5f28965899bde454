"""State of a window, shown by its commands, forms and status bar."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtGui import QKeySequence

from ui.commands.table import LOCKS
from ui.run.control import CurrentLens
from ui.window.docks import EarlyParts
from ui.window.edit_notices import RUN_FIRST
from ui.words import capitalised, later, tr
from workbench.design.snapshot import STOPPED, has_converged
from workbench.scene import Element

if TYPE_CHECKING:
    from ui.window.loaded_parts import LoadedParts

_USES_LENS = ("export", "cut", "plan", "photograph", "inspect", "report")

# Not while a run works on the design as it was when it began.
_CHANGING = (
    *LOCKS,
    "new",
    "workspace_start",
    "open",
    "restore_run",
    "delete_run",
    "mark_region",
    "undo",
    "redo",
    "revert",
)
_ONE_FACE = later("There is only one freeform face; Freeform entrance face adds a second one")


@dataclass(frozen=True)
class Situation:
    """Conditions that decide which commands are available."""

    optic: Element
    state: str
    has_lens: bool
    lens: str
    can_undo: bool
    can_redo: bool
    can_revert: bool
    has_refused: bool
    following: bool

    @property
    def two_faces(self) -> bool:
        return self.optic.entrance.shape == "bspline"

    @property
    def editable(self) -> bool:
        return self.state in ("loading", "idle")

    @property
    def under_way(self) -> bool:
        return self.state in ("running", "paused")

    @property
    def resting(self) -> bool:
        """Whether the shown lens is final."""
        return self.state in ("idle", "paused")

    def texts(self) -> dict[str, str]:
        return {
            "second_face": tr("Flat &entrance face")
            if self.two_faces
            else tr("Freeform &entrance face"),
            "start": tr("&Start over") if self.has_lens else tr("&Start"),
            "pause": tr("&Resume") if self.state == "paused" else tr("&Pause"),
        }

    def allows(self) -> dict[str, bool]:
        """Availability of commands; those left out are always available."""
        idle, under_way = self.state == "idle", self.under_way
        return {
            **dict.fromkeys(_CHANGING, self.editable),
            **dict.fromkeys(_USES_LENS, self.has_lens or under_way),
            "second_face": self.optic.most_faces > 1,
            "other_face": self.two_faces,
            "start": idle,
            "continue": idle and (self.has_lens or self.following),
            "pause": under_way,
            "stop": under_way,
            "restore_run": idle,
            "delete_run": idle,
            "check": self.resting,
            "revert": self.editable and self.can_revert,
            "undo": self.has_refused or (self.editable and self.can_undo),
            "redo": self.editable and self.can_redo,
        }

    def reasons(self) -> dict[str, str]:
        """Reasons of unavailable commands, and the lens that others use."""
        called = self.optic.called
        no_lens = (
            "" if self.has_lens else tr("There is no {optic} yet; Start designs one", optic=called)
        )
        used = tr("the best {optic} so far", optic=called) if self.under_way else self.lens
        return {
            **dict.fromkeys(_CHANGING, "" if self.editable else tr(RUN_FIRST)),
            **dict.fromkeys(_USES_LENS, tr("Uses {lens}").format(lens=used) if used else no_lens),
            "continue": "" if self.following else no_lens,
            **({"undo": ""} if self.has_refused else {}),
            "second_face": ""
            if self.optic.most_faces > 1
            else tr("A {optic} has one freeform face", optic=called),
            "other_face": "" if self.two_faces else tr(_ONE_FACE),
        }


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
    """Updates commands, forms and status bar."""

    def __init__(self, early: EarlyParts, lens: CurrentLens) -> None:
        self._early, self._document, self._lens = early, early.document, lens
        self._has_lens = self._follows = False  # as shown last
        self.loaded: LoadedParts | None = None

    def show(self) -> None:
        early, now = self._early, self._situation()
        self._has_lens, self._follows = now.has_lens, now.following
        commands = early.commands
        commands.name_optic(now.optic.called)
        commands.allow(now.allows())
        commands.explain(now.reasons())
        commands.reword(now.texts() | self._undo_texts())
        commands["pause"].setChecked(now.state == "paused")
        early.forms.show_run(paused=now.state == "paused")
        early.panes.history.setEnabled(now.editable)
        if self.loaded is not None:
            self.loaded.allow(resting=now.resting, go_on=now.state == "idle")
        self._show_status(now)

    def show_following(self, text: str) -> None:
        """Show the progress of live update, many times a second."""
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
        elif now.state == "idle" and result is not None and has_converged(result.ended):
            self._early.status.show_state(tr("Done: no further gain"))
        elif now.state == "idle" and ended:
            self._early.status.show_state(capitalised(ended))
        else:
            self._early.status.show_state(tr(_STATES[now.state]))

    def _stopped(self, called: str) -> str:
        go_on = self._early.commands["continue"]
        return tr("Stopped; {command} ({keys}) improves the {optic}", optic=called).format(
            command=go_on.text().replace("&", ""),
            keys=go_on.shortcut().toString(QKeySequence.SequenceFormat.NativeText),
        )
