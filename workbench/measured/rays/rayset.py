"""Rays of a file: read in chunks, checked, thinned if there are too many, placed in a scene."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import BinaryIO, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench import units
from workbench.arrays import Array, Index, Mask
from workbench.messages import Message

Floats = npt.NDArray[np.float32]
MOST_RAYS = 4_000_000
"""Most rays of a file that are kept; of more, this many are drawn by flux."""
CHUNK = 1 << 18
"""Rays read at once."""
# Tolerance of the length of unit vectors, for rounding in files.
_LENGTH = 0.01
_METRES = units.METRES | {"feet": 12 * units.METRES["inch"]}


class Columns(NamedTuple):
    """Column numbers in a table of rays; a spectrum is the number of a spectrum, from 1.

    Without a column of flux all rays have the same flux.
    """

    flux: int | None = 6
    wavelength: int | None = None
    spectrum: int | None = None


@dataclass(frozen=True, eq=False)
class RaySet:
    """Rays of a file."""

    position: Floats  # (m, 3), starts, in the unit of the file
    direction: Floats  # (m, 3), unit vectors
    flux: Floats  # (m,), not negative, with a sum above 0
    in_file: int  # number of rays in the file; a kept ray has the flux of all rays that it replaces
    # Unit of length: "mm", "cm", "m", "inch" or "feet"; None if the file names none.
    unit: str | None
    wavelength_nm: Floats | None = None  # (m,), wavelength
    spectrum: npt.NDArray[np.int32] | None = None  # (m,), index into ``spectra``, from 0
    # (k, 2), wavelengths in nm and weights; one for all rays if they have no index.
    spectra: tuple[Floats, ...] = field(default=())

    @property
    def total(self) -> float:
        """Flux of all rays, in the unit of the file."""
        return float(self.flux.sum(dtype=np.float64))


def gathered(
    chunks: Iterator[Floats],
    columns: Columns,
    rays: int,
    unit: str | None,
    spectra: tuple[Floats, ...] = (),
    to_nm: float = 1.0,
    most: int = MOST_RAYS,
) -> RaySet:
    """Collect rays from chunks (m, columns); raise ValueError if a ray is invalid.

    The first columns are x, y, z and the direction. If ``rays``, the estimated count, exceeds
    ``most``, each run of neighbouring rays is replaced by one of them, drawn with a probability
    proportional to its flux, which gets the flux of all: sums stay, and means over rays are
    unbiased. The seed is fixed. ``to_nm`` converts wavelengths of the file to nanometres.
    """
    run = max(-(-rays // most), 1)
    generator = np.random.default_rng(25)
    parts, first = [], 0
    for chunk in chunks:
        table = np.ascontiguousarray(chunk, dtype=np.float32)
        flux = _checked(table, columns, first)
        first += len(table)
        drawn, flux = _drawn(flux, run, generator)
        kept = table[drawn].copy()
        parts.append((kept, flux))
    if not first:
        raise ValueError(Message("it has no rays"))
    table = np.concatenate([kept for kept, _ in parts])
    flux = np.concatenate([flux for _, flux in parts])
    if not flux.any():
        raise ValueError(Message("none of its rays has any flux"))
    direction = table[:, 3:6] / np.linalg.norm(table[:, 3:6], axis=1, keepdims=True)
    wavelength = None if columns.wavelength is None else to_nm * table[:, columns.wavelength]
    spectrum = None
    if columns.spectrum is not None:
        spectrum = table[:, columns.spectrum].astype(np.int32) - 1
        if not ((spectrum >= 0) & (spectrum < len(spectra))).all():
            raise ValueError(
                Message("a ray has a spectrum that is none of the {n} there are", n=len(spectra))
            )
    position = table[:, :3].copy()
    return RaySet(position, direction, flux, first, unit, wavelength, spectrum, spectra)


def _checked(table: Floats, columns: Columns, first: int) -> Floats:
    if ray := _wrong_ray(~np.isfinite(table).all(axis=1), first):
        raise ValueError(Message("its ray {ray} has a value that is no finite number", ray=ray))
    with np.errstate(over="ignore"):
        square = np.square(table[:, 3:6]).sum(axis=1)
    if ray := _wrong_ray(np.abs(square - 1) > 2 * _LENGTH, first):
        raise ValueError(Message("its ray {ray} has a direction that is no unit vector", ray=ray))
    if columns.flux is None:
        return np.ones(len(table), np.float32)
    flux: Floats = table[:, columns.flux]
    if ray := _wrong_ray(flux < 0, first):
        raise ValueError(Message("its ray {ray} has a negative flux", ray=ray))
    return flux


def _wrong_ray(wrong: Mask | np.bool_, first: int) -> int:
    return first + int(wrong.argmax()) + 1 if wrong.any() else 0


def _drawn(flux: Floats, run: int, generator: np.random.Generator) -> tuple[Index, Floats]:
    if run == 1:
        return np.arange(len(flux)), flux.copy()
    starts = np.arange(0, len(flux), run)
    total = np.add.reduceat(flux, starts, dtype=np.float64)
    summed = np.cumsum(flux, dtype=np.float64)
    before = summed[starts] - flux[starts]
    place = before + generator.random(len(starts)) * total
    ends = np.append(starts[1:], len(flux)) - 1
    drawn = np.clip(np.searchsorted(summed, place, side="right"), starts, ends)
    return drawn, total.astype(np.float32)


def size_of(file: BinaryIO) -> int:
    """Return the size of an open file in bytes, and rewind it."""
    size = file.seek(0, 2)
    file.seek(0)
    return size


def records(file: BinaryIO, rays: int, width: int) -> Iterator[Floats]:
    """Read binary rays in chunks (m, width), as a file may exceed the memory.

    Raise ValueError if the file ends too early.
    """
    for first in range(0, rays, CHUNK):
        count = min(CHUNK, rays - first)
        content = file.read(4 * width * count)
        if len(content) < 4 * width * count:
            last = first + len(content) // (4 * width)
            raise ValueError(Message("it is cut off behind ray {ray}", ray=last))
        yield np.frombuffer(content, "<f4").reshape(count, width)


class PlacedRays(NamedTuple):
    """Rays in a scene: start and unit direction (m, 3), flux (m,) with a sum of 1."""

    position: Array
    direction: Array
    flux: Array

    def onto(self, z: float) -> tuple[Array, Array, Mask]:
        """Return x and y (m,) of the intersections with a plane z, and whether they exist.

        Rays that go away from the plane or start behind it have none; their x and y are 0.
        """
        ahead = self.direction[:, 2]
        distance = z - self.position[:, 2]
        arriving = (ahead > 0) & (distance >= 0)
        far = np.where(arriving, distance, 0.0) / np.where(arriving, ahead, 1.0)
        x, y = (self.position[:, axis] + far * self.direction[:, axis] for axis in (0, 1))
        return np.where(arriving, x, 0.0), np.where(arriving, y, 0.0), arriving


def placed(
    rays: RaySet, file_unit: str, unit: str, matrix: Array, position: tuple[float, float, float]
) -> PlacedRays:
    """Return the rays of a file in scene coordinates.

    ``matrix`` (3, 3) turns directions of the file into those of the scene; ``position`` is the
    file's origin in the scene.
    """
    scale: Fraction = _METRES[file_unit] / _METRES[unit]
    start = float(scale) * rays.position.astype(np.float64) @ matrix.T + np.array(position)
    direction = rays.direction.astype(np.float64) @ matrix.T
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    flux = rays.flux.astype(np.float64)
    return PlacedRays(start, direction, flux / flux.sum())
