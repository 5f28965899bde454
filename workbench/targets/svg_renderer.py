"""Program that draws the SVG on standard input as PNG on standard output.

Its argument is the number of pixels of the longer side. The last line on standard error is the
error; above it the renderer logs letters that no font has. An SVG that links to pictures in other
files is refused.
"""

import math
import os
import re
import sys
from collections.abc import Mapping
from importlib.util import find_spec
from xml.etree import ElementTree

import resvg_py

_DPI = 96
_LONGEST_LINK = 200  # characters
_PIXELS = {"": 1, "px": 1, "in": 96, "cm": 96 / 2.54, "mm": 96 / 25.4, "pt": 96 / 72, "pc": 16}
_LENGTH = re.compile(r"\s*([0-9.eE+-]+)\s*([a-z]*)\s*")

_SVG = "http://www.w3.org/2000/svg"
_XLINK = "http://www.w3.org/1999/xlink"
_LINKS = "href", f"{{{_XLINK}}}href"
_DRAWN = {f"{{{_SVG}}}{name}" for name in ("image", "feImage", "use")}


def main(side: int) -> None:
    """Draw the picture."""
    content = sys.stdin.buffer.read().removeprefix(b"\xef\xbb\xbf")
    # The renderer logs to standard output, which is for the picture.
    output = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    try:
        root = _parsed(content)
        if root.tag != f"{{{_SVG}}}svg":
            raise ValueError("it has no <svg> at its root")
        _check_links(root)
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
    output.write(drawn)
    output.close()


def _parsed(content: bytes) -> ElementTree.Element:
    try:
        root = ElementTree.fromstring(content)
    except ElementTree.ParseError as error:
        if "unbound prefix" not in str(error):
            raise
        declared = f'<svg xmlns:xlink="{_XLINK}"'.encode()
        root = ElementTree.fromstring(content.replace(b"<svg", declared, 1))
    if root.tag == "svg":
        for element in root.iter():
            if isinstance(element.tag, str) and not element.tag.startswith("{"):
                element.tag = f"{{{_SVG}}}{element.tag}"
    return root


def _check_links(root: ElementTree.Element) -> None:
    for element in root.iter():
        for name in _LINKS:
            link = element.get(name, "").strip()
            if link and not link.startswith(("#", "data:")):
                if element.tag in _DRAWN:
                    raise ValueError(f"link to a picture: {link[:_LONGEST_LINK]}")
                element.attrib.pop(name)


def _drawn(root: ElementTree.Element) -> bytes:
    matplotlib = find_spec("matplotlib")
    places = [] if matplotlib is None else matplotlib.submodule_search_locations or []
    text = ElementTree.tostring(root, encoding="unicode")
    # For text whose own font is not there: fonts of matplotlib, so that all machines have them.
    drawn = resvg_py.svg_to_bytes(
        svg_string=text,
        log_information=True,
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
    width, height = _pixels(root.get("width")), _pixels(root.get("height"))
    if width and height:
        return width, height
    box = root.get("viewBox", "").replace(",", " ").split()
    if len(box) != 4:
        return None
    _, _, width, height = map(float, box)
    return (width, height) if 0 < width < math.inf and 0 < height < math.inf else None


def _pixels(length: str | None) -> float | None:
    found = _LENGTH.fullmatch(length or "")
    if found is None or found[2] not in _PIXELS:
        return None
    size = float(found[1]) * _PIXELS[found[2]]
    return size if 0 < size < math.inf else None


def _measured(root: ElementTree.Element) -> tuple[int, int]:
    header = _drawn(root)[16:24]
    return int.from_bytes(header[:4], "big"), int.from_bytes(header[4:], "big")


if __name__ == "__main__":
    main(int(sys.argv[1]))
