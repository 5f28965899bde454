"""What is said of a way to lose light."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from workbench.said import Said

if TYPE_CHECKING:
    from workbench.scene.task import Scene


class Loss(NamedTuple):
    """What is said of a way to lose light.

    Attributes
    ----------
    title, tip : str
        Its name for people, and what it is; "{receiver}" stands for what the receiver is called.
    where : str
        Where such light goes, after "of the light, 10 %".
    cure : str
        What brings it to the receiver, as a sentence without its end; "{flatter}" stands for a
        flatter base, where there is one.
    always : bool
        Whether every account has it, and with that every file of version 1.
    """

    title: str
    tip: str
    where: str
    cure: str
    always: bool = False

    def cure_in(self, scene: "Scene") -> Said:
        """The cure for a scene."""
        flatter = Said("") if scene.optic.base.shape == "flat" else Said("a flatter base, ")
        return Said(self.cure, receiver=scene.receiver.called, flatter=flatter)


@dataclass(frozen=True)
class TakesLight:
    """Mark of a field that takes light unless it has its default.

    Attributes
    ----------
    name : str
        Of what it takes, in the light account.
    loss : Loss
        What is said of it.
    """

    name: str
    loss: Loss
