"""Text as a picture."""

import unicodedata
from functools import cache
from html import escape
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message
from workbench.targets.picture import UnusablePicture
from workbench.targets.svg import draw_svg, missing_letter

_LETTER = 256  # pixels of a letter's height, with what is above and below it
_LARGEST = 8192  # pixels of the picture's longer side
_FONT = "mpl-data/fonts/ttf/DejaVuSans-Bold.ttf"  # Latin, Greek, Cyrillic and many signs
_LINE = 1.2  # letter heights from line to line
_WIDEST = 12  # letter heights: more than any sign is wide
_ROUGH = 2048  # pixels of the first picture, which locates the text
_MARGIN = 2  # of these pixels


def picture_of_text(text: str) -> Array:
    """Draw text in bold letters, centred line by line; values (rows, columns) in [0, 1].

    A newline, or a backslash and n, begins a new line; a tab is a space. Letters that the program's
    own font lacks come from fonts of the system. Raise Refused if no font has one of the letters,
    or the text draws nothing.
    """
    lines = "\n".join(text.replace("\\n", "\n").splitlines())
    text = unicodedata.normalize("NFC", lines.replace("\t", " "))
    try:
        drawn = _drawn(text) if _is_simple(text) else _drawn_by_system(text)
    except UnusablePicture as unusable:
        raise Refused("target.text", unusable.reason) from unusable
    lit = drawn.getbbox()
    if lit is None:
        nothing = Message("{text!r} draws nothing; letters, digits or signs are needed", text=text)
        raise Refused("target.text", nothing)
    return np.asarray(drawn.crop(lit)) / 255.0


def _is_simple(text: str) -> bool:
    return all(
        letter == "\n"
        or (
            ord(letter) in _letters()
            and not unicodedata.combining(letter)
            and unicodedata.bidirectional(letter) not in ("R", "AL", "AN")
        )
        for letter in text
    )


def _drawn(text: str) -> Image.Image:
    left, top, right, bottom = _box(text, _font(_LETTER))
    longest = max(right - left, bottom - top, 1)
    font = _font(int(_LETTER * min(1, _LARGEST / longest)))
    left, top, right, bottom = map(round, _box(text, font))
    drawn = Image.new("L", (right - left + 1, bottom - top + 1))
    ImageDraw.Draw(drawn).text((-left, -top), text, fill=255, font=font, align="center")
    return drawn


def _drawn_by_system(text: str) -> Image.Image:
    for letter in text:
        if unicodedata.category(letter) in ("Cc", "Cs") and letter != "\n":
            raise missing_letter(letter)
    lines = text.split("\n")
    half_width = _WIDEST * max(map(len, lines)) / 2 + 1
    whole = (-half_width, -2.0, 2 * half_width, _LINE * len(lines) + 3.0)
    rough = _drawn_svg(lines, whole, _ROUGH)
    if (lit := rough.getbbox()) is None:
        return rough
    pixel = max(whole[2:]) / _ROUGH
    left, top = (
        begin + (at - _MARGIN) * pixel for begin, at in zip(whole[:2], lit[:2], strict=True)
    )
    width, height = ((lit[k + 2] - lit[k] + 2 * _MARGIN) * pixel for k in range(2))
    side = round(min(_LETTER * max(width, height), _LARGEST))
    return _drawn_svg(lines, (left, top, width, height), side)


def _drawn_svg(lines: list[str], box: tuple[float, float, float, float], side: int) -> Image.Image:
    spans = "".join(
        f'<text x="0" y="{_LINE * number}" xml:space="preserve">{escape(line)}</text>'
        for number, line in enumerate(lines)
    )
    content = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{" ".join(map(str, box))}">'
        f'<g font-family="DejaVu Sans" font-weight="bold" font-size="1" fill="white" '
        f'text-anchor="middle">{spans}</g></svg>'
    )
    with Image.open(BytesIO(draw_svg(content.encode(), side))) as drawn:
        return drawn.convert("RGBA").getchannel("A")


@cache
def _letters() -> frozenset[int]:
    from fontTools.ttLib import TTFont  # slow import

    with TTFont(_font_file(), lazy=True) as font:
        return frozenset(font.getBestCmap())


def _font(size: int) -> ImageFont.FreeTypeFont:
    return ImageFont.truetype(str(_font_file()), size)


def _font_file() -> Path:
    spec = find_spec("matplotlib")
    if spec is None or spec.origin is None:
        raise FileNotFoundError("matplotlib, whose font draws words, is not installed")
    return Path(spec.origin).parent / _FONT


def _box(text: str, font: ImageFont.FreeTypeFont) -> tuple[float, float, float, float]:
    return ImageDraw.Draw(Image.new("L", (1, 1))).textbbox((0, 0), text, font, align="center")
