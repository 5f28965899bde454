"""A program of its own: draws the SVG on standard input as PNG on standard output.

Its argument is the number of pixels along the longer side. What is wrong is one line on standard
error. Pictures in other files, which the SVG may link to, are not drawn.
"""

import math
import re
import sys
from base64 import b64encode
from collections.abc import Mapping
from io import BytesIO
from xml.etree import ElementTree

import resvg_py

_DPI = 96
_PIXELS = {"": 1, "px": 1, "in": 96, "cm": 96 / 2.54, "mm": 96 / 25.4, "pt": 96 / 72, "pc": 16}
_LENGTH = re.compile(r"\s*([0-9.eE+-]+)\s*([a-z]*)\s*")

# The renderer cuts a drawing off at whole units of its own; within another one it does not, and
# reads no files either.
_FRAME = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}">'
    '<image width="{0}" height="{1}" href="data:image/svg+xml;base64,{2}"/></svg>'
)


def main(side: int) -> None:
    """Draw it."""
    content = sys.stdin.buffer.read().removeprefix(b"\xef\xbb\xbf")
    try:
        _, root = next(ElementTree.iterparse(BytesIO(content), events=("start",)))
        if root.tag != "{http://www.w3.org/2000/svg}svg":
            raise ValueError("it has no <svg> at its root")
        width, height = _size(root.attrib) or _measured(content)
        scale = side / max(width, height)
        columns, rows = (max(1, round(scale * size)) for size in (width, height))
        # First by itself, which says what is wrong: within the frame it would just not be there.
        resvg_py.svg_to_bytes(svg_string=content.decode(), width=1, height=1, dpi=_DPI)
        framed = _FRAME.format(columns, rows, b64encode(content).decode())
        drawn = resvg_py.svg_to_bytes(svg_string=framed, dpi=_DPI)
    except (ValueError, SyntaxError, StopIteration) as error:
        sys.exit(" ".join(str(error).split()) or "it is empty")
    sys.stdout.buffer.write(drawn)


def _size(root: Mapping[str, str]) -> tuple[float, float] | None:
    """Width and height in any unit, where the drawing says them."""
    width, height = _pixels(root.get("width")), _pixels(root.get("height"))
    if width and height:
        return width, height
    box = root.get("viewBox", "").replace(",", " ").split()
    if len(box) != 4:
        return None
    _, _, width, height = map(float, box)
    return (width, height) if 0 < width < math.inf and 0 < height < math.inf else None


def _pixels(length: str | None) -> float | None:
    """A length that is a size; None for one of which only the surroundings know what it is."""
    found = _LENGTH.fullmatch(length or "")
    if found is None or found[2] not in _PIXELS:
        return None
    size = float(found[1]) * _PIXELS[found[2]]
    return size if 0 < size < math.inf else None


def _measured(content: bytes) -> tuple[int, int]:
    """Width and height as the renderer finds them."""
    header = resvg_py.svg_to_bytes(svg_string=content.decode(), dpi=_DPI)[16:24]
    return int.from_bytes(header[:4], "big"), int.from_bytes(header[4:], "big")


if __name__ == "__main__":
    main(int(sys.argv[1]))
