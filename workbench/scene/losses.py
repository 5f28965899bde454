"""What is said of a way to lose light."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from workbench.messages import Message

if TYPE_CHECKING:
    from workbench.scene.task import Scene


class Loss(NamedTuple):
    """What is said of a way to lose light."""

    # Its name for people, and what it is; "{receiver}" stands for what the receiver is called.
    title: str
    tip: str
    where: str  # where such light goes, after "of the light, 10 %"
    # What brings it to the receiver, as a sentence without its end; "{flatter}" stands for a
    # flatter base, where there is one.
    cure: str
    always: bool = False  # whether every account has it, and with that every file of version 1

    def cure_in(self, scene: "Scene") -> Message:
        """The cure for a scene."""
        flatter = Message("") if scene.optic.base.shape == "flat" else Message("a flatter base, ")
        return Message(self.cure, receiver=scene.receiver.called, flatter=flatter)


@dataclass(frozen=True)
class TakesLight:
    """Mark of a field that takes light unless it has its default."""

    name: str  # of what it takes, in the light account
    loss: Loss  # what is said of it
