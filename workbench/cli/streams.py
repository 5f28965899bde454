"""Standard output and error that never fail.

1. A closed stream becomes the null device, before an opened file gets its number and libraries
   print into that file.
2. Characters that the encoding lacks are written in plain characters; see `in_encoding`.
3. A broken stream or a full disk does not end the work: the first error is kept for the exit
   status, and further output goes to the null device, also what Python flushes at exit. A reader
   that closes its end, like ``head``, is no error.
"""

import io
import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import TracebackType
from typing import Self, TextIO, cast

# Symbols and typographic signs. Letters of other alphabets are escaped: they may be part of a file
# name.
_PLAIN = {
    "×": "x",
    "·": "*",
    "−": "-",
    "–": "-",
    "—": "-",
    "±": "+-",
    "°": " deg",
    "²": "^2",
    "³": "^3",
    "µ": "u",
    "μ": "u",
    "½": "1/2",
    "…": "...",
    "“": '"',
    "”": '"',
    "‘": "'",
    "’": "'",
    "«": '"',
    "»": '"',
    "→": "->",
    "←": "<-",
    "≤": "<=",
    "≥": ">=",
    "≈": "~",
    "≠": "!=",
    "∞": "inf",
    "√": "sqrt ",
    "∅": "diameter ",
    "Ø": "diameter ",
    "§": "section ",
    "α": "alpha",
    "β": "beta",
    "γ": "gamma",
    "δ": "delta",
    "Δ": "Delta",
    "η": "eta",
    "θ": "theta",
    "κ": "kappa",
    "λ": "lambda",
    "ν": "nu",
    "π": "pi",
    "ρ": "rho",
    "σ": "sigma",
    "τ": "tau",
    "φ": "phi",
    "ω": "omega",
    "Ω": "Ohm",
    "\u00a0": " ",
    "\u2009": " ",
    "\u202f": " ",
}
_HIGH = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_DIGITS = str.maketrans(_HIGH, "-0123456789")
_POWER = re.compile(rf"(?:(?P<number>-?\d+(?:\.\d+)?) · )?10(?P<exponent>[{_HIGH}]+)")


def in_encoding(text: str, encoding: str) -> str:
    r"""Return a text in the characters of an encoding, still readable.

    Examples
    --------
    >>> in_encoding("560 · 10⁻⁶ mm, 3 × 10⁻⁶, 90°, Maß", "ascii")
    '5.6e-4 mm, 3 x 1e-6, 90 deg, Ma\\xdf'
    >>> in_encoding("560 · 10⁻⁶ mm, 90°, Maß", "latin-1")
    '5.6e-4 mm, 90°, Maß'
    """
    if _has(encoding, text):
        return text
    if not _has(encoding, _HIGH):
        text = _POWER.sub(_with_exponent, text)
    return "".join(each if _has(encoding, each) else _plain(each) for each in text)


def _plain(character: str) -> str:
    return _PLAIN.get(character) or character.encode("ascii", "backslashreplace").decode("ascii")


def _with_exponent(power: re.Match[str]) -> str:
    exponent = int(power["exponent"].translate(_DIGITS))
    number, _, shift = f"{float(power['number'] or 1):.15e}".partition("e")
    return f"{number.rstrip('0').rstrip('.')}e{exponent + int(shift)}"


def _has(encoding: str, text: str) -> bool:
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return False
    return True


class Streams:
    """Context in which printing to standard output and error does not fail."""

    def __enter__(self) -> Self:
        self._before = sys.stdout, sys.stderr
        for number, stream in enumerate((sys.stdin, sys.stdout, sys.stderr)):
            if stream is None:
                _occupy(number)
        self._output, self._error = _SafeStream(sys.stdout, 1), _SafeStream(sys.stderr, 2)
        sys.stdout, sys.stderr = cast(TextIO, self._output), cast(TextIO, self._error)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        sys.stdout, sys.stderr = self._before

    @property
    def failure(self) -> OSError | None:
        """Error that kept standard output from being written, after flushing it."""
        self._output.flush()
        failure = self._output.failure
        return None if isinstance(failure, BrokenPipeError) else failure


class _SafeStream(io.TextIOBase):
    def __init__(self, stream: TextIO | None, number: int) -> None:
        self._stream = os.fdopen(number, "w", closefd=False) if stream is None else stream
        self.failure: OSError | None = None

    @contextmanager
    def _catching(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            self.failure = self.failure or error
            with suppress(io.UnsupportedOperation):  # a stream in memory
                _to_null_device(self._stream.fileno())

    def write(self, text: str) -> int:
        with self._catching():
            # A stream in memory has no encoding.
            encoding = getattr(self._stream, "encoding", None)
            self._stream.write(in_encoding(text, encoding) if encoding else text)
        return len(text)

    def flush(self) -> None:
        with self._catching():
            self._stream.flush()

    def isatty(self) -> bool:
        return self._stream.isatty()

    def fileno(self) -> int:
        return self._stream.fileno()

    @property
    def encoding(self) -> str:  # type: ignore[override]  # tqdm reads it
        return self._stream.encoding


def _occupy(number: int) -> None:
    try:
        os.fstat(number)
    except OSError:
        _to_null_device(number)


def _to_null_device(number: int) -> None:
    null = os.open(os.devnull, os.O_RDWR)
    if null != number:
        os.dup2(null, number)
        os.close(null)
