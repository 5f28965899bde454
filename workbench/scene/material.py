"""What a lens is made of: a catalogue material, or a refractive index."""

from typing import Annotated, Any

from pydantic import (
    ConfigDict,
    PrivateAttr,
    ValidationError,
    ValidatorFunctionWrapHandler,
    WrapValidator,
)
from pydantic_core import PydanticCustomError

from workbench.materials import refractive_index
from workbench.scene.fields import about
from workbench.scene.part import Part


class CustomIndex(Part):
    """A refractive index that is the same at all wavelengths."""

    model_config = ConfigDict(title="Custom index")

    index: Annotated[
        float, about("Index", "Refractive index at the wavelength of the light.", gt=1)
    ]
    _off: tuple[str, float] | None = PrivateAttr(default=None)

    def at(self, wavelength_um: float) -> float:
        """Refractive index at a wavelength."""
        if self._off is None:
            return self.index
        name, off = self._off
        return refractive_index(name, wavelength_um) + off


def denser(material: str | CustomIndex, index: float, off: float) -> CustomIndex:
    """Return a material whose index, which is given, is off; its dispersion stays.

    No scene file has it: there it is its index alone.
    """
    made = CustomIndex(index=index + off)
    if isinstance(material, str):
        made._off = material, off
    return made


def _name_or_index(value: Any, read: ValidatorFunctionWrapHandler) -> Any:
    # One error, not one for each member of the union.
    try:
        return read(value)
    except ValidationError:
        raise PydanticCustomError("material", "neither a name nor an index above 1") from None


Material = Annotated[str | CustomIndex, WrapValidator(_name_or_index)]
