"""EULUMDAT (.ldt): a line for each value, in a fixed order.

Programs write the utilisation factors differently (left empty, or several in a line), and the
planes too (all, or only those with intensities). The reader tries these variants and uses the one
that fits the number of values in the file.
"""

import re
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from workbench.measured.photometry.table import IntensityTable, possible, table_of
from workbench.measured.text import count, lines_of, number, trailing, with_points, wrong_length
from workbench.messages import Message

_MOST_ANGLES = 1 << 14
_MOST_LAMPS = 20
_HEAD = 26  # lines before the sets of lamps
_LAMP = 6  # lines of each
_RATIOS = 10  # direct ratios of rooms
_SYMMETRY, _PLANES, _ANGLES, _FACTOR, _LAMPS = 2, 3, 5, 23, 25  # their lines, from 0
_NUMBERS = (2, 3, 4, 5, 6, *range(12, 26))  # lines of the head that hold numbers
_FLUX = 2  # line of a set of lamps
_COMMENT = re.compile(r"\s*(?:[;#]|//).*$")


def read_ldt(content: bytes) -> IntensityTable:
    """Read the content of an EULUMDAT file; raise ValueError if it is invalid."""
    lines = _with_points(lines_of(content))
    if len(lines) <= _HEAD:
        raise ValueError(
            Message(
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
    lumens = _value(lines, _HEAD + _FLUX)
    # They are given per 1000 lm of the lamps. A factor of 0 is a line that was left empty.
    factor = (_value(lines, _FACTOR) or 1.0) * (lumens or 1000.0) / 1000
    refused = None
    for words, listed in _possible_readings(rest, symmetry, n_c):
        try:
            return _table(words, symmetry, (n_c, listed), n_gamma, factor)
        except ValueError as error:
            refused = refused or error
    raise refused or ValueError(Message("it is cut off within {part}", part=Message("its lamps")))


def _with_points(lines: list[str]) -> list[str]:
    known = {k for k in _NUMBERS if k < len(lines)}
    lamps = lines[_LAMPS] if len(lines) > _LAMPS else ""
    sets = int(lamps) if lamps.isdecimal() and len(lamps) < 3 else 1
    first = _HEAD + _LAMP * sets
    known |= set(range(_HEAD + _FLUX, min(first, len(lines)), _LAMP))
    known |= set(range(first, len(lines)))
    split = [(_COMMENT.sub("", lines[k]) or lines[k]).split() for k in sorted(known)]
    words = iter(with_points([word for line in split for word in line]))
    for k, line in zip(sorted(known), split, strict=True):
        lines[k] = " ".join(next(words) for _ in line)
    return lines


def _possible_readings(rest: list[str], symmetry: int, n_c: int) -> Iterator[tuple[list[str], int]]:
    by_lines = [word for line in rest[_RATIOS:] for word in line.split()]
    by_words = [word for line in rest for word in line.split()][_RATIOS:]
    stored = _count_stored(symmetry, n_c)
    for words in (by_words, by_lines):
        for listed in dict.fromkeys((n_c, stored)):
            yield words, listed


def _table(
    words: list[str], symmetry: int, planes: tuple[int, int], n_gamma: int, factor: float
) -> IntensityTable:
    n_c, listed = planes
    stored = _count_stored(symmetry, n_c)
    needed = listed + n_gamma + stored * n_gamma
    words, remarks = trailing(words, needed)
    if len(words) != needed:
        raise ValueError(
            Message(
                "{problem}: its header makes {needed} numbers behind the lamps, and there are "
                "{found}",
                problem=wrong_length(len(words), needed),
                needed=needed + _RATIOS,
                found=len(words) + _RATIOS,
            )
        )
    numbers = np.array([number(word) for word in words])
    c, gamma, values = np.split(numbers, [listed, listed + n_gamma])
    with np.errstate(all="ignore"):
        candela, negative = possible(factor * values.reshape(stored, n_gamma))
    c = c if listed == stored else c[_stored(symmetry, n_c)]
    if symmetry == 3 and c[0] >= 270:  # from C270 by C0 to C90
        c = np.where(c >= 270, c - 360, c)
    if symmetry == 1:
        c = c[:1]
    return replace(table_of(c, gamma, candela), remarks=remarks + negative)


def _count_stored(symmetry: int, n_c: int) -> int:
    return len(_stored(symmetry, n_c))


def _stored(symmetry: int, n_c: int) -> list[int]:
    if symmetry == 1:
        return [0]
    if symmetry == 0:
        return list(range(n_c))
    parts = 2 if symmetry == 2 else 4
    if n_c % parts:
        raise ValueError(
            Message(
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
    return number(lines[line]) if line < len(lines) and lines[line] else 0.0
