"""Arguments of what a person does by hand: where pictures go, and how the window looks."""

import argparse
from pathlib import Path

from tests.soak.screen import SIZE
from ui.words import LANGUAGES


def arguments(name: str) -> argparse.ArgumentParser:
    """A parser for them; ``name`` is that of the module."""
    parser = argparse.ArgumentParser(name)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--size", type=int, nargs=2, default=SIZE, metavar="PIXELS")
    parser.add_argument("--scale", default="1", help="of the user interface, as QT_SCALE_FACTOR")
    parser.add_argument("--theme", choices=("light", "dark"), default="light")
    parser.add_argument("--language", choices=LANGUAGES, default="en")
    return parser
