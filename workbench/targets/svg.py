"""Draws SVG, in a process of its own.

The renderer follows what is nested by calling itself: a file made for it, or a damaged one, can end
the process that it runs in, or keep it busy for hours.
"""

import subprocess
import sys
from pathlib import Path

_PATIENCE_S = 60.0

_PROGRAM = Path(__file__).with_name("svg_renderer.py")


def is_svg(beginning: bytes) -> bool:
    """Whether a file that begins like this is to be drawn as SVG."""
    return beginning.removeprefix(b"\xef\xbb\xbf").lstrip().startswith((b"<?xml", b"<svg", b"<!"))


def draw_svg(content: bytes, side: int) -> bytes:
    """Draw an SVG as large as fits into a square; pictures that it links to are left out.

    Parameters
    ----------
    content : bytes
        The file, in UTF-8.
    side : int
        Pixels of the square's side.

    Returns
    -------
    bytes
        A PNG with transparency.

    Raises
    ------
    ValueError
        With what is wrong, if it cannot be drawn.
    """
    command = [sys.executable, "-I", str(_PROGRAM), str(side)]
    try:
        done = subprocess.run(
            command, input=content, capture_output=True, timeout=_PATIENCE_S, check=False
        )
    except subprocess.TimeoutExpired as error:
        raise ValueError(f"it cannot be drawn within {_PATIENCE_S:g} s") from error
    if done.returncode == 0:
        return done.stdout
    lines = done.stderr.decode(errors="replace").strip().splitlines()
    raise ValueError(lines[-1] if lines else "it is nested too deeply to be drawn")
