"""IES LM-63 of 1986, 1991, 1995, 2002 and 2019.

Numbers run on over lines and are known by their order: the ten that say how the light was measured,
three of the ballast, angles γ, angles C, and the intensities plane by plane.
"""

import re

import numpy as np

from workbench.measured.photometry.table import IntensityTable, table_of
from workbench.measured.text import count, lines_of, number, readings, wrong_length
from workbench.said import Said

_MOST_ANGLES = 1 << 14
_VERSIONS = "LM-63-1986", "IESNA91", "LM-63-1991", "LM-63-1995", "LM-63-2002", "LM-63-2019"
# A first line that names a version; without one it is the text of a file of 1986.
_VERSION = re.compile(r"^IES|LM-?63-?\d")
_TYPE_C = 1
_TYPES = {1: "C", 2: "B", 3: "A"}


def read_ies(content: bytes) -> IntensityTable:
    """Read the content of an IES file.

    Raises
    ------
    ValueError
        With what is wrong.
    """
    lines = lines_of(content)
    version = lines[0].replace(" ", "").upper()
    said = _VERSION.search(version)
    if said and not any(known in version for known in _VERSIONS):
        raise ValueError(
            Said(
                "it says to be of version {found!r}; known are {known}",
                found=lines[0][:30],
                known=", ".join(_VERSIONS),
            )
        )
    tilt = next((k for k, line in enumerate(lines) if line.upper().startswith("TILT=")), None)
    if tilt is None:
        raise ValueError(Said("it has no line that begins with TILT=, as each IES file has"))
    given = lines[tilt].partition("=")[2].strip().upper()
    if given not in ("NONE", "INCLUDE"):
        raise ValueError(
            Said(
                "its TILT is in another file, {file!r}; NONE or INCLUDE is needed", file=given[:30]
            )
        )
    text = "\n".join(lines[tilt + 1 :])
    refused = None
    for words in readings(text):
        try:
            return _table(words, given == "INCLUDE")
        except ValueError as error:
            refused = refused or error
    raise refused or ValueError(Said("it ends behind its TILT"))


def _table(words: list[str], tilted: bool) -> IntensityTable:
    words = words[_length_of_tilt(words) :] if tilted else words
    if len(words) < 13:
        raise ValueError(
            Said("it is cut off: {n} of 13 numbers stand before its angles", n=len(words))
        )
    multiplier = number(words[2])
    n_gamma, n_c = (count(word, 1, _MOST_ANGLES) for word in words[3:5])
    kind = count(words[5], 1, 3)
    if kind != _TYPE_C:
        raise ValueError(
            Said("it is of photometric type {found}; type C is needed", found=_TYPES[kind])
        )
    factor = multiplier * number(words[10])  # of the ballast
    needed = 13 + n_gamma + n_c + n_gamma * n_c
    if len(words) != needed:
        raise ValueError(
            Said(
                "{problem}: its header makes {needed} numbers, and there are {found}",
                problem=wrong_length(len(words), needed),
                needed=needed,
                found=len(words),
            )
        )
    numbers = np.array([number(word) for word in words[13:]])
    gamma, c, candela = np.split(numbers, [n_gamma, n_gamma + n_c])
    return table_of(c, gamma, factor * candela.reshape(n_c, n_gamma))


def _length_of_tilt(words: list[str]) -> int:
    """How many numbers tell of lamps that shine differently when tilted: here they are upright."""
    if len(words) < 2:
        raise ValueError(Said("it is cut off within {part}", part=Said("its TILT")))
    # How a lamp stands, the number of angles, these, and as many factors.
    return 2 + 2 * count(words[1], 0, _MOST_ANGLES)
