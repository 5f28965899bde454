"""EULUMDAT (.ldt): a line for each value, in a fixed order."""

import numpy as np

from workbench.measured.photometry.table import IntensityTable, table_of
from workbench.measured.text import count, lines_of, number, wrong_length
from workbench.said import Said

_MOST_ANGLES = 1 << 14
_MOST_LAMPS = 20
_HEAD = 26  # lines before the sets of lamps
_LAMP = 6  # lines of each
_RATIOS = 10  # direct ratios of rooms
_SYMMETRY, _PLANES, _ANGLES, _FACTOR, _LAMPS = 2, 3, 5, 23, 25  # their lines, from 0


def read_ldt(content: bytes) -> IntensityTable:
    """Read the content of an EULUMDAT file.

    Raises
    ------
    ValueError
        With what is wrong.
    """
    lines = [line.replace(",", ".") for line in lines_of(content)]
    if len(lines) <= _HEAD:
        raise ValueError(
            Said(
                "it is cut off: {found} of at least {least} lines are there",
                found=len(lines),
                least=_HEAD + 1,
            )
        )
    symmetry = count(lines[_SYMMETRY], 0, 4)
    n_c, n_gamma = (count(lines[k], 1, _MOST_ANGLES) for k in (_PLANES, _ANGLES))
    lamps = count(lines[_LAMPS], 1, _MOST_LAMPS)
    rest = lines[_HEAD + _LAMP * lamps :]
    # Further sets are lamps that it may have instead.
    lumens = _value(lines, _HEAD + 2)
    stored = _stored(symmetry, n_c)
    words = [word for line in rest for word in line.split()]
    needed = _RATIOS + n_c + n_gamma + len(stored) * n_gamma
    if len(words) != needed:
        raise ValueError(
            Said(
                "{problem}: its header makes {needed} numbers behind the lamps, and there are "
                "{found}",
                problem=wrong_length(len(words), needed),
                needed=needed,
                found=len(words),
            )
        )
    numbers = np.array([number(word) for word in words[_RATIOS:]])
    c, gamma, values = np.split(numbers, [n_c, n_c + n_gamma])
    # They are given per 1000 lm of the lamps. A factor of 0 is a line that was left empty.
    factor = (_value(lines, _FACTOR) or 1.0) * (lumens or 1000.0) / 1000
    planes = factor * values.reshape(len(stored), n_gamma)
    c = c[stored]
    return table_of(np.where(c >= 270, c - 360, c) if symmetry == 3 else c, gamma, planes)


def _stored(symmetry: int, n_c: int) -> list[int]:
    """Which of the planes of C have intensities in the file, as a luminaire has a symmetry."""
    if symmetry == 1:
        return [0]
    if symmetry == 0:
        return list(range(n_c))
    parts = 2 if symmetry == 2 else 4
    if n_c % parts:
        raise ValueError(
            Said(
                "its symmetry is {symmetry} and it has {n} planes of C; a multiple of {parts} is "
                "needed",
                symmetry=symmetry,
                n=n_c,
                parts=parts,
            )
        )
    if symmetry == 4:
        return list(range(n_c // 4 + 1))
    if symmetry == 2:
        return list(range(n_c // 2 + 1))
    # From C270 by C0 to C90, as the planes stand in the file.
    return [(3 * n_c // 4 + k) % n_c for k in range(n_c // 2 + 1)]


def _value(lines: list[str], line: int) -> float:
    """The number of a line; 0 where it is empty or not there."""
    return number(lines[line]) if line < len(lines) and lines[line] else 0.0
