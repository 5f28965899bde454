"""A program of its own: draws the SVG on standard input as PNG on standard output.

Its argument is the number of pixels along the longer side. What is wrong is one line on standard
error. Pictures in other files, which the SVG may link to, are not drawn.
"""

import math
import re
import sys
from collections.abc import Mapping
from importlib.util import find_spec
from xml.etree import ElementTree

import resvg_py

_DPI = 96
_PIXELS = {"": 1, "px": 1, "in": 96, "cm": 96 / 2.54, "mm": 96 / 25.4, "pt": 96 / 72, "pc": 16}
_LENGTH = re.compile(r"\s*([0-9.eE+-]+)\s*([a-z]*)\s*")

_SVG = "http://www.w3.org/2000/svg"
_LINKS = "href", "{http://www.w3.org/1999/xlink}href"


def main(side: int) -> None:
    """Draw it."""
    content = sys.stdin.buffer.read().removeprefix(b"\xef\xbb\xbf")
    try:
        root = ElementTree.fromstring(content)
        if root.tag != f"{{{_SVG}}}svg":
            raise ValueError("it has no <svg> at its root")
        _leave_out_links(root)
        width, height = _size(root.attrib) or _measured(root)
        scale = side / max(width, height)
        columns, rows = (max(1, round(scale * size)) for size in (width, height))
        # At whole pixels: the renderer cuts a drawing off at whole units.
        if "viewBox" not in root.attrib:
            root.set("viewBox", f"0 0 {width} {height}")
        root.set("width", str(columns))
        root.set("height", str(rows))
        drawn = _drawn(root)
    except RecursionError:
        sys.exit("it is nested too deeply to be drawn")
    except (ValueError, SyntaxError) as error:
        sys.exit(" ".join(str(error).split()) or "it is empty")
    sys.stdout.buffer.write(drawn)


def _leave_out_links(root: ElementTree.Element) -> None:
    """Take out of pictures within the drawing what would be read from other files."""
    for element in root.iter():
        for name in _LINKS:
            link = element.get(name, "").strip()
            if not link.startswith(("#", "data:")):
                element.attrib.pop(name, None)


def _drawn(root: ElementTree.Element) -> bytes:
    matplotlib = find_spec("matplotlib")
    places = [] if matplotlib is None else matplotlib.submodule_search_locations or []
    text = ElementTree.tostring(root, encoding="unicode")
    # For text whose own font is not there: fonts of matplotlib, so that all machines have them.
    drawn = resvg_py.svg_to_bytes(
        svg_string=text,
        dpi=_DPI,
        font_dirs=[f"{place}/mpl-data/fonts/ttf" for place in places],
        font_family="DejaVu Sans",
        sans_serif_family="DejaVu Sans",
        serif_family="DejaVu Serif",
        monospace_family="DejaVu Sans Mono",
        cursive_family="DejaVu Sans",
        fantasy_family="DejaVu Sans",
    )
    return bytes(drawn)


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


def _measured(root: ElementTree.Element) -> tuple[int, int]:
    """Width and height as the renderer finds them."""
    header = _drawn(root)[16:24]
    return int.from_bytes(header[:4], "big"), int.from_bytes(header[4:], "big")


if __name__ == "__main__":
    main(int(sys.argv[1]))
