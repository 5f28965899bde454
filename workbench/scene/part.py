"""What all parts of a scene have in common."""

from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from inspect import get_annotations
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from workbench import units
from workbench.errors import Refused
from workbench.scene.fields import FieldDescription, describe

if TYPE_CHECKING:
    from workbench.scene.task import Scene

Positive = Annotated[float, Field(gt=0)]
NonNegative = Annotated[float, Field(ge=0)]


class Part(BaseModel):
    """A frozen part of the scene that refuses unknown fields and loose types."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)

    @model_validator(mode="after")
    def _checked(self) -> Self:
        self.check()
        return self

    def check(self) -> None:
        """Refuse values that do not go together; each by itself is within its limits.

        Raises
        ------
        Refused
            With the path of the field, the value and what is allowed.
        """

    def altered(self, **values: Any) -> Self:
        """The same part with other values, which are good for their fields, checked as a whole.

        Raises
        ------
        Refused
            If they do not go together.
        """
        changed = self.model_copy(update=values)
        changed.check()
        return changed

    def scaled(self, factor: Fraction) -> Self:
        """The same part in another unit of length, of which ``factor`` make the one before.

        Raises
        ------
        Refused
            If it is too large or too small then.
        """
        changes = {
            field.name: _scaled(getattr(self, field.name), factor, field.measure.power)
            for field in self.fields()
        }
        return self.altered(**changes)

    def remarks(self) -> Mapping[str, str]:
        """What values come to that are not numbers to read as they are, by the names of fields."""
        return {}

    @classmethod
    @cache
    def fields(cls) -> tuple[FieldDescription, ...]:
        """What its fields say of themselves, its own before those of all kinds."""
        own = (name for base in cls.__mro__ for name in get_annotations(base))
        names = dict.fromkeys(name for name in own if name in cls.model_fields)
        return tuple(describe(name, cls.model_fields[name]) for name in names)

    @classmethod
    def begun(cls, scene: "Scene") -> dict[str, Any]:
        """What a new part of this kind begins with in a scene, beside defaults."""
        return {}


def _scaled(value: Any, factor: Fraction, power: int) -> Any:
    """A field's value; what is neither a length, a part nor some of them stays as it is."""
    if isinstance(value, Part):
        return value.scaled(factor)
    if isinstance(value, tuple):
        return tuple(_scaled(each, factor, power) for each in value)
    if not (power and isinstance(value, float)):
        return value
    found = units.times(value, factor**power)
    if value and not found:
        raise Refused("unit", f"{value:g} is too small for this one; a number that it can hold")
    return found
