"""The account of all light: what is on the screen, and what is lost, by name.

A new way to lose light is a mark of the field that it comes from, `TakesLight`, and its name where
an element finds it. Dock, report, figures and files take all they say of it from here.
"""

from collections.abc import Mapping
from typing import NamedTuple, Self

from workbench.messages import Message, capitalised
from workbench.scene import AnyReceiver, Diffuser, Lens, Mirror, Scene
from workbench.scene.losses import Loss, key_of, kind_and_element

_AT_RECEIVERS: Mapping[str, Loss] = {
    "off_screen": Loss(
        "Missed the {receiver}",
        "Light that leaves the last element and misses the {receiver}. Much of it means that the "
        "designed faces cannot deflect all light to the image.",
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
"""All kinds of losses by name, in the order in which they are listed."""


def keys_in(scene: Scene) -> tuple[str, ...]:
    """Keys of the losses that there can be in a scene, in the order of the light."""
    several = len(scene.elements) > 1
    at_elements = (
        key_of(kind, element.name if several else "")
        for element in scene.elements
        for kind in LOSSES
        if kind in element.possible_losses
    )
    return (*_AT_RECEIVERS, *at_elements)


def loss_of(key: str) -> Loss:
    """Return a loss by its key, with the element where light is lost."""
    kind, element = kind_and_element(key)
    return LOSSES[kind]._replace(element=element)


def words_of(part: str, receiver: AnyReceiver | type[AnyReceiver]) -> tuple[str, str]:
    """Return title and tip of a part of an account, by its name in `Account.to_data`."""
    if part == "on_screen":
        return capitalised(receiver.place), "Light that makes the image."
    loss = loss_of(part)
    return loss.title_for(receiver.called), loss.tip.format(receiver=receiver.called)


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


class _Parts(NamedTuple):
    # Flux of rays that hit the screen. A reconstruction filter spreads some of it over the rim; the
    # account is of rays.
    on_screen: float
    # Flux that was lost, by the keys of `keys_in`: at the receiver, then element by element, in the
    # order of `LOSSES`. 0 of losses that every account has where nothing is given; in an account
    # whose losses name elements, these are the losses at the receiver.
    lost: Mapping[str, float]
    emitted: float = 1.0  # flux of the source


class Account(_Parts):
    """Where the emitted flux went; ``on_screen`` and all losses add up to ``emitted``."""

    def __new__(cls, on_screen: float, lost: Mapping[str, float], emitted: float = 1.0) -> Self:
        """Complete the losses and put them in order."""
        return super().__new__(cls, on_screen, _in_order(lost), emitted)

    @classmethod
    def from_data(cls, data: Mapping[str, float]) -> Self:
        """Return the account that `to_data` gave."""
        lost = dict(data)
        return cls(lost.pop("on_screen"), emitted=lost.pop("emitted"), lost=lost)

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
        return self._replace(on_screen=settled.pop("on_screen"), lost=settled)

    def parts_in(self, scene: Scene) -> Mapping[str, float]:
        """Flux on the receiver, and of each loss that there can be in a scene, by name."""
        kinds = {kind for kind, _ in map(kind_and_element, keys_in(scene))}
        lost = {key: flux for key, flux in self.lost.items() if kind_and_element(key)[0] in kinds}
        return {"on_screen": self.on_screen, **lost}

    def advice(self, scene: Scene) -> Message | None:
        """Where most light goes before the receiver, and what would help, in a sentence.

        None if at least half of the light comes there: what is beside it is for a run to bring
        back.
        """
        if self.arrived >= 0.5 * self.emitted:
            return None
        most = max((key for key in self.lost if key != "off_screen"), key=self.lost.__getitem__)
        loss = loss_of(most)
        return Message(
            "Only {part:.1f} % of the light lands {place}; {lost:.0f} % {where}: {cure}.",
            part=100 * self.efficiency,
            place=Message(scene.receiver.place),
            lost=100 * self.lost[most] / self.emitted,
            where=loss.goes,
            cure=loss.cure_in(scene),
        )

    def to_data(self) -> dict[str, float]:
        """All its flux by name, for JSON."""
        return {"emitted": self.emitted, "on_screen": self.on_screen, **self.lost}


def _in_order(given: Mapping[str, float]) -> Mapping[str, float]:
    kinds, elements = list(LOSSES), [""]
    for key in given:
        kind, element = kind_and_element(key)
        if kind not in LOSSES:
            raise KeyError(f"{kind} is not in LOSSES")
        if element not in elements:
            elements.append(element)
    always = LOSSES if len(elements) == 1 else _AT_RECEIVERS
    lost = {kind: 0.0 for kind, loss in always.items() if loss.always} | dict(given)

    def place(key: str) -> tuple[int, int]:
        kind, element = kind_and_element(key)
        return elements.index(element), kinds.index(kind)

    return {key: lost[key] for key in sorted(lost, key=place)}
