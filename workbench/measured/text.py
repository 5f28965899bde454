"""Text of measured sources: UTF-8, UTF-16 or Latin-1, any line ends, decimal points or commas."""

import codecs
import re
from collections.abc import Callable, Sequence
from pathlib import PurePath
from typing import BinaryIO, TypeVar

import numpy as np

from workbench.errors import Refused, visible
from workbench.messages import Message

Read = TypeVar("Read")

_GAPS = re.compile(r"[\s,;]+")
_SPACES = re.compile(r"[\s;]+")
_END = "\x1a"  # old programs end texts with it
_FORTRAN = re.compile("(?<=[0-9.])[dD](?=[-+0-9])")  # of an exponent
_NUMBER = re.compile(r"[-+]?[\d.,]*\d[\d.,]*([eEdD][-+]?\d+)?")
_THOUSANDS = {mark: re.compile(rf"[-+]?[1-9]\d{{0,2}}({re.escape(mark)}\d{{3}})+") for mark in ",."}
_FEW = 0.05  # part of numbers with a thousands separator, if none has a decimal mark
_MARKS = {
    codecs.BOM_UTF32_LE: "utf-32",
    codecs.BOM_UTF32_BE: "utf-32",
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}
# Bytes examined for the encoding; parts of zeros among high and low bytes of UTF-16.
_BEGINNING, _MANY_ZEROS, _FEW_ZEROS = 1 << 12, 0.7, 0.2
_QUOTED = 20  # characters of a wrong word in messages


def decoded(content: bytes) -> str:
    """Decode text in UTF-8 or UTF-16, with or without byte order mark, else in Latin-1."""
    encoding = encoding_of(content)
    if encoding is not None:
        return content.decode(encoding, errors="replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def encoding_of(content: bytes) -> str | None:
    """Return UTF-16 or UTF-32 as seen by the mark or the zeros of a text; None for others."""
    for mark, encoding in _MARKS.items():
        if content.startswith(mark):
            return encoding
    beginning = np.frombuffer(content[:_BEGINNING], np.uint8)
    even, odd = (
        float((beginning[first::2] == 0).mean()) if len(beginning) > 3 else 0.0 for first in (0, 1)
    )
    if even > _MANY_ZEROS and odd < _FEW_ZEROS:
        return "utf-16-be"
    return "utf-16-le" if odd > _MANY_ZEROS and even < _FEW_ZEROS else None


def lines_of(content: bytes) -> list[str]:
    """Return the stripped lines of a text; see `decoded`."""
    text = decoded(content).replace("\r\n", "\n").replace("\r", "\n")
    text = text.partition(_END)[0].rstrip("\0\n\t ").replace("\u2212", "-")
    return [line.strip().strip("\0") for line in text.split("\n")]


def readings(text: str) -> tuple[list[str], ...]:
    """Split text into words, for each possible meaning of its commas."""
    apart = [word for word in _GAPS.split(text) if word]
    if "," not in text:
        return (apart,)
    words = [word for word in _SPACES.split(text) if word]
    return apart, with_points(words), [word.replace(",", ".") for word in words]


def with_points(words: Sequence[str]) -> list[str]:
    """Rewrite numbers with decimal commas or thousands separators to decimal points.

    A mark separates thousands if the other mark follows it in a number, or if it is always followed
    by groups of three digits and is rare.
    """
    numbers = [word for word in words if _NUMBER.fullmatch(word)]
    thousands = ""
    for mark, other in (",.", ".,"):
        marked = [word for word in numbers if mark in word]
        if any(mark in word and word.rfind(mark) < word.find(other) for word in numbers):
            thousands = mark
            break
        if not marked or not all(_THOUSANDS[mark].fullmatch(word) for word in marked):
            continue
        others = sum(other in word for word in numbers)
        if len(marked) < (others or _FEW * len(numbers)):
            thousands = mark
            break
    return [
        word.replace(thousands, "").replace(",", ".") if _NUMBER.fullmatch(word) else word
        for word in words
    ]


def number(word: str) -> float:
    """Return a finite number; raise ValueError for other words."""
    try:
        value = float(_FORTRAN.sub("e", word) if "_" not in word else "")
    except ValueError:
        raise ValueError(
            Message("{word!r} stands where a number is needed", word=word[:_QUOTED])
        ) from None
    if not np.isfinite(value):
        raise ValueError(
            Message("{word!r} stands where a finite number is needed", word=word[:_QUOTED])
        )
    return value


def count(word: str, least: int, most: int) -> int:
    """Return an integer within limits; raise ValueError for other words."""
    value = number(word)
    if value != int(value) or not least <= value <= most:
        raise ValueError(
            Message(
                "{word!r} stands where a whole number from {least} to {most} has to",
                word=word[:_QUOTED],
                least=least,
                most=most,
            )
        )
    return int(value)


def trailing(words: list[str], needed: int) -> tuple[list[str], tuple[Message, ...]]:
    """Cut words to the needed number if text follows, with a remark on that text.

    Further numbers stay: the file has then another length than its header says.
    """
    if len(words) <= needed:
        return words, ()
    try:
        number(words[needed])
    except ValueError:
        text = " ".join(words[needed:])[:_QUOTED]
        return words[:needed], (
            Message("text behind the last number is ignored: {text!r}", text=text),
        )
    return words, ()


def wrong_length(found: int, needed: int) -> Message:
    """Text for a file with another number of values than needed."""
    return Message("it is cut off") if found < needed else Message("it goes on behind its end")


def problem_in(error: ValueError) -> str:
    """Message of a reader's ValueError, for a refusal."""
    problem = error.args[0] if error.args else ""
    return problem if isinstance(problem, Message) else visible(str(error))


def read_whole(name: PurePath, file: BinaryIO, reader: Callable[[bytes], Read], most: int) -> Read:
    """Read a file of at most ``most`` bytes; raise Refused, with its name, if it is unusable."""
    content = file.read(most + 1)
    if len(content) > most:
        raise Refused(
            str(name), Message("has more than {most} MB, too many for such a file", most=most >> 20)
        )
    try:
        return reader(content)
    except ValueError as error:
        raise Refused(
            str(name), Message("cannot be used: {problem}", problem=problem_in(error))
        ) from error
