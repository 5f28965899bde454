"""Turns pydantic's validation errors into one-sentence refusals."""

from typing import Any, get_args

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from workbench.errors import LONGEST_QUOTE, Refused, shown
from workbench.messages import Message, Stated

SENTENCES = {
    "missing": "missing; it is required",
    "greater_than": "{input} is too small; must be greater than {gt:.10g}",
    "greater_than_equal": "{input} is too small; at least {ge:.10g}",
    "less_than": "{input} is too large; must be less than {lt:.10g}",
    "less_than_equal": "{input} is too large; at most {le:.10g}",
    "literal_error": "{input} is not available; allowed: {expected}",
    "even": "{input} is even; an odd number is needed",
    "finite_number": "{input} is not finite; a finite number is needed",
    "float_type": "{input} is not a number; a number is needed",
    "int_type": "{input} is not a whole number; a whole number is needed",
    "int_from_float": "{input} is not a whole number; a whole number is needed",
    "bool_type": "{input} is neither true nor false; true or false is needed",
    "string_type": "{input} is not text; text is needed",
    "string_too_short": "{input} is empty; some text is needed",
    "string_pattern_mismatch": "{input} has other signs; letters, digits, - and _ are possible",
    "tuple_type": "{input} is not a list; a list of numbers is needed",
    "model_type": "{input} is not an object; an object with named fields is needed",
    "model_attributes_type": "{input} is not an object; an object with named fields is needed",
    "json_invalid": "not valid JSON: {error}",
    "extra_forbidden": "unknown field; known here: {fields}",
    "unknown_kind": "{input} is not available; allowed: {expected}",
    "too_short": "{actual_length} values given; at least {min_length} are needed",
    "too_long": "{actual_length} values given; exactly {max_length} are needed",
    "account": "the parts emitted, greater than 0, and on_screen are needed",
    "part_of_account": "{input} is no part of a light account",
    "auto_net": "{input}: two whole numbers or 'auto' are needed",
    "material": "{input} is neither a name nor an index above 1",
}
"""Messages by pydantic's error type; {x} are values that pydantic reports."""


def refusal(error: ValidationError, model: type[BaseModel], whole: str = "scene") -> Refused:
    """Return a refusal for the first error; ``whole`` is the path if no single field is wrong."""
    details = error.errors(include_url=False)[0]
    path, fields = _follow(details["loc"], model)
    if details["type"] == "unknown_kind" and isinstance(details["input"], dict):
        path += "." + details["msg"].split(": ")[0]
    return Refused(path or whole, _sentence(details, fields))


def _follow(location: tuple[int | str, ...], model: type[BaseModel]) -> tuple[str, list[str]]:
    """Path without union tags, and the known fields at its last step."""
    path = ""
    candidates = [model]
    fields = list(model.model_fields)
    for step in location:
        if isinstance(step, int):
            path += f"[{step}]"
            continue
        if step == "[key]":  # the name itself is wrong, whose path this is
            continue
        tagged = [c for c in candidates if _has_tag(c, step)]
        if tagged and len(candidates) > 1:
            candidates = tagged
            continue
        path += f".{field_name(step)}" if path else field_name(step)
        fields = sorted({name for c in candidates for name in c.model_fields})
        annotations = [
            c.model_fields[step].annotation for c in candidates if step in c.model_fields
        ]
        candidates = list(dict.fromkeys(m for a in annotations for m in _models(a)))
    return path, fields


def _has_tag(model: type[BaseModel], tag: str) -> bool:
    only = [get_args(field.annotation) == (tag,) for field in model.model_fields.values()]
    return any(only) or tag in model.model_fields  # `image` is known by its field alone


def _models(annotation: object) -> list[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [model for part in get_args(annotation) for model in _models(part)]


def _sentence(details: ErrorDetails, fields: list[str]) -> str:
    kind, given = details["type"], details["input"]
    values: dict[str, Any] = {**details.get("ctx", {}), "input": given}
    for name, value in values.items():
        values[name] = Stated(value) if isinstance(value, float) else value
    if not isinstance(given, float):
        values["input"] = shown(given)
    if kind == "extra_forbidden":
        values["fields"] = ", ".join(fields)
    elif kind == "unknown_kind" and not isinstance(given, dict):
        kind = "model_type"
    elif kind == "unknown_kind":
        field, values["expected"] = details["msg"].split(": ", 1)
        values["input"] = shown(given.get(field))
        kind = kind if given.get(field) is not None else "missing"
    if kind in SENTENCES:
        return Message(SENTENCES[kind], **values)
    message = details["msg"]
    return f"{values['input']}: {message[:1].lower()}{message[1:]}"


def field_name(name: str) -> str:
    """Return the name of a field in a path; unknown names are quoted and cut."""
    return name if name.isidentifier() and len(name) < LONGEST_QUOTE else shown(name)
