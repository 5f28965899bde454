"""What a lens is made of: a catalogue material, or a refractive index."""

from typing import Annotated, Any

from pydantic import ConfigDict, ValidationError, ValidatorFunctionWrapHandler, WrapValidator
from pydantic_core import PydanticCustomError

from workbench.scene.fields import about
from workbench.scene.part import Part


class CustomIndex(Part):
    """A refractive index that is the same at all wavelengths."""

    model_config = ConfigDict(title="Custom index")

    index: Annotated[
        float, about("Index", "Refractive index at the wavelength of the light.", gt=1)
    ]


def _name_or_index(value: Any, read: ValidatorFunctionWrapHandler) -> Any:
    # One error, not one for each member of the union.
    try:
        return read(value)
    except ValidationError:
        raise PydanticCustomError("material", "neither a name nor an index above 1") from None


Material = Annotated[str | CustomIndex, WrapValidator(_name_or_index)]
