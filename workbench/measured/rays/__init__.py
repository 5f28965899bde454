"""Ray files: IES TM-25 (.tm25ray), OpticStudio (.dat), text (.csv, .txt)."""

from collections.abc import Callable, Mapping
from pathlib import PurePath
from typing import BinaryIO

from workbench.errors import Refused
from workbench.measured.rays.opticstudio import read_dat, read_text
from workbench.measured.rays.rayset import MOST_RAYS, RaySet
from workbench.measured.rays.tm25 import read_tm25
from workbench.measured.text import problem_in
from workbench.messages import Message

__all__ = ["ENDINGS", "MOST_RAYS", "RaySet", "read_rays"]

_READERS: Mapping[str, Callable[[BinaryIO], RaySet]] = {
    ".tm25ray": read_tm25,
    ".dat": read_dat,
    ".csv": read_text,
    ".txt": read_text,
}
ENDINGS = tuple(_READERS)


def read_rays(name: PurePath, file: BinaryIO) -> RaySet:
    """Read a ray file, thinned if very large; the ending of ``name`` selects the format.

    Raise Refused, with ``name``, if the format is unknown or the content unusable.
    """
    reader = _READERS.get(name.suffix.lower())
    if reader is None:
        raise Refused(
            str(name), Message("is no ray file; {endings} are known", endings=", ".join(ENDINGS))
        )
    try:
        return reader(file)
    except ValueError as error:
        raise Refused(
            str(name), Message("cannot be used: {problem}", problem=problem_in(error))
        ) from error
