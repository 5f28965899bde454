"""Drawing of SVG in a separate process.

The renderer recurses into nested elements: a malicious or damaged file can crash its process or
keep it busy for hours.
"""

import re
import subprocess
import sys
from pathlib import Path

from workbench.messages import Message
from workbench.targets.picture import UnusablePicture

_TIME_LIMIT_S = 60.0

_PROGRAM = Path(__file__).with_name("svg_renderer.py")
_UTF_16 = (b"\xff\xfe", b"\xfe\xff", b"<\0", b"\0<")  # with a mark of the byte order, or without
_BEGINNINGS = (b"<?xml", b"<svg", b"<!")
# Log line of the renderer for a letter that no font has.
_NO_FONT = re.compile(r"U\+([0-9A-F]{2,6}) character")
_LINK = re.compile(r"link to a picture: (.*)")


def is_svg(beginning: bytes) -> bool:
    """Whether a file with this beginning is SVG."""
    if beginning.startswith(_UTF_16):
        beginning = (
            beginning.replace(b"\xff\xfe", b"").replace(b"\xfe\xff", b"").replace(b"\0", b"")
        )
    return beginning.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(_BEGINNINGS)


def draw_svg(content: bytes, side: int) -> bytes:
    """Draw an SVG as a PNG with transparency, fitted into a square of ``side`` pixels.

    Raise UnusablePicture if it cannot be drawn, links to another picture, or has a letter that no
    font has.
    """
    command = [sys.executable, "-I", str(_PROGRAM), str(side)]
    try:
        done = subprocess.run(
            command, input=content, capture_output=True, timeout=_TIME_LIMIT_S, check=False
        )
    except subprocess.TimeoutExpired as error:
        raise _undrawable(
            Message("it cannot be drawn within {most:g} s", most=_TIME_LIMIT_S)
        ) from error
    log = done.stderr.decode(errors="replace")
    if missing := _NO_FONT.search(log):
        raise missing_letter(chr(int(missing[1], 16)))
    if done.returncode == 0:
        return done.stdout
    if link := _LINK.search(log):
        raise UnusablePicture(
            Message("links to the picture '{link}'; embed that picture in the SVG", link=link[1])
        )
    lines = log.strip().splitlines()
    raise _undrawable(lines[-1] if lines else Message("it is nested too deeply to be drawn"))


def missing_letter(letter: str) -> UnusablePicture:
    """Return the exception for a letter that no font has."""
    return UnusablePicture(
        Message(
            "has the letter {letter} (U+{number:04X}), which no font here has; install one",
            letter=letter if letter.isprintable() else repr(letter),
            number=ord(letter),
        )
    )


def _undrawable(why: str) -> UnusablePicture:
    return UnusablePicture(Message("is an SVG that cannot be drawn: {why}", why=why))
