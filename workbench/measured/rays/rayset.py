"""Rays as they are read: checked, and thinned while there are more than memory has room for."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.arrays import Index, Mask
from workbench.said import Said

Floats = npt.NDArray[np.float32]

MOST_RAYS = 4_000_000
"""Rays of a file that are kept; of more, so many are drawn by their flux."""

CHUNK = 1 << 18
"""Rays that are read at once."""

# What rounding of files leaves of the length of a unit vector.
_LENGTH = 0.01


class Columns(NamedTuple):
    """Where the columns of a table of rays are.

    Attributes
    ----------
    flux : int, optional
        That of flux; None where all rays have the same.
    wavelength : int, optional
        That of wavelengths.
    spectrum : int, optional
        That of numbers of spectra, counted from 1.
    """

    flux: int | None = 6
    wavelength: int | None = None
    spectrum: int | None = None


@dataclass(frozen=True, eq=False)
class RaySet:
    """Rays of a source.

    Attributes
    ----------
    position : ndarray, shape (m, 3), float32
        Where they start, in the unit of the file.
    direction : ndarray, shape (m, 3), float32
        Unit vectors.
    flux : ndarray, shape (m,), float32
        Not negative, with a sum above 0.
    in_file : int
        How many rays the file has; each that is kept has the flux of those that it stands for.
    unit : str, optional
        Unit of length that the file names: "mm", "cm", "m", "inch" or "feet"; None if it does not.
    wavelength_nm : ndarray, shape (m,), float32, optional
        Of each ray.
    spectrum : ndarray, shape (m,), int32, optional
        Number in ``spectra`` of each ray, from 0.
    spectra : sequence of ndarray, shape (k, 2)
        Wavelengths in nm and weights; one for all rays where they have no numbers.
    """

    position: Floats
    direction: Floats
    flux: Floats
    in_file: int
    unit: str | None
    wavelength_nm: Floats | None = None
    spectrum: npt.NDArray[np.int32] | None = None
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
    """Collect rays.

    Of more than ``most``, runs of neighbours in the file are each replaced by one of them, drawn
    with a chance that goes with its flux, which gets the flux of all: sums stay as they are, and
    means over rays are right on average. The seed is fixed.

    Parameters
    ----------
    chunks : iterator of ndarray, shape (m, columns)
        Tables whose first columns are x, y, z and the direction.
    columns : Columns
        Where the others are.
    rays : int
        How many there will be, at least about.
    unit, spectra
        As of `RaySet`.
    to_nm : float
        What makes wavelengths of the file nanometres.
    most : int
        How many are kept, at most about.

    Raises
    ------
    ValueError
        With what is wrong.
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
        raise ValueError(Said("it has no rays"))
    table = np.concatenate([kept for kept, _ in parts])
    flux = np.concatenate([flux for _, flux in parts])
    if not flux.any():
        raise ValueError(Said("none of its rays has any flux"))
    direction = table[:, 3:6] / np.linalg.norm(table[:, 3:6], axis=1, keepdims=True)
    wavelength = None if columns.wavelength is None else to_nm * table[:, columns.wavelength]
    spectrum = None
    if columns.spectrum is not None:
        spectrum = table[:, columns.spectrum].astype(np.int32) - 1
        if not ((spectrum >= 0) & (spectrum < len(spectra))).all():
            raise ValueError(
                Said("a ray has a spectrum that is none of the {n} there are", n=len(spectra))
            )
    position = table[:, :3].copy()
    return RaySet(position, direction, flux, first, unit, wavelength, spectrum, spectra)


def _checked(table: Floats, columns: Columns, first: int) -> Floats:
    """Flux of rays that are possible; ``first`` is the number of the first one, from 0."""
    if ray := _wrong_ray(~np.isfinite(table).all(axis=1), first):
        raise ValueError(Said("its ray {ray} has a value that is no finite number", ray=ray))
    with np.errstate(over="ignore"):
        square = np.square(table[:, 3:6]).sum(axis=1)
    if ray := _wrong_ray(np.abs(square - 1) > 2 * _LENGTH, first):
        raise ValueError(Said("its ray {ray} has a direction that is no unit vector", ray=ray))
    if columns.flux is None:
        return np.ones(len(table), np.float32)
    flux: Floats = table[:, columns.flux]
    if ray := _wrong_ray(flux < 0, first):
        raise ValueError(Said("its ray {ray} has a negative flux", ray=ray))
    return flux


def _wrong_ray(wrong: Mask | np.bool_, first: int) -> int:
    """The number of the first ray that is wrong, from 1; 0 where none is."""
    return first + int(wrong.argmax()) + 1 if wrong.any() else 0


def _drawn(flux: Floats, run: int, generator: np.random.Generator) -> tuple[Index, Floats]:
    """Which ray of each run stands for it, and with which flux."""
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
