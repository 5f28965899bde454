"""Words as a picture."""

from importlib.util import find_spec
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.said import Said

_LETTER = 256  # pixels of a letter's height, with what is above and below it
_LARGEST = 8192  # pixels of the picture's longer side
_FONT = "mpl-data/fonts/ttf/DejaVuSans-Bold.ttf"  # Latin, Greek, Cyrillic and many signs


def picture_of_text(text: str) -> Array:
    r"""Draw words in bold letters, centred line by line.

    Parameters
    ----------
    text : str
        The words; ``\n``, as one character or as the two that a person types, begins a new line.

    Returns
    -------
    ndarray, shape (rows, columns)
        Values in [0, 1], row 0 at the top, cut to what is drawn.

    Raises
    ------
    Refused
        If nothing is drawn by these characters.
    """
    text = text.replace("\\n", "\n")
    left, top, right, bottom = _box(text, _font(_LETTER))
    longest = max(right - left, bottom - top, 1)
    font = _font(int(_LETTER * min(1, _LARGEST / longest)))
    left, top, right, bottom = map(round, _box(text, font))
    drawn = Image.new("L", (right - left + 1, bottom - top + 1))
    ImageDraw.Draw(drawn).text((-left, -top), text, fill=255, font=font, align="center")
    lit = drawn.getbbox()
    if lit is None:
        nothing = Said("{text!r} draws nothing; letters, digits or signs are needed", text=text)
        raise Refused("target.text", nothing)
    return np.asarray(drawn.crop(lit)) / 255.0


def _font(size: int) -> ImageFont.FreeTypeFont:
    """A font that comes with matplotlib, which is not imported for it."""
    spec = find_spec("matplotlib")
    if spec is None or spec.origin is None:
        raise FileNotFoundError("matplotlib, whose font draws words, is not installed")
    return ImageFont.truetype(str(Path(spec.origin).parent / _FONT), size)


def _box(text: str, font: ImageFont.FreeTypeFont) -> tuple[float, float, float, float]:
    """Left, top, right and bottom of what is drawn."""
    return ImageDraw.Draw(Image.new("L", (1, 1))).textbbox((0, 0), text, font, align="center")
