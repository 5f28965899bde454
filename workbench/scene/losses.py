"""Ways to lose light, and their keys in the light account."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from workbench.messages import Message

if TYPE_CHECKING:
    from workbench.scene.task import Scene


class Loss(NamedTuple):
    """A way to lose light: at any element of a kind, or at one element of a train."""

    # Its name for people, and what it is; "{receiver}" stands for what the receiver is called.
    title: str
    tip: str
    where: str  # where such light goes, after "of the light, 10 %"
    # What brings it to the receiver, as a sentence without its end; "{flatter}" stands for a
    # flatter base, where there is one.
    cure: str
    always: bool = False  # whether every account has it, and with that every file of version 1
    element: str = ""  # name of the element where light is lost, in a train of several elements

    def title_for(self, receiver: str) -> Message:
        """Return the title, with what the receiver is called and the name of the element."""
        return self._named(self.title.format(receiver=receiver))

    @property
    def goes(self) -> Message:
        """Where such light goes, with the name of the element."""
        return self._named(self.where)

    def cure_in(self, scene: "Scene") -> Message:
        """Return the cure for a scene."""
        optic = next((each for each in scene.elements if each.name == self.element), scene.optic)
        flat = not optic.designed or optic.base.shape == "flat"
        flatter = Message("") if flat else Message("a flatter base, ")
        return Message(self.cure, receiver=scene.receiver.called, flatter=flatter)

    def _named(self, text: str) -> Message:
        words = Message(text)
        if not self.element:
            return words
        return Message("{loss} ({element})", loss=words, element=self.element)


@dataclass(frozen=True)
class TakesLight:
    """Mark of a field that takes light unless it has its default."""

    name: str  # of what it takes, in the light account
    loss: Loss  # its texts


def key_of(kind: str, element: str = "") -> str:
    """Return the key of a loss in the light account.

    `kind`: the loss; `element`: name of the element where light is lost, in a train of several.
    """
    return f"{kind}@{element}" if element else kind


def kind_and_element(key: str) -> tuple[str, str]:
    """Return what `key_of` made a key of."""
    kind, _, element = key.partition("@")
    return kind, element


LENS_LOSSES: Mapping[str, Loss] = {
    "missed_lens": Loss(
        "Missed the lens",
        "Light that passes the entrance face by. The cone of a point source is round and just "
        "covers the rectangle around the face; of that, an elliptic lens leaves the corners open.",
        "misses the lens",
        "a larger lens catches it",
        always=True,
    ),
    "left_side": Loss(
        "Out of the side",
        "Light that entered the lens so slanted that it meets a side wall before the exit face.",
        "leaves by the side",
        "a thinner lens, or a source farther away or nearer to the axis, keeps it",
        always=True,
    ),
    "total_reflection": Loss(
        "Totally reflected",
        "Light that meets the exit face too steeply to leave the lens there.",
        "is totally reflected",
        "{flatter}thicker stock, a lower index or a target that needs less bending lets it out",
        always=True,
    ),
    "fresnel_entrance": Loss(
        "Reflected on entry",
        "The part that the entrance face reflects of the light that it refracts.",
        "is reflected at the entrance",
        "an antireflection coating, a lower index or a source nearer to the axis lets it in",
        always=True,
    ),
    "fresnel_exit": Loss(
        "Reflected on exit",
        "The part that the exit face reflects of the light that it refracts.",
        "is reflected at the exit",
        "an antireflection coating, {flatter}a lower index or a target that needs less bending "
        "lets it out",
        always=True,
    ),
}
"""At any lens."""
