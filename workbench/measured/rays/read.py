"""Reads a ray file by what its name says it is."""

from collections.abc import Callable, Mapping
from pathlib import PurePath
from typing import BinaryIO

from workbench.errors import Refused
from workbench.measured.rays.opticstudio import read_dat, read_text
from workbench.measured.rays.rayset import RaySet
from workbench.measured.rays.tm25 import read_tm25
from workbench.measured.text import problem_in
from workbench.said import Said

_READERS: Mapping[str, Callable[[BinaryIO], RaySet]] = {
    ".tm25ray": read_tm25,
    ".dat": read_dat,
    ".csv": read_text,
    ".txt": read_text,
}
ENDINGS = tuple(_READERS)
"""Endings of the names of ray files."""


def read_rays(name: PurePath, file: BinaryIO) -> RaySet:
    """Read the rays that a file holds, thinned where there are very many.

    Parameters
    ----------
    name : PurePath
        What refusals call it; its ending tells the format.
    file : BinaryIO
        Its content, which can be sought.

    Raises
    ------
    Refused
        If it is of another format, damaged, or holds a ray that is none.
    """
    reader = _READERS.get(name.suffix.lower())
    if reader is None:
        raise Refused(
            str(name), Said("is no ray file; {endings} are known", endings=", ".join(ENDINGS))
        )
    try:
        return reader(file)
    except ValueError as error:
        raise Refused(
            str(name), Said("cannot be used: {problem}", problem=problem_in(error))
        ) from error
