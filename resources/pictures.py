"""Pictures that people project: scikit-image's photographs, and drawn words, codes and line art."""

from collections.abc import Callable, Sequence
from functools import partial
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from workbench.errors import Refused

PHOTOGRAPHS = (
    *("astronaut", "brick", "camera", "chelsea", "coffee", "coins", "horse", "logo", "moon"),
    *("page", "phantom", "text", "hubble_deep_field", "retina", "rocket"),
)
"""Names of scikit-image's photographs, whose values are those of a monitor (sRGB)."""
_JPEGS = ("hubble_deep_field", "retina", "rocket")

_UNIT = 256  # pixels a side that fonts and places are given for
_FINER = 4  # before curves and slanted lines are averaged over pixels
_CHECKS, _MODULES = 8, 21  # a side


def picture(name: str, pixels: int) -> Image.Image:
    """Return a square grey picture of ``pixels`` a side, one of `PICTURES`.

    Raises `Refused` if it is a photograph and scikit-image is not installed.
    """
    return DRAWN[name](pixels) if name in DRAWN else _photograph(name, pixels)


def _photograph(name: str, pixels: int) -> Image.Image:
    package = find_spec("skimage")  # its files alone are needed, and importing it takes long
    if package is None or package.origin is None:
        raise Refused(
            name,
            "is a photograph of scikit-image, which pip install "
            "'freeform-lens-workbench[pictures]' brings",
        )
    file = Path(package.origin).with_name("data") / f"{name}.{'jpg' if name in _JPEGS else 'png'}"
    image: Image.Image
    with Image.open(file) as image:
        if image.mode in ("RGBA", "LA", "P"):
            image = image.convert("RGBA")
            image = Image.alpha_composite(Image.new("RGBA", image.size, (0, 0, 0, 255)), image)
        image = image.convert("L")
    side = min(image.size)
    left, top = (image.width - side) // 2, (image.height - side) // 2
    middle = image.crop((left, top, left + side, top + side))
    return middle.resize((pixels, pixels), Image.Resampling.LANCZOS)


def _words(lines: Sequence[str], size: int, first: int, step: int, pixels: int) -> Image.Image:
    from matplotlib import get_data_path  # slow import

    file = Path(get_data_path(), "fonts", "ttf", "DejaVuSans-Bold.ttf")
    font = ImageFont.truetype(str(file), int(size * pixels / _UNIT))
    image = Image.new("L", (pixels, pixels), 0)
    draw = ImageDraw.Draw(image)
    for number, line in enumerate(lines):
        middle = pixels / 2, (first + step * number) * pixels / _UNIT
        draw.text(middle, line, font=font, fill=255, anchor="mm")
    return image


def _checker(pixels: int) -> Image.Image:
    y, x = np.mgrid[:pixels, :pixels] // (pixels // _CHECKS)
    return Image.fromarray(np.uint8(255 * ((x + y) % 2)))


def _dots(pixels: int) -> Image.Image:
    side = _FINER * pixels
    image = Image.new("L", (side, side), 0)
    draw = ImageDraw.Draw(image)
    radius = 0.06 * side
    for i in range(3):
        for j in range(3):
            x, y = (0.2 + 0.3 * i) * side, (0.2 + 0.3 * j) * side
            draw.ellipse([x - radius, y - radius, x + radius, y + radius], fill=255)
    return image.resize((pixels, pixels), Image.Resampling.BOX)


def _star(pixels: int) -> Image.Image:
    side = _FINER * pixels
    image = Image.new("L", (side, side), 0)
    draw = ImageDraw.Draw(image)
    for angle in np.linspace(0, np.pi, 12, endpoint=False):
        x, y = 0.45 * side * np.cos(angle), 0.45 * side * np.sin(angle)
        ends = [side / 2 - x, side / 2 - y, side / 2 + x, side / 2 + y]
        draw.line(ends, fill=255, width=side // 51)
    return image.resize((pixels, pixels), Image.Resampling.BOX)


def _code(pixels: int) -> Image.Image:
    modules = np.random.default_rng(7).random((_MODULES, _MODULES)) < 0.5
    image = Image.fromarray(np.uint8(255 * modules))
    return image.resize((pixels, pixels), Image.Resampling.NEAREST)


DRAWN: dict[str, Callable[[int], Image.Image]] = {
    "hello": partial(_words, ["HELLO"], 64, 128, 0),
    "words": partial(_words, ["The light", "of one", "lens makes", "all of this"], 40, 40, 58),
    "checker": _checker,
    "dots": _dots,
    "star": _star,
    "code": _code,
}
"""Drawn pictures by name; their values are the light itself."""

PICTURES = (*PHOTOGRAPHS, *DRAWN)
"""Names of all pictures."""
