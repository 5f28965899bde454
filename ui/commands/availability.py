"""Availability of commands."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ui.commands.table import LOCKS, NEW
from ui.words import later, tr

if TYPE_CHECKING:
    from workbench.scene import Optic

_TAKES_LENS = ("export", "cut", "report")

# Not while a run works on the design as it was when it began.
_CHANGING = (
    *NEW,
    *LOCKS,
    "new",
    "gallery",
    "open",
    "restore_run",
    "delete_run",
    "mark_region",
    "undo",
    "redo",
    "revert",
)
_ONE_FACE = later("There is one freeform face: Freeform entrance face gives a lens a second one")
_RUN_FIRST = later(
    "Not while a run goes on: it works on the design as it was when it began. Stop it first"
)


@dataclass(frozen=True)
class Situation:
    """State of the window that decides which commands are available.

    ``state`` is that of the run ("idle", "running", "paused", "stopping") or "loading"; ``lens``
    describes the shown lens, empty if there is none; ``has_refused`` says whether a field has a
    refused entry, which undo removes first.
    """

    optic: "Optic"
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
        """Whether the entrance face is freeform too."""
        return self.optic.entrance.shape == "freeform"

    @property
    def editable(self) -> bool:
        """Whether the design may be changed."""
        return self.state in ("loading", "idle")

    @property
    def under_way(self) -> bool:
        """Whether a run continues that was not stopped."""
        return self.state in ("running", "paused")

    @property
    def resting(self) -> bool:
        """Whether the shown lens does not change by itself."""
        return self.state in ("idle", "paused")

    def texts(self) -> dict[str, str]:
        """Texts of commands that depend on the state."""
        return {
            "second_face": tr("Flat &entrance face")
            if self.two_faces
            else tr("Freeform &entrance face"),
            "start": tr("&Start over") if self.has_lens else tr("&Start"),
            "pause": tr("&Resume") if self.state == "paused" else tr("&Pause"),
        }

    def allows(self) -> dict[str, bool]:
        """Availability of commands; missing ones are always available."""
        idle, under_way = self.state == "idle", self.under_way
        return {
            **dict.fromkeys(_CHANGING, self.editable),
            **dict.fromkeys(_TAKES_LENS, self.has_lens or under_way),
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
        """Why commands are disabled, and what others apply to."""
        called = self.optic.called
        no_lens = (
            "" if self.has_lens else tr("There is no {optic} yet: Start designs one", optic=called)
        )
        taken = tr("the best {optic} so far", optic=called) if self.under_way else self.lens
        return {
            **dict.fromkeys(_CHANGING, "" if self.editable else tr(_RUN_FIRST)),
            **dict.fromkeys(
                _TAKES_LENS, tr("Takes {lens}").format(lens=taken) if taken else no_lens
            ),
            "continue": "" if self.following else no_lens,
            **({"undo": ""} if self.has_refused else {}),
            "second_face": ""
            if self.optic.most_faces > 1
            else tr("A {optic} has one freeform face", optic=called),
            "other_face": "" if self.two_faces else tr(_ONE_FACE),
        }
