"""The account of all light: what is on the screen, and what is lost, by name.

A new way to lose light is a mark of the field that it comes from, `TakesLight`, and its name where
an element finds it. Dock, report, figures and files take all they say of it from here.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Self

from workbench.messages import Message
from workbench.scene import AnyReceiver, Diffuser, Lens, Mirror, Scene
from workbench.scene.losses import Loss

_AT_RECEIVERS: Mapping[str, Loss] = {
    "off_screen": Loss(
        "Missed the {receiver}",
        "Light that passes the optic and the {receiver} by. One that sends much light here "
        "wastes it, or has more than its surface can bend.",
        "passes beside it",
        "a larger {receiver} catches it",
        always=True,
    ),
}
LOSSES: Mapping[str, Loss] = {
    **_AT_RECEIVERS,
    **Lens.all_losses(),
    **Mirror.all_losses(),
    **Diffuser.all_losses(),
}
"""All losses by name, in the order in which they are listed."""


def losses_in(scene: Scene) -> Mapping[str, Loss]:
    """The losses that there can be in a scene, by name."""
    there = {name for element in scene.elements for name in element.all_losses()}
    return {name: loss for name, loss in LOSSES.items() if name in there or name in _AT_RECEIVERS}


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


# Sums over samples may have so much more light than the integral over the aperture. With 32 cells
# along each axis, narrow lamps before flat faces were 5e-4 off at most, Gaussian beams of 0.05
# half-widths of the lens or wider 5e-6, a point 0.02 half-widths before two freeform faces 6e-3,
# and beams of 0.01 half-widths that come slanted to them 2.3e-2. Known to be more, and a defect: a
# lamp of 2° with wide light 0.03 half-widths before the lens, and turned lamps before wavy faces.
_SAMPLING = 2.5e-2


class UnbalancedAccount(Exception):
    """An account that no light can have: a defect of this program.

    `account`: the account.
    """

    def __init__(self, account: "Account") -> None:
        figures = ", ".join(f"{name} {flux:.6g}" for name, flux in account.to_data().items())
        super().__init__(f"the light account does not add up: {figures}")


@dataclass(frozen=True)
class Account:
    """Where the emitted flux went; ``on_screen`` and all losses add up to ``emitted``."""

    # Flux of rays that hit the screen. A reconstruction filter spreads some of it over the rim; the
    # account is of rays.
    on_screen: float
    # Flux that was lost, by names in `LOSSES` and in their order; 0 of those that every account has
    # where nothing is given.
    lost: Mapping[str, float]
    emitted: float = 1.0  # flux of the source

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

    def settled(self) -> Self:
        """The account of an evaluation, all of whose shares are from 0 to 1.

        Losses that are found as the rest have the error of the sum over samples. Where a rest is
        negative, the samples have that much more light than there is: all are scaled down, so that
        their sum is the integral over the aperture.

        Raises `UnbalancedAccount` if shares are out of bounds, or their sum is not 1, by more than
        that error.
        """
        parts = {"on_screen": self.on_screen, **self.lost}
        total, counted = sum(parts.values()), sum(max(flux, 0.0) for flux in parts.values())
        off = max(abs(total - self.emitted), counted - self.emitted)
        if not off <= _SAMPLING * self.emitted:
            raise UnbalancedAccount(self)
        if min(parts.values()) >= 0:
            return self
        scale = self.emitted / counted
        settled = {name: max(flux, 0.0) * scale for name, flux in parts.items()}
        return replace(self, on_screen=settled.pop("on_screen"), lost=settled)

    def parts_in(self, scene: Scene) -> Mapping[str, float]:
        """Flux on the receiver, and of each loss that there can be in a scene, by name."""
        lost = {name: self.lost[name] for name in losses_in(scene) if name in self.lost}
        return {"on_screen": self.on_screen, **lost}

    def advice(self, scene: Scene) -> Message | None:
        """Where most light goes before the receiver, and what would help, in a sentence.

        None if at least half of the light comes there: what is beside it is for a run to bring
        back.
        """
        if self.arrived >= 0.5 * self.emitted:
            return None
        most = max((name for name in self.lost if name != "off_screen"), key=self.lost.__getitem__)
        return Message(
            "Only {part:.1f} % of the light lands {place}; {lost:.0f} % {where}: {cure}.",
            part=100 * self.efficiency,
            place=Message(scene.receiver.place),
            lost=100 * self.lost[most] / self.emitted,
            where=Message(LOSSES[most].where),
            cure=LOSSES[most].cure_in(scene),
        )

    def to_data(self) -> dict[str, float]:
        """All its flux by name, for JSON."""
        return {"emitted": self.emitted, "on_screen": self.on_screen, **self.lost}
