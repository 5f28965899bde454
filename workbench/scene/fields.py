"""What a field of the scene says of itself, so that nobody else has to know it.

``about`` gives title, tip and limits, and marks say the rest:
``z: Annotated[float, LENGTH, about("At z", "Where the screen stands.")]``. Rows of forms and
reports, conversions of units and the JSON Schema follow from them.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from types import NoneType
from typing import Annotated, Any, Literal, TypeVar, get_args, get_origin

import annotated_types
from pydantic import BaseModel, Field, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from workbench.levels import Level, Shown

AUTO = "auto"
"""What stands in a file."""


@dataclass(frozen=True)
class AutoNet:
    """The program chooses how many control points there are."""

    # What it has chosen for a task; none before, and none in files of scenes.
    shape: tuple[int, int] | None = None

    def __str__(self) -> str:
        return AUTO


class NumbersOrAuto:
    """Mark of a field that holds numbers or `AutoNet`; a file says ``"auto"`` for that."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        # A validator before it has made a list of the array of a file.
        numbers = {**handler.generate_schema(get_args(source)[0]), "strict": False}
        return core_schema.no_info_wrap_validator_function(
            _read,
            numbers,
            serialization=core_schema.wrap_serializer_function_ser_schema(_written, schema=numbers),
        )

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {"anyOf": [handler(schema), {"const": AUTO}]}


def _read(value: Any, numbers: core_schema.ValidatorFunctionWrapHandler) -> Any:
    if isinstance(value, AutoNet):
        return value
    if not isinstance(value, str):
        return numbers(value)
    if value != AUTO:
        raise PydanticCustomError("auto_net", "two whole numbers or 'auto' are needed")
    return AutoNet()


def _written(value: Any, numbers: core_schema.SerializerFunctionWrapHandler) -> Any:
    return AUTO if isinstance(value, AutoNet) else numbers(value)


_FAR = 1e9  # a limit that nobody meets
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def about(title: str, tip: str, **limits: Any) -> Any:
    """Title, tip and limits of a field.

    `title`: what a person reads before it; `tip`: what it is, and why one would change it.
    """
    return Field(title=title, description=tip, **limits)


@dataclass(frozen=True)
class Measure:
    """Mark of a field: what its numbers are measured in."""

    sign: str = ""  # stands behind the number
    words: str = ""  # says the same by itself; the sign, if it is left out
    power: int = 0  # of the scene's unit of length; then there is no sign

    def sign_in(self, unit: str) -> str:
        """The sign in a scene with a unit of length."""
        if not self.power:
            return self.sign
        return unit if self.power == 1 else f"{unit}{str(self.power).translate(_SUPERSCRIPTS)}"

    def words_in(self, unit: str) -> str:
        """The words in a scene with a unit of length."""
        return self.words or self.sign_in(unit)

    def __get_pydantic_json_schema__(
        self, core_schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {**handler(core_schema), "unit": self.words_in("length")}


LENGTH = Measure(power=1)
ANGLE = Measure("°", "degrees")


@dataclass(frozen=True)
class Between:
    """Mark of a field with several numbers: what stands between them; × if it is left out."""

    text: str


PLACE, RANGE = Between(","), Between("to")


@dataclass(frozen=True)
class Members:
    """Mark of a field with a fixed number of parts: what a person reads for each."""

    titles: tuple[str, ...]


@dataclass(frozen=True)
class Choices:
    """Mark of a field with a few values: what a person reads for each; its name, if left out."""

    titles: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class LeftOut:
    """Mark of a field that may be left out: what a person reads for that."""

    title: str


@dataclass(frozen=True)
class ForMethod:
    """Mark of a field that counts with one method of the run only."""

    method: str


@dataclass(frozen=True)
class Fallback:
    """Mark of a field that may be left out: where in the scene that is which counts instead."""

    path: str


@dataclass(frozen=True)
class NamesFile:
    """Mark of a field that names a file; a relative path starts at the folder of the scene file."""


FILE = NamesFile()
Mark = TypeVar("Mark")

BOUNDS = {
    (False, False): "From {} to {}.",
    (True, False): "Above {} to {}.",
    (False, True): "From {} to below {}.",
    (True, True): "Above {} to below {}.",
}
"""Between which numbers a field lies, by whether the lower and the upper one are left out."""


@dataclass(frozen=True)
class FieldDescription:
    """A field of a part, as forms, reports and conversions need it."""

    name: str  # in the file
    title: str  # what a person reads
    tip: str  # what it is, and why one would change it
    type: Any  # of its values, without None and `AutoNet`
    optional: bool  # whether it may be left out for no value
    auto: bool  # whether the program may choose its numbers
    marks: tuple[object, ...]  # limits, and marks of this module

    def mark(self, kind: type[Mark]) -> Mark | None:
        """The mark of a kind, its own or of each of its values; None without one."""
        return next((mark for mark in self.all_marks if isinstance(mark, kind)), None)

    @property
    def level(self) -> Level:
        """How soon a person needs it."""
        mark = self.mark(Level)
        return Level.JOB if mark is None else mark

    @property
    def times(self) -> float:
        """What its numbers are multiplied by in the window."""
        mark = self.mark(Shown)
        return mark.times if mark else 1.0

    @property
    def in_window(self) -> "FieldDescription":
        """The description with title and tip of the window."""
        mark = self.mark(Shown)
        return replace(self, title=mark.title, tip=mark.tip) if mark else self

    @property
    def measure(self) -> Measure:
        """What its numbers are measured in."""
        return self.mark(Measure) or Measure()

    @property
    def between(self) -> str:
        """What stands between its numbers."""
        mark = self.mark(Between)
        return mark.text if mark else "×"

    @cached_property
    def number(self) -> type[float] | type[int] | None:
        """The type of its number, or of each of its numbers; None if it has none."""
        bare, _ = self._item
        return bare if bare in (float, int) else None

    @property
    def count(self) -> int:
        """How many values stand side by side."""
        return len(get_args(self.type)) if get_origin(self.type) is tuple else 1

    @property
    def several(self) -> bool:
        """Whether it holds any number of values."""
        return Ellipsis in get_args(self.type)

    @property
    def listed(self) -> bool:
        """Whether it holds any number of parts of the scene."""
        return self.several and bool(self.parts)

    @property
    def members(self) -> tuple["FieldDescription", ...]:
        """A description for each of its parts, where their number is fixed; see `Members`."""
        mark = self.mark(Members)
        titles: tuple[str, ...] = mark.titles if mark else ()
        item, marks = self._item
        return tuple(
            FieldDescription(f"{self.name}[{number}]", title, self.tip, item, False, False, marks)
            for number, title in enumerate(titles)
        )

    @property
    def choices(self) -> tuple[tuple[str, str], ...]:
        """Its values and what a person reads for each; none if there are not just a few."""
        if get_origin(self.type) is not Literal:
            return ()
        mark = self.mark(Choices)
        titles: dict[str, str] = dict(mark.titles) if mark else {}
        values = get_args(self.type)
        return tuple((value, titles.get(value, str(value).capitalize())) for value in values)

    @property
    def parts(self) -> tuple[type[BaseModel], ...]:
        """What stands there, if it is a part of the scene: each kind that it may be of."""
        item, _ = self._item
        members = (item, *get_args(item))
        return tuple(m for m in members if isinstance(m, type) and issubclass(m, BaseModel))

    @property
    def all_marks(self) -> tuple[object, ...]:
        """Its marks, and those of each of its values where there are several."""
        return (*self.marks, *self._item[1])

    @cached_property
    def _item(self) -> tuple[Any, tuple[object, ...]]:
        """The type of each of its values where there are several, else of the one; its marks."""
        several = get_origin(self.type) is tuple
        return _unmarked(get_args(self.type)[0] if several else self.type)

    @property
    def limits(self) -> str:
        """Between which numbers it lies, as a sentence; empty where an end is open, or nearly."""
        sentence, *ends = self.bounds()
        return sentence.format(*ends)

    def clamped(self, number: float) -> float:
        """Return the number that it may hold nearest to another one, where an end is included."""
        for mark in self.all_marks:
            match mark:
                case annotated_types.Ge(ge=end):
                    number = max(number, float(end))  # type: ignore[arg-type]
                case annotated_types.Le(le=end):
                    number = min(number, float(end))  # type: ignore[arg-type]
        return number

    def bounds(self, times: float = 1.0) -> tuple[str, ...]:
        """Return the sentence of `limits`, one of `BOUNDS`, and its numbers, multiplied."""

        def ended(end: Any) -> str:
            return f"{times * end:.10g}"

        marks = self.all_marks
        above = until = False
        low, high = "", ""
        most: Any = 0
        for mark in marks:
            match mark:
                case annotated_types.Ge(ge=end):
                    low = ended(end)
                case annotated_types.Gt(gt=end):
                    low, above = ended(end), True
                case annotated_types.Le(le=end):
                    high, most = ended(end), end
                case annotated_types.Lt(lt=end):
                    high, most, until = ended(end), end, True
        return (BOUNDS[above, until], low, high) if low and 0 < most < _FAR else ("",)


def describe(name: str, field: FieldInfo) -> FieldDescription:
    """What a field of a pydantic model says of itself."""
    bare, marks = _unmarked(field.annotation)
    members = [member for member in get_args(bare) if member not in (NoneType, AutoNet)]
    optional, auto = (each in get_args(bare) for each in (NoneType, AutoNet))
    if (optional or auto) and len(members) == 1:
        bare, inner = _unmarked(members[0])
        marks += inner
    title = field.title or name.replace("_", " ").capitalize()
    return FieldDescription(
        name, title, field.description or "", bare, optional, auto, (*field.metadata, *marks)
    )


def _unmarked(hint: Any) -> tuple[Any, tuple[object, ...]]:
    """A type without its marks, and these."""
    if get_origin(hint) is not Annotated:
        return hint, ()
    bare, *marks = get_args(hint)
    return bare, tuple(_flat(marks))


def _flat(marks: list[Any]) -> Iterator[object]:
    """Marks, with those that pydantic keeps together in one of its own."""
    for mark in marks:
        yield from mark.metadata if isinstance(mark, FieldInfo) else (mark,)
