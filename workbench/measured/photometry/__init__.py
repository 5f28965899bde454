"""Photometric files, intensity by direction: IES LM-63 (.ies) and EULUMDAT (.ldt)."""

from collections.abc import Callable, Mapping
from pathlib import PurePath
from typing import BinaryIO

from workbench.errors import Refused
from workbench.measured.photometry.ies import read_ies
from workbench.measured.photometry.ldt import read_ldt
from workbench.measured.photometry.table import IntensityTable
from workbench.measured.text import read_whole
from workbench.messages import Message

__all__ = ["ENDINGS", "IntensityTable", "read_photometry"]

_READERS: Mapping[str, Callable[[bytes], IntensityTable]] = {".ies": read_ies, ".ldt": read_ldt}
ENDINGS = tuple(_READERS)
_LARGEST = 1 << 24  # bytes; the largest measured tables have a tenth


def read_photometry(name: PurePath, file: BinaryIO) -> IntensityTable:
    """Read a photometric file; the ending of ``name`` selects the format.

    Raise Refused, with ``name``, if the format is unknown or the content unusable.
    """
    reader = _READERS.get(name.suffix.lower())
    if reader is None:
        raise Refused(
            str(name),
            Message("is no photometric file; {endings} is needed", endings=" or ".join(ENDINGS)),
        )
    return read_whole(name, file, reader, _LARGEST)
