"""Icons, example scenes and target images that ship with the program."""

from importlib import resources
from pathlib import Path

EXAMPLES = ("tophat", "flame", "ball", "flame-512", "ball-512")
"""Names of the example scenes, ``path("examples", f"{name}.json")``."""


def path(*parts: str) -> Path:
    """Where a shipped file lies, in a source tree as well as in an installed wheel.

    Parameters
    ----------
    *parts : str
        Folder and file name below this package, such as ``"icons", "start.svg"``.
    """
    return Path(str(resources.files(__name__).joinpath(*parts)))
