"""JSON text that says everything once."""

import json
from collections.abc import Iterator
from typing import Any

from workbench.errors import Refused
from workbench.refusals import field_name
from workbench.said import Said


class _Fields(list[tuple[str, Any]]):
    """The fields of an object, in order, with those that stand there twice."""


def check_fields_once(text: str | bytes, before: str = "") -> None:
    """Refuse an object that has a field twice: readers of JSON take the one or the other.

    `text`: valid JSON, not too deep for `json.loads`; `before`: what a refusal puts before the
    path. Raises `Refused` with the path of the field.
    """
    # Numbers stay text: those of thousands of digits need not be understood here.
    read = json.loads(
        text, object_pairs_hook=_Fields, parse_int=str, parse_float=str, parse_constant=str
    )
    for path in _twice(read, ""):
        raise Refused(before + path, Said("is given twice; each field can be there once"))


def _twice(value: object, path: str) -> Iterator[str]:
    """Paths of fields that stand twice in their object."""
    if isinstance(value, _Fields):
        seen = set()
        for name, below in value:
            at = f"{path}.{field_name(name)}" if path else field_name(name)
            if name in seen:
                yield at
            seen.add(name)
            yield from _twice(below, at)
    elif isinstance(value, list):
        for number, below in enumerate(value):
            yield from _twice(below, f"{path}[{number}]")
