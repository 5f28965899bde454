"""What is stated of a photograph of the projected light, with titles and tips."""

from dataclasses import dataclass
from typing import ClassVar

from workbench.option_groups import OptionGroup, option


@dataclass(frozen=True)
class PhotographOptions(OptionGroup):
    """Meaning of the pixel values of a photograph."""

    called: ClassVar[str] = "a photograph"

    tone: str = option(
        "Brightness",
        "Meaning of pixel values, unless the file has a colour profile.",
        "srgb",
        kind=str,
        choices={"srgb": "as shown by a monitor", "linear": "as stored"},
    )
