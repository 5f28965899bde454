"""What all parts of a scene have in common."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from inspect import get_annotations
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from workbench import units
from workbench.errors import Refused
from workbench.messages import Message
from workbench.scene.fields import FieldDescription, NamesFile, describe

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

        Raises `Refused` with the path of the field, the value and what is allowed.
        """

    def altered(self, **values: Any) -> Self:
        """The same part with other values, which are good for their fields, checked as a whole.

        Raises `Refused` if they do not go together.
        """
        changed = self.model_copy(update=values)
        changed.check()
        return changed

    def scaled(self, factor: Fraction) -> Self:
        """The same part in another unit of length, of which ``factor`` make the one before.

        Raises `Refused` if it is too large or too small then.
        """
        changes = {
            field.name: _scaled(getattr(self, field.name), factor, field.measure.power)
            for field in self.fields()
        }
        return self.altered(**changes)

    def files(self) -> Iterator[tuple[str, str]]:
        """Fields that name files, as paths from this part, and the names."""
        for field in self.fields():
            value = getattr(self, field.name)
            if field.mark(NamesFile) and value is not None:
                yield field.name, value
            for index, part in _parts_in(value):
                yield from ((f"{field.name}{index}.{path}", name) for path, name in part.files())

    def with_files(self, names: Mapping[str, str]) -> Self:
        """The same part with other names of files, by the paths of `files`."""
        changes: dict[str, Any] = {}
        for field in self.fields():
            value = getattr(self, field.name)
            if field.name in names:
                changes[field.name] = names[field.name]
            for index, part in _parts_in(value):
                before = f"{field.name}{index}."
                inner = {
                    k.removeprefix(before): v for k, v in names.items() if k.startswith(before)
                }
                if inner:
                    value = _replaced(value, part, part.with_files(inner))
                    changes[field.name] = value
        return self.model_copy(update=changes)

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
    def defaults_for(cls, scene: "Scene") -> dict[str, Any]:
        """What a new part of this kind begins with in a scene, beside defaults."""
        return {}


def _parts_in(value: Any) -> Iterator[tuple[str, "Part"]]:
    """Parts that a field holds, with what stands behind the field's name in their paths."""
    if isinstance(value, Part):
        yield "", value
    elif isinstance(value, tuple):
        for number, each in enumerate(value):
            if isinstance(each, Part):
                yield f"[{number}]", each


def _replaced(value: Any, old: "Part", new: "Part") -> Any:
    """A field's value with one of its parts replaced."""
    if isinstance(value, tuple):
        return tuple(new if each is old else each for each in value)
    return new


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
        small = Message(
            "{value:g} is too small for this one; a number that it can hold", value=value
        )
        raise Refused("unit", small)
    return found
