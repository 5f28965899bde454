"""Figures of a result in JSON."""

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import Field, SerializerFunctionWrapHandler, create_model, model_serializer

from workbench.design.lens_state import FurtherLight
from workbench.design.limits import Cause, Interval, Shortfall
from workbench.design.session import VerifiedError
from workbench.design.snapshot import ENDINGS, Result
from workbench.messages import Message
from workbench.optics.account import LOSSES, Account
from workbench.scene import NonNegative, Part, Positive

_MOST_FLUX = 1e30  # in any unit; sums and ratios stay finite

Count = Annotated[int, Field(ge=0)]
Flux = Annotated[float, Field(ge=-_MOST_FLUX, le=_MOST_FLUX)]

LONGEST_REASON = 1000
"""Most characters of the reason why a run ended."""


class _AccountFigures(Part):
    """`Account` as JSON; losses may be negative by a rounding error."""

    emitted: Annotated[Positive, Field(le=_MOST_FLUX)]
    on_screen: Flux

    @classmethod
    def of(cls, account: Account) -> Self:
        """The figures of an account."""
        return cls(**account.to_data())

    def to_account(self) -> Account:
        """The account of all light."""
        lost = self.model_dump()
        return Account(lost.pop("on_screen"), emitted=lost.pop("emitted"), lost=lost)

    @model_serializer(mode="wrap")
    def _present(self, fields: SerializerFunctionWrapHandler) -> dict[str, float]:
        """Omit losses without a value."""
        return {name: flux for name, flux in fields(self).items() if flux is not None}


def _loss_field(name: str) -> Any:
    if name == "left_side":
        return Flux, 0.0  # missing in old sessions of collimated light
    return (Flux, ...) if LOSSES[name].always else (Flux | None, None)


if TYPE_CHECKING:
    AccountFigures = _AccountFigures
else:
    AccountFigures = create_model(
        "AccountFigures", __base__=_AccountFigures, **{name: _loss_field(name) for name in LOSSES}
    )


class VerifiedFigures(Part):
    """`VerifiedError` as JSON."""

    relative_l2_corrected: NonNegative
    relative_l2_corrected_interval: tuple[NonNegative, NonNegative]

    def to_error(self) -> VerifiedError:
        """The error of the lens."""
        return VerifiedError(**dict(self))


class ShortfallFigures(Part):
    """`Shortfall` as JSON."""

    cause: Cause
    needed: Interval | None = None
    allowed: Interval
    share: NonNegative

    @classmethod
    def of(cls, shortfall: Shortfall) -> Self:
        """The figures of a shortfall."""
        return cls(**asdict(shortfall))

    def to_shortfall(self) -> Shortfall:
        """The shortfall of the lens."""
        return Shortfall(**self.model_dump())


class FurtherFigures(Part):
    """A `FurtherLight` without its irradiance, with its efficiency."""

    loss: NonNegative
    efficiency: float
    ledger: AccountFigures

    @classmethod
    def of(cls, light: FurtherLight) -> Self:
        """The figures of a further image."""
        return cls(
            loss=light.loss,
            efficiency=light.account.efficiency,
            ledger=AccountFigures.of(light.account),
        )


class SavedMessage(Part):
    """A message of the program with its values, which the window can translate."""

    words: Annotated[str, Field(max_length=LONGEST_REASON)]
    values: dict[str, "int | float | SavedMessage"]

    @classmethod
    def of(cls, text: str) -> Self | None:
        """The message of an ending of a run, if it is one of `ENDINGS`."""
        if not isinstance(text, Message) or text.words not in ENDINGS:
            return None
        values = {name: cls.of(value) or value for name, value in text.values.items()}
        return cls(words=text.words, values=values)

    def to_text(self) -> str:
        """The text with its words and values; empty where values are missing or unsuitable."""
        values = {
            name: value.to_text() if isinstance(value, SavedMessage) else value
            for name, value in self.values.items()
        }
        try:
            return Message(self.words, **values) if self.words in ENDINGS else ""
        except (KeyError, OverflowError, ValueError):
            return ""


class Figures(Part):
    """A `Result` without its arrays, with its efficiency."""

    loss: NonNegative
    iterations: Count
    seconds: NonNegative
    efficiency: float
    ledger: AccountFigures
    stage_starts: tuple[int, ...] | None = None  # of a run in stages
    stages_left: Count | None = None
    ended: Annotated[str, Field(max_length=LONGEST_REASON)] | None = None  # reason
    ending: SavedMessage | None = None  # the reason with its values
    shortfall: ShortfallFigures | None = None
    further_images: tuple[FurtherFigures, ...] | None = None

    @classmethod
    def of(cls, result: Result) -> Self:
        """The figures of a result."""
        state = result.state
        short = state.shortfall
        return cls(
            loss=state.loss,
            iterations=result.iterations,
            seconds=result.seconds,
            efficiency=state.account.efficiency,
            ledger=AccountFigures.of(state.account),
            stage_starts=result.stage_starts or None,
            stages_left=result.stages_left or None,
            ended=result.ended[:LONGEST_REASON] or None,
            ending=SavedMessage.of(result.ended),
            shortfall=None if short is None else ShortfallFigures.of(short),
            further_images=tuple(map(FurtherFigures.of, state.further)) or None,
        )

    def to_ended(self) -> str:
        """Why the run ended."""
        text = "" if self.ending is None else self.ending.to_text()
        return text if text == self.ended else self.ended or ""
