"""Parts of the scene of which there are several kinds."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar, get_args

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from workbench.scene.part import Part

if TYPE_CHECKING:
    from workbench.scene.task import Scene

AnyPart = TypeVar("AnyPart", bound=Part)
Row = TypeVar("Row")


@dataclass(frozen=True)
class Kinds:
    """Mark of a union of parts: a field of theirs tells which kind one is of.

    The union is the one list of the kinds: files, forms and refusals follow it.
    """

    field: str  # its name; a literal in each kind but, perhaps, the default
    default: str | None = None  # the kind where the field is left out
    title: str = "Kind"  # what a person reads for the field

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
