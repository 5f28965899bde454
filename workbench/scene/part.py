"""What all parts of a scene have in common, and unions of parts of several kinds."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from inspect import get_annotations
from typing import TYPE_CHECKING, Annotated, Any, Self, TypeVar, get_args

from pydantic import BaseModel, ConfigDict, Field, GetCoreSchemaHandler, model_validator
from pydantic_core import CoreSchema, core_schema

from workbench import units
from workbench.errors import Refused
from workbench.levels import Level
from workbench.messages import Message
from workbench.scene.fields import AutoNet, FieldDescription, NamesFile, describe

if TYPE_CHECKING:
    from workbench.scene.task import Scene

Positive = Annotated[float, Field(gt=0)]
NonNegative = Annotated[float, Field(ge=0)]
_ROUNDING = 1e-9  # of a length that was converted to another unit


class Part(BaseModel):
    """A frozen part of the scene that refuses unknown fields and loose types."""

    model_config = ConfigDict(
        frozen=True, extra="forbid", strict=True, allow_inf_nan=False, defer_build=True
    )

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

    def differs(self, name: str) -> bool:
        """Whether a field is other than by default; of a part its kind, of a required field no."""
        field = type(self).model_fields.get(name)
        if field is None or field.is_required():
            return False
        value = getattr(self, name)
        usual = field.get_default(call_default_factory=True, validated_data=vars(self))
        if isinstance(value, Part | AutoNet):
            return type(value) is not type(usual)
        if isinstance(value, float) and isinstance(usual, float):
            return not math.isclose(value, usual, rel_tol=_ROUNDING)
        return bool(value != usual)

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


@dataclass(frozen=True)
class Content:
    """What a file holds, and beside which scene.

    Attributes
    ----------
    data : bytes, optional
        All of the file; none where it is read anew whenever it is needed.
    unit : str
        Unit of the scene's lengths; the file has one of its own.
    """

    data: bytes | None = None
    unit: str = "mm"


AnyPart = TypeVar("AnyPart", bound=Part)
Row = TypeVar("Row")


@dataclass(frozen=True)
class Kinds:
    """Mark of a union of parts: one of their fields states the kind.

    The union is the one list of the kinds: files, forms and refusals follow it.
    """

    field: str  # its name; a literal in each kind but, perhaps, the default
    default: str | None = None  # the kind where the field is left out
    title: str = "Kind"  # what a person reads for the field
    level: Level = Level.JOB  # how soon a person needs it

    def name_of(self, kind: type[Part]) -> str:
        """What the field of a kind holds."""
        found = kind.model_fields.get(self.field)
        return str(get_args(found.annotation)[0] if found else self.default)

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        members = get_args(source)
        named = [self.name_of(member) for member in members if self.field in member.model_fields]
        return core_schema.tagged_union_schema(
            {self.name_of(member): handler.generate_schema(member) for member in members},
            self._tag,
            custom_error_type="unknown_kind",
            custom_error_message=f"{self.field}: {', '.join(map(repr, named))}",
        )

    def _tag(self, value: object) -> str | None:
        field = self.field
        given = value.get(field) if isinstance(value, dict) else getattr(value, field, None)
        return self.default if given is None else str(given)

    def exchanged(self, before: Part, kind: type[AnyPart], scene: "Scene") -> AnyPart | None:
        """A part of another kind, as like the one before as it can be; of the same one, a new one.

        `before`: what is not by default there stays, as far as both kinds say the same of it;
        `kind`: the kind of the new one; `scene`: where the new one begins; see `Part.defaults_for`.
        Returns None if it needs what only a person can give.
        """
        there = {field.name: field for field in before.fields()}
        usual = {name: field.default for name, field in type(before).model_fields.items()}
        kept = {
            field.name: value
            for field in kind.fields()
            if kind is not type(before)
            and there.get(field.name) == field
            and (value := getattr(before, field.name)) != usual[field.name]
        }
        if self.field in kind.model_fields:
            kept[self.field] = self.name_of(kind)
        given = kept | kind.defaults_for(scene)
        needed = {name for name, field in kind.model_fields.items() if field.is_required()}
        return None if needed - given.keys() else kind.model_validate(given)


def row_of(table: Mapping[type, Row], part: Part) -> Row:
    """The row for a part in a table by kinds: that of its kind, or of what all such kinds are."""
    return next(table[kind] for kind in type(part).__mro__ if kind in table)


def summary_of(kind: type[Part]) -> str:
    """What a kind is, in a sentence."""
    return (kind.__doc__ or "").partition("\n\n")[0]


def title_of(kind: type[Part]) -> str:
    """What a person reads for a kind."""
    return kind.model_config.get("title") or kind.__name__
