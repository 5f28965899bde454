"""Ray files as other programs write them, by the public descriptions of the formats."""

import struct
from collections.abc import Sequence

import numpy as np


def rays(count: int, seed: int = 1) -> np.ndarray:
    """Rays of a small LED, shape (count, 7)."""
    generator = np.random.default_rng(seed)
    sine2, around = generator.random((2, count)) * [[0.9], [2 * np.pi]]
    table = np.zeros((count, 7), np.float32)
    table[:, :2] = generator.uniform(-0.5, 0.5, (count, 2))
    table[:, 3], table[:, 4] = np.sqrt(sine2) * [np.cos(around), np.sin(around)]
    table[:, 5] = np.sqrt(1 - sine2)
    table[:, 6] = generator.random(count)
    return table


def tm25(
    table: np.ndarray,
    flags: Sequence[int] = (1, 1, 1, 0, 0, 0, 0, 0),
    spectra: Sequence[np.ndarray] = (),
    names: Sequence[str] = (),
    text: str = "",
    version: int = 2013,
    count: int | None = None,
) -> bytes:
    """A file of IES TM-25-13."""
    spectral = 4 if flags[7] else 3 if spectra else 2 if flags[3] else 0
    stated = len(table) if count is None else count
    block = struct.pack("<4sii2fQ", b"TM25", version, 0, np.nan, 1.5, stated)
    block += struct.pack("<28sii3f", b"2026-01-02T03:04:05+00:00", 0, spectral, np.nan, 400, 700)
    block += struct.pack("<3i", len(spectra), len(names), 4 * len(text)) + bytes(168)
    assert len(block) == 256
    block += struct.pack("<8i", *flags)
    for description in ("an LED", "nobody", *[""] * 7):
        block += description.encode("utf-32-le").ljust(4000, b"\0")
    tables = b""
    for spectrum in spectra:
        tables += struct.pack("<i", len(spectrum)) + spectrum.astype("<f4").tobytes()
    block += tables + bytes(-len(tables) % 32)
    for name in names:
        block += name.encode("utf-32-le").ljust(512, b"\0")
    return block + text.encode("utf-32-le") + table.astype("<f4").tobytes()


def dat(
    table: np.ndarray, unit: int = 4, identifier: int = 1010, count: int | None = None
) -> bytes:
    """A binary file of OpticStudio; of 8 columns the last are wavelengths in µm."""
    stated = len(table) if count is None else count
    head = struct.pack("<iI100s3f4fI", identifier, stated, b"an LED", 1, 1, 0, 0, 0, 0, 0, unit)
    head += struct.pack("<9f4fiiii", *[0.0] * 13, 2 * (table.shape[1] == 8), 0, 0, 0)
    assert len(head) == 208
    return head + table.astype("<f4").tobytes()


def text(table: np.ndarray, separator: str = ",", end: str = "\n", head: str = "") -> bytes:
    """Lines of numbers."""
    lines = [separator.join(f"{value:.9g}" for value in row) for row in table]
    return (head + end.join(lines) + end).encode()
