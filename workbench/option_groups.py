"""Options with their titles, tips, units and limits.

The command line and the window follow from them. The command line imports this module for each
command, so it imports nothing slow.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields
from typing import Any, ClassVar, Self

from workbench.errors import Refused, shown
from workbench.messages import Message

LENGTH, DEGREES, PERCENT = "length", "degrees", "percent"
"""Units of options; a length is in the scene's unit."""
FEED, MINUTES = "mm/min", "min"
"""Units of options of machines."""


@dataclass(frozen=True)
class Option:
    """Description of an option."""

    title: str  # of its field in the window
    tip: str
    empty: str = ""  # what counts where it is left out, for users
    unit: str = ""
    kind: type = float
    least: float = 0.0
    most: float = math.inf
    above: bool = False  # whether the least value is excluded
    choices: Mapping[str, str] = field(default_factory=dict)  # values and their titles
    needs: tuple[str, tuple[str, ...]] | None = None  # another option, and values it counts with

    def check(self, name: str, value: Any) -> None:
        """Raise Refused with what is allowed, unless a value is."""
        if self.choices:
            if value not in self.choices:
                known = ", ".join(self.choices)
                reason = Message("{value}; one of {known}", value=shown(value), known=known)
                raise Refused(name, reason)
        elif self.kind is not bool and not self._holds(value):
            raise Refused(name, self._allowed(value))

    def _holds(self, value: float) -> bool:
        if not math.isfinite(value) or (self.above and value == self.least):
            return False
        return self.least <= value <= self.most

    def _allowed(self, value: float) -> Message:
        if math.isfinite(self.most) and not self.unit:
            return Message(
                "{value:g}; from {least:g} to {most:,}",
                value=value,
                least=self.least,
                most=self.most,
            )
        if math.isfinite(self.most):
            return Message(
                "{value:g} {unit}; from {least:g} to {most:,} {unit}",
                value=value,
                unit=self.unit,
                least=self.least,
                most=self.most,
            )
        if math.isinf(self.least):
            return Message("{value:g}; a finite number is needed", value=value)
        if self.above:
            return Message("{value:g}; a length above 0", value=value)
        return Message("{value:g}; a length of 0 or more", value=value)


def option(title: str, tip: str, default: Any = None, **more: Any) -> Any:
    """Return a field of a group of options."""
    return field(default=default, metadata={"about": Option(title, tip, **more)})


@dataclass(frozen=True)
class OptionGroup:
    """Options that belong together. Raise Refused if a value is out of range."""

    called: ClassVar[str]  # name of the group for users

    @classmethod
    def about(cls) -> Iterator[tuple[str, Option]]:
        """Names of the options and their descriptions."""
        for each in fields(cls):
            yield each.name, each.metadata["about"]

    @classmethod
    def of(cls, stated: Mapping[str, Any]) -> Self:
        """Return options of stated values; other names and None are ignored."""
        names = [name for name, _ in cls.about()]
        return cls(**{name: stated[name] for name in names if stated.get(name) is not None})

    def __post_init__(self) -> None:
        for name, about in self.about():
            value = getattr(self, name)
            if value is not None:
                about.check(name, value)
