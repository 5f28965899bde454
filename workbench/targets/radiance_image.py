"""Radiance HDR files (Ward, The RADIANCE picture file format, 1991)."""

import re

import numpy as np
import numpy.typing as npt

from workbench.arrays import Array
from workbench.messages import Message
from workbench.targets.colour import REC_709, luminance_weights
from workbench.targets.picture import Picture, UnusablePicture, check_size, gathered

_RESOLUTION = re.compile(rb"([+-])([XY]) (\d{1,9}) ([+-])([XY]) (\d{1,9})\s*")
_LONGEST_HEADER = 1 << 16  # bytes
_SHORTEST, _LONGEST = 8, 32767  # pixels of a line that is packed channel by channel
_EXPONENT = 128 + 8  # of a mantissa of 8 bits

Bytes = npt.NDArray[np.uint8]


def is_radiance(beginning: bytes) -> bool:
    """Whether a file with this beginning is Radiance HDR."""
    return beginning.startswith((b"#?RADIANCE", b"#?RGBE"))


def read_radiance(content: bytes) -> Picture:
    """Read the luminance of a picture in RGBE or XYZE, compressed or not.

    The exposure in the file is ignored: only ratios matter. Raise UnusablePicture if the file is
    damaged, incomplete or too large.
    """
    head, found, _ = content[:_LONGEST_HEADER].partition(b"\n\n")
    begin = len(head) + 2
    end = content.find(b"\n", begin)
    size = _RESOLUTION.fullmatch(content[begin:end]) if found and end >= 0 else None
    if size is None or size[2] == size[5]:
        raise UnusablePicture(Message("is damaged: it has no line with its resolution"))
    lines, length = int(size[3]), int(size[6])
    check_size(lines, length)
    weights = _weights(dict(line.partition(b"=")[::2] for line in head.split(b"\n")))
    rest = np.frombuffer(content, np.uint8, offset=end + 1)
    if len(rest) < lines:  # each line has bytes: do not allocate memory for a forged header
        raise _incomplete()
    light, place = np.empty((lines, length), dtype=np.float32), 0
    for number in range(lines):
        pixels, place = _line(rest, place, length)
        mantissas = pixels[:, :3] @ weights
        light[number] = np.ldexp(mantissas, pixels[:, 3].astype(int) - _EXPONENT)
        light[number][pixels[:, 3] == 0] = 0.0
    upright = _upright(light, size[1] + size[2], size[4] + size[5])
    rows, columns = upright.shape
    return gathered(rows, columns, lambda top, bottom: upright[top:bottom].astype(np.float64))


def _upright(
    light: npt.NDArray[np.float32], first: bytes, second: bytes
) -> npt.NDArray[np.float32]:
    if first[1:] == b"X":
        light, first, second = light.T, second, first
    if first == b"+Y":
        light = light[::-1]
    return light if second == b"+X" else light[:, ::-1]


def _weights(header: dict[bytes, bytes]) -> Array:
    if header.get(b"FORMAT", b"").strip() == b"32-bit_rle_xyze":
        return np.array([0.0, 1.0, 0.0])
    if b"PRIMARIES" not in header:
        return REC_709
    try:
        values = [float(value) for value in header[b"PRIMARIES"].split()]
        red, green, blue, white = zip(values[::2], values[1::2], strict=True)
        return luminance_weights([red, green, blue], white)
    except (ValueError, ArithmeticError, np.linalg.LinAlgError) as error:
        raise UnusablePicture(Message("has primaries that are no colours of light")) from error


def _line(rest: Bytes, place: int, length: int) -> tuple[Bytes, int]:
    head = rest[place : place + 4]
    if len(head) < 4:
        raise _incomplete()
    in_channels = _SHORTEST <= length <= _LONGEST and head[0] == head[1] == 2 and head[2] < 128
    if not in_channels:
        return _old_line(rest, place, length)
    if 256 * int(head[2]) + int(head[3]) != length:
        raise UnusablePicture(Message("is damaged: a line has another length than the picture"))
    place += 4
    channels = np.empty((4, length), np.uint8)
    for channel in channels:
        done = 0
        while done < length:
            if place + 1 >= len(rest):
                raise _incomplete()
            count = int(rest[place])
            if count > 128:
                count -= 128
                values, place = rest[place + 1 : place + 2], place + 2
            else:
                values, place = rest[place + 1 : place + 1 + count], place + 1 + count
                if len(values) < count:
                    raise _incomplete()
            if not 0 < count <= length - done:
                raise UnusablePicture(Message("is damaged: a line is longer than the picture"))
            channel[done : done + count] = values
            done += count
    return channels.T, place


def _old_line(rest: Bytes, place: int, length: int) -> tuple[Bytes, int]:
    pixels = np.empty((length, 4), np.uint8)
    done, shift = 0, 0
    while done < length:
        stored = rest[place : place + 4 * (length - done)]
        stored = stored[: len(stored) // 4 * 4].reshape(-1, 4)
        marks = np.flatnonzero((stored[:, :3] == 1).all(axis=1))
        plain = int(marks[0]) if len(marks) else len(stored)
        pixels[done : done + plain] = stored[:plain]
        done, place = done + plain, place + 4 * plain
        shift = 0 if plain else shift
        if len(marks):
            count = int(stored[plain, 3]) << shift
            if not 0 < done <= done + count <= length:
                raise UnusablePicture(Message("is damaged: a line is longer than the picture"))
            pixels[done : done + count] = pixels[done - 1]
            done, place, shift = done + count, place + 4, shift + 8
        elif done < length:
            raise _incomplete()
    return pixels, place


def _incomplete() -> UnusablePicture:
    return UnusablePicture(Message("is incomplete: lines are missing at its end"))
