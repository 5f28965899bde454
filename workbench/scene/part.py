"""What all parts of a scene have in common."""

from dataclasses import dataclass
from fractions import Fraction
from typing import Annotated, Any, Self

from pydantic import BaseModel, ConfigDict, Field
from pydantic.fields import FieldInfo

from workbench import units

Positive = Annotated[float, Field(gt=0)]
NonNegative = Annotated[float, Field(ge=0)]


@dataclass(frozen=True)
class Dimension:
    """Metadata of a field: its numbers are in the scene's unit of length to this power."""

    power: int


LENGTH = Dimension(1)


class Part(BaseModel):
    """A frozen part of the scene that refuses unknown fields and loose types."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)

    def scaled(self, factor: Fraction) -> Self:
        """The same part in another unit of length, of which ``factor`` make the one before."""
        fields = type(self).model_fields
        changes = {
            name: _scaled(getattr(self, name), factor, dimension_of(field))
            for name, field in fields.items()
        }
        return self.model_copy(update=changes)


def dimension_of(field: FieldInfo) -> int:
    """To which power the unit of length is in the unit of a field's numbers; 0 without one."""
    return sum(mark.power for mark in field.metadata if isinstance(mark, Dimension))


def _scaled(value: Any, factor: Fraction, power: int) -> Any:
    """A field's value; what is neither a length, a part nor some of them stays as it is."""
    if isinstance(value, Part):
        return value.scaled(factor)
    if isinstance(value, tuple):
        return tuple(_scaled(each, factor, power) for each in value)
    return units.times(value, factor**power) if power and isinstance(value, float) else value
