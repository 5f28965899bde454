"""The account of all light: what is on the screen, and what is lost, by name.

A new way to lose light is an entry in `LOSSES`, and its name where an element finds it. Dock,
report, figures and files take all they say of it from here.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from workbench.scene import AnyReceiver, Scene


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
    optic : str
        Which kind of optic loses light so, as that is called; empty for all.
    """

    title: str
    tip: str
    where: str
    cure: str
    always: bool = False
    optic: str = ""

    def cure_in(self, scene: Scene) -> str:
        """The cure for a scene."""
        flatter = "" if scene.optic.base.shape == "flat" else "a flatter base, "
        return self.cure.format(receiver=scene.receiver.called, flatter=flatter)


LOSSES: Mapping[str, Loss] = {
    "off_screen": Loss(
        "Missed the {receiver}",
        "Light that passes the optic and the {receiver} by. One that sends much light here "
        "wastes it, or has more than its surface can bend.",
        "passes beside it",
        "a larger {receiver} catches it",
        always=True,
    ),
    "missed_lens": Loss(
        "Missed the lens",
        "Light that passes the entrance face by. The cone of a point source is round and just "
        "covers the rectangle around the face; of that, an elliptic lens leaves the corners open.",
        "misses the lens",
        "a larger lens catches it",
        always=True,
        optic="lens",
    ),
    "missed_mirror": Loss(
        "Missed the mirror",
        "Light that passes the mirror by: between it and the rim of the light's cone, and through "
        "the corners of the rectangle around an elliptic mirror.",
        "misses the mirror",
        "a larger mirror catches it",
        optic="mirror",
    ),
    "absorbed_mirror": Loss(
        "Absorbed by the mirror",
        "The part of the light on the mirror that it does not reflect.",
        "is absorbed by the mirror",
        "a coating with a higher reflectance reflects it",
        optic="mirror",
    ),
    "left_side": Loss(
        "Out of the side",
        "Light that entered the lens so slanted that it meets a side wall before the exit face.",
        "leaves by the side",
        "a thinner lens, or a source farther away or nearer to the axis, keeps it",
        always=True,
        optic="lens",
    ),
    "total_reflection": Loss(
        "Totally reflected",
        "Light that meets the exit face too steeply to leave the lens there.",
        "is totally reflected",
        "{flatter}thicker stock, a lower index or a target that needs less bending lets it out",
        always=True,
        optic="lens",
    ),
    "fresnel_entrance": Loss(
        "Reflected on entry",
        "The part that the entrance face reflects of the light that it refracts.",
        "is reflected at the entrance",
        "a source nearer to the axis lets it in",
        always=True,
        optic="lens",
    ),
    "absorbed": Loss(
        "Absorbed",
        "The part that the glass absorbs of the light that comes to the exit face.",
        "is absorbed by the glass",
        "a thinner lens or a clearer glass lets more of it through",
        optic="lens",
    ),
    "fresnel_exit": Loss(
        "Reflected on exit",
        "The part that the exit face reflects of the light that it refracts.",
        "is reflected at the exit",
        "{flatter}thicker stock, a lower index or a target that needs less bending lets it out",
        always=True,
        optic="lens",
    ),
}
"""All losses by name, in the order in which they are listed."""


def words_for(receiver: AnyReceiver | type[AnyReceiver]) -> dict[str, tuple[str, str]]:
    """Title and tip of each part of an account, by the names of `Account.to_data`."""
    place, called = receiver.place, receiver.called
    return {
        "on_screen": (f"{place[0].upper()}{place[1:]}", "Light that makes the image."),
        **{
            name: (
                loss.title.format(receiver=called),
                loss.tip.format(receiver=called),
            )
            for name, loss in LOSSES.items()
        },
    }


@dataclass(frozen=True)
class Account:
    """Where the emitted flux went; ``on_screen`` and all losses add up to ``emitted``.

    Attributes
    ----------
    on_screen : float
        Flux of rays that hit the screen. A reconstruction filter spreads some of it over the rim;
        the account is of rays.
    lost : mapping of str to float
        Flux that was lost, by names in `LOSSES` and in their order; 0 of those that every account
        has where nothing is given.
    emitted : float
        Flux of the source.
    """

    on_screen: float
    lost: Mapping[str, float]
    emitted: float = 1.0

    def __post_init__(self) -> None:
        if unknown := self.lost.keys() - LOSSES.keys():
            raise KeyError(f"nothing is said in LOSSES of {', '.join(sorted(unknown))}")
        lost = {
            name: self.lost.get(name, 0.0)
            for name, loss in LOSSES.items()
            if loss.always or name in self.lost
        }
        object.__setattr__(self, "lost", lost)

    @property
    def efficiency(self) -> float:
        """Part of the emitted flux that lands on the screen."""
        return self.on_screen / self.emitted

    @property
    def arrived(self) -> float:
        """Flux of rays that came to the screen's plane, on the screen or beside it."""
        return self.on_screen + self.lost["off_screen"]

    def advice(self, scene: Scene) -> str:
        """Where most light goes before the receiver, and what would help, in two sentences.

        Empty if at least half of the light comes there: what is beside it is for a run to bring
        back.
        """
        if self.arrived >= 0.5 * self.emitted:
            return ""
        most = max((name for name in self.lost if name != "off_screen"), key=self.lost.__getitem__)
        where, receiver = LOSSES[most].where, scene.receiver
        cure = LOSSES[most].cure_in(scene)
        part = self.lost[most] / self.emitted
        return (
            f"Only {100 * self.efficiency:.1f} % of the light lands {receiver.place}; "
            f"{100 * part:.0f} % {where}. {cure[0].upper()}{cure[1:]}."
        )

    def to_data(self) -> dict[str, float]:
        """All its flux by name, for JSON."""
        return {"emitted": self.emitted, "on_screen": self.on_screen, **self.lost}
