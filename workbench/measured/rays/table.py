"""Rays as text: a line for each, with x, y, z, direction, flux and perhaps a wavelength in nm.

Columns are separated by commas, semicolons, tabs or spaces; decimal commas may occur with all of
these but the first. A line of titles may stand above, with the unit of length in brackets: "x
[mm]". Text is in UTF-8, Latin-1 or UTF-16.
"""

import codecs
import io
import re
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from typing import BinaryIO, cast

import numpy as np

from workbench import units
from workbench.errors import shown
from workbench.measured.rays.rayset import Columns, Floats, RaySet, gathered, size_of
from workbench.measured.text import encoding_of
from workbench.messages import Message

_AT_ONCE = 1 << 24  # bytes
_UNIT = re.compile(r"\[\s*(\w+)\s*\]|\(\s*(\w+)\s*\)")
_LONGEST_LINE = 1 << 12
# Marks and spaces beside the columns of a line.
_BESIDE = b" \t,;"
_MARKS_AT_END = re.compile(rb"[ \t,;]+(?=\n|$)")


@contextmanager
def in_utf8(file: BinaryIO) -> Iterator[BinaryIO]:
    """Yield the file itself, rewound, or a UTF-8 copy of a text in UTF-16."""
    size_of(file)
    encoding = encoding_of(file.read(_LONGEST_LINE))
    file.seek(0)
    if encoding is None:
        yield file
        return
    decoder = codecs.getincrementaldecoder(encoding)("replace")
    with tempfile.TemporaryFile() as copy:
        while content := file.read(_AT_ONCE):
            copy.write(decoder.decode(content).encode())
        copy.write(decoder.decode(b"", final=True).encode())
        copy.seek(0)
        yield cast(BinaryIO, copy)


def read_csv(file: BinaryIO) -> RaySet:
    """Read rays of an open file in UTF-8 or Latin-1; raise ValueError if it is invalid."""
    size_of(file)
    beginning = file.read(_LONGEST_LINE)
    skipped = len(beginning) - len(beginning.removeprefix(b"\xef\xbb\xbf"))
    unit = None
    while True:
        file.seek(skipped)
        line = re.split(rb"\r\n|\n|\r", file.read(_LONGEST_LINE))[0]
        text = line.decode("latin-1").strip()
        if not line and not file.read(1):
            raise ValueError(Message("it has no rays"))
        if text and not text.startswith("#") and not re.search(r"[A-Za-df-z]", text):
            break
        found = _UNIT.search(text)
        unit = unit or (_named(found[1] or found[2]) if found else None)
        skipped += max(len(line), 1)
        file.seek(skipped)
        skipped += len(re.match(rb"(\r\n|\n|\r)?", file.read(2))[0])  # type: ignore[index]
    file.seek(skipped)
    return read_below(file, unit)


def read_below(file: BinaryIO, unit: str | None) -> RaySet:
    """Read the lines of rays from the current position of a file; raise as `read_csv`."""
    start = file.tell()
    size = size_of(file)
    file.seek(start)
    sample = re.split(rb"[\r\n]+", file.read(_LONGEST_LINE).strip())[0].strip(_BESIDE)
    if not sample:
        raise ValueError(Message("it has no rays"))
    separator, comma = _marks(sample)
    width = len(sample.split(separator or None))
    if width not in (7, 8):
        raise ValueError(
            Message("its first ray has {n} numbers; 7, or 8 with a wavelength", n=width)
        )
    file.seek(start)
    about = (size - start) // max(len(sample), 1) + 1
    columns = Columns(wavelength=7 if width == 8 else None)
    return gathered(_chunks(file, separator, comma, width), columns, about, unit)


def _named(unit: str) -> str | None:
    return {"in": "inch", "ft": "feet"}.get(unit, unit) if unit in (*units.METRES, "in") else None


def _marks(line: bytes) -> tuple[bytes, bool]:
    if b";" in line:
        return b";", b"," in line
    if b"," in line and len(line.split()) in (7, 8) and not re.search(rb",\s", line):
        return b"", True
    return (b",", False) if b"," in line else (b"", False)


def _chunks(file: BinaryIO, separator: bytes, comma: bool, width: int) -> Iterator[Floats]:
    rest, line = b"", 0
    while content := file.read(_AT_ONCE):
        content = rest + content
        end = max(content.rfind(b"\n"), content.rfind(b"\r")) + 1
        if not end and len(content) > _AT_ONCE:
            raise ValueError(Message("it has a line without an end"))
        rest, content = content[end:], content[:end]
        if content.strip():
            table = _numbers(content, separator, comma, width, line)
            line += len(table)
            yield table
    if rest.strip():
        yield _numbers(rest, separator, comma, width, line)


def _numbers(content: bytes, separator: bytes, comma: bool, width: int, line: int) -> Floats:
    if b"\0" in content:
        raise ValueError(Message("it is no text"))
    content = content.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    if separator:  # a mark at the end of lines begins no column
        content = _MARKS_AT_END.sub(b"", content)
    if comma:
        content = content.replace(b",", b".")
    delimiter = separator.decode() or None
    try:
        text = io.StringIO(content.decode("latin-1"))
        table = np.loadtxt(text, np.float32, delimiter=delimiter, comments=None, ndmin=2)
    except ValueError as error:
        reason = shown(str(error).split(";")[0])
        raise ValueError(
            Message("behind ray {ray} it has no rays: {reason}", ray=line, reason=reason)
        ) from None
    if table.shape[1] != width:
        found = table.shape[1]
        raise ValueError(
            Message(
                "behind ray {ray} it has {found} columns; {width} as above",
                ray=line,
                found=found,
                width=width,
            )
        )
    return table
