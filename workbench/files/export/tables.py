"""Columns of numbers as text."""

import io
from collections.abc import Sequence
from typing import BinaryIO

import numpy as np

from workbench.arrays import Array

_ROWS_AT_ONCE = 1 << 16  # as text they stay small


def write_table(
    file: BinaryIO, columns: Sequence[Array], header: str, delimiter: str, newline: str = "\n"
) -> Array:
    """Write columns below a line of text, with 15 digits.

    Parameters
    ----------
    file : BinaryIO
        Gets the text.
    columns : sequence of ndarray, shape (m,)
        The columns.
    header : str
        First line.
    delimiter, newline : str
        What stands between numbers and at the end of lines.

    Returns
    -------
    ndarray, shape (m, columns)
        What has been written, as it is read again.
    """
    file.write((header + newline).encode())
    table = np.column_stack(columns)
    written = np.empty_like(table)
    for first in range(0, len(table), _ROWS_AT_ONCE):
        rows = slice(first, first + _ROWS_AT_ONCE)
        with io.BytesIO() as text:
            np.savetxt(text, table[rows], "%.15g", delimiter, newline)
            file.write(text.getbuffer())
            text.seek(0)
            written[rows] = np.loadtxt(text, delimiter=delimiter.strip() or None, ndmin=2)
    return written


def rounding(written: Array, column: int, exact: Array) -> float:
    """How far a column is from what it should be, at most."""
    return float(np.abs(written[:, column] - exact).max(initial=0.0))
