"""``"auto"`` in place of numbers of control points."""

from dataclasses import dataclass
from typing import Any, get_args

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

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
