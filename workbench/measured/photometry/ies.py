"""IES LM-63 of 1986, 1991, 1995, 2002 and 2019.

Numbers run on over lines and are identified by their order: ten of the measurement, three of the
ballast, vertical angles, horizontal angles, and the intensities plane by plane.
"""

import re
from dataclasses import replace

import numpy as np

from workbench.measured.photometry.table import TYPES, IntensityTable, possible, table_of, type_c_of
from workbench.measured.text import count, lines_of, number, readings, trailing, wrong_length
from workbench.messages import Message

_MOST_ANGLES = 1 << 14
_YEARS = {"86": 1986, "91": 1991, "95": 1995, "02": 2002, "19": 2019}
# First line with a version; a file with any other first line is of 1986.
_STANDARD = re.compile(r"^(ANSI/?)?(IESNA|IES)?[:/]?LM-?63-?(\d*)")
_SHORT = re.compile(r"^(IESNA|IES):?(\d{4}|\d{2})$")
_TILT = re.compile(r"^TILT\s*=\s*(.*)$", re.IGNORECASE)
# Up to this year the ballast-lamp photometric factor multiplies intensities; later the field has
# another meaning.
_WITH_LAMP_FACTOR = 1991


def read_ies(content: bytes) -> IntensityTable:
    """Read the content of an IES file; raise ValueError if it is invalid."""
    lines = lines_of(content)
    year = _year(next((line for line in lines if line), ""))
    tilts = (
        match and (k, match[1].strip(" \"'"))
        for k, line in enumerate(lines)
        for match in (_TILT.match(line),)
    )
    tilt, given = next(filter(None, tilts), (None, ""))
    if tilt is None:
        raise ValueError(Message("it has no line that begins with TILT=, as each IES file has"))
    if given.upper() not in ("NONE", "INCLUDE"):
        raise ValueError(
            Message(
                "its TILT is in another file, {file!r}; NONE or INCLUDE is needed",
                file=given.upper()[:30],
            )
        )
    text = "\n".join(lines[tilt + 1 :])
    refused = None
    for words in readings(text):
        try:
            return _table(words, given.upper() == "INCLUDE", year)
        except ValueError as error:
            refused = refused or error
    raise refused or ValueError(Message("it ends behind its TILT"))


def _year(first: str) -> int:
    line = first.replace(" ", "").upper()
    if (match := _STANDARD.match(line)) and match[3]:
        year = match[3]
    elif match := _SHORT.match(line):
        year = match[2] if match[2][-2:] in _YEARS else "1986"
    else:
        return 1986
    known = _YEARS.get(year[-2:])
    if known is None or year not in (str(known), str(known)[2:]):
        raise ValueError(
            Message(
                "its version is {found!r}; known are {known}",
                found=first[:30],
                known=", ".join(f"LM-63-{each}" for each in _YEARS.values()),
            )
        )
    return known


def _table(words: list[str], tilted: bool, year: int) -> IntensityTable:
    words = words[_length_of_tilt(words) :] if tilted else words
    if len(words) < 13:
        raise ValueError(
            Message("it is cut off: {n} of 13 numbers stand before its angles", n=len(words))
        )
    multiplier = number(words[2])
    n_v, n_h = (count(word, 1, _MOST_ANGLES) for word in words[3:5])
    kind = TYPES[count(words[5], 1, 3)]
    factor = multiplier * number(words[10])  # of the ballast
    if year <= _WITH_LAMP_FACTOR:
        factor *= number(words[11])
    needed = 13 + n_v + n_h + n_v * n_h
    words, remarks = trailing(words, needed)
    if len(words) != needed:
        raise ValueError(
            Message(
                "{problem}: its header makes {needed} numbers, and there are {found}",
                problem=wrong_length(len(words), needed),
                needed=needed,
                found=len(words),
            )
        )
    numbers = np.array([number(word) for word in words[13:]])
    v, h, values = np.split(numbers, [n_v, n_v + n_h])
    with np.errstate(all="ignore"):
        candela, negative = possible(factor * values.reshape(n_h, n_v))
    table = table_of(h, v, candela) if kind == "C" else type_c_of(kind, h, v, candela)
    return replace(table, remarks=remarks + negative)


def _length_of_tilt(words: list[str]) -> int:
    if len(words) < 2:
        raise ValueError(Message("it is cut off within {part}", part=Message("its TILT")))
    # How a lamp stands, the number of angles, these, and as many factors.
    return 2 + 2 * count(words[1], 0, _MOST_ANGLES)
