"""Figures of a result in JSON."""

import math
import re
from dataclasses import asdict
from typing import Annotated, Self

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from workbench.design.lens_state import FurtherLight
from workbench.design.limits import Cause, Interval, Shortfall
from workbench.design.session import VerifiedError
from workbench.design.snapshot import ENDINGS, Result
from workbench.messages import Message
from workbench.optics.account import LOSSES
from workbench.scene import NonNegative, Part

_MOST_FLUX = 1e30  # in any unit; sums and ratios stay finite
_PART = re.compile(rf"emitted|on_screen|({'|'.join(LOSSES)})(@[A-Za-z0-9_-]{{1,40}})?")

Count = Annotated[int, Field(ge=0)]
Flux = Annotated[float, Field(ge=-_MOST_FLUX, le=_MOST_FLUX)]

LONGEST_REASON = 1000
"""Most characters of the reason why a run ended."""


def _known(key: str) -> str:
    if not _PART.fullmatch(key):
        raise PydanticCustomError("part_of_account", "unknown")
    return key


def _whole(ledger: dict[str, float]) -> dict[str, float]:
    if not ledger.get("emitted", 0.0) > 0 or "on_screen" not in ledger:
        raise PydanticCustomError("account", "incomplete")
    return ledger


Ledger = Annotated[dict[Annotated[str, AfterValidator(_known)], Flux], AfterValidator(_whole)]
"""`Account.to_data` as JSON; losses may be negative by a rounding error."""


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
    allowed: tuple[float | None, float | None]  # None where there is no end
    share: NonNegative

    @classmethod
    def of(cls, shortfall: Shortfall) -> Self:
        """The figures of a shortfall."""
        allowed = tuple(None if math.isinf(end) else end for end in shortfall.allowed)
        return cls(**asdict(shortfall) | {"allowed": allowed})

    def to_shortfall(self) -> Shortfall:
        """The shortfall of the lens."""
        low, high = self.allowed
        allowed = -math.inf if low is None else low, math.inf if high is None else high
        return Shortfall(**self.model_dump() | {"allowed": allowed})


class FurtherFigures(Part):
    """A `FurtherLight` without its irradiance, with its efficiency."""

    loss: NonNegative
    efficiency: float
    ledger: Ledger

    @classmethod
    def of(cls, light: FurtherLight) -> Self:
        """The figures of a further image."""
        return cls(
            loss=light.loss,
            efficiency=light.account.efficiency,
            ledger=light.account.to_data(),
        )


_Reason = Annotated[str, Field(max_length=LONGEST_REASON)]


class SavedMessage(Part):
    """A message of the program with its values, which the window can translate."""

    words: _Reason
    values: dict[str, "int | float | _Reason | SavedMessage"]

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
    ledger: Ledger
    stage_starts: tuple[int, ...] | None = None  # of a run in stages
    stages_left: Count | None = None
    ended: _Reason | None = None  # reason
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
            ledger=state.account.to_data(),
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
