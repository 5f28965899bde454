"""What a person may do now."""

from dataclasses import dataclass

from ui.commands.table import LOCKS, NEW

# Not while a run works on the design as it was when it began.
_CHANGING = [*NEW, "gallery", "open", "save", "save_as"]


@dataclass(frozen=True)
class Situation:
    """What decides about it.

    Attributes
    ----------
    state : str
        Of the run: "idle", "running", "paused" or "stopping"; "loading" while there cannot be one.
    designed : bool
        Whether there is a lens that was designed for the task.
    has_lens : bool
        Whether there is one at all, if only to start from.
    can_undo, can_redo : bool
        Whether the undo stack has a step in that direction.
    can_revert : bool
        Whether the design has a file and differs from it.
    """

    state: str
    designed: bool
    has_lens: bool
    can_undo: bool
    can_redo: bool
    can_revert: bool

    @property
    def editable(self) -> bool:
        """Whether the design may be changed."""
        return self.state in ("loading", "idle")

    @property
    def resting(self) -> bool:
        """Whether the lens on show stays as it is until somebody asks for another."""
        return self.state in ("idle", "paused")

    def texts(self) -> dict[str, str]:
        """What commands are called that do one thing or another."""
        return {
            "start": "&Start over" if self.has_lens else "&Start",
            "pause": "&Resume" if self.state == "paused" else "&Pause",
        }

    def allows(self) -> dict[str, bool]:
        """Which of the commands are available; those that are left out always are."""
        idle, under_way = self.state == "idle", self.state in ("running", "paused")
        return {
            **dict.fromkeys(_CHANGING, self.editable),
            **dict.fromkeys(LOCKS, self.editable),
            "start": idle,
            "continue": idle and self.has_lens,
            "pause": under_way,
            "stop": under_way,
            "restore_run": idle,
            "delete_run": idle,
            "export": self.designed,
            "report": self.designed,
            "check": self.resting,
            "revert": self.editable and self.can_revert,
            "undo": self.editable and self.can_undo,
            "redo": self.editable and self.can_redo,
        }
