"""Points of a measured surface, and the surface of a rectangular grid of heights."""

from dataclasses import dataclass

import numpy as np

from workbench.arrays import AnyArray, Array
from workbench.messages import Message

MOST_POINTS = 16_000_000
"""Most points of a file."""
LEAST_POINTS = 100
"""Fewest points of a surface."""


@dataclass(frozen=True, eq=False)
class MeasuredSurface:
    """Points of a surface, in the unit of the file; right-handed, z upwards."""

    # (n, 3), all finite: of each smooth part. Only a mesh has several: its faces and walls.
    patches: tuple[Array, ...]
    unit: str | None = None  # one of `workbench.units.WRITTEN`; None if the file names none
    missing: int = 0  # places of the file without a height

    @property
    def count(self) -> int:
        """Number of points."""
        return sum(len(patch) for patch in self.patches)


def surface_of(points: Array, unit: str | None = None) -> MeasuredSurface:
    """Return the surface of points (n, 3), without those that are not finite.

    Raise ValueError if too few are left.
    """
    there = np.isfinite(points).all(axis=1)
    kept = np.ascontiguousarray(points[there], dtype=np.float64)
    if len(kept) < LEAST_POINTS:
        raise ValueError(
            Message(
                "it has {count} points with a height; at least {least} are needed",
                count=len(kept),
                least=LEAST_POINTS,
            )
        )
    return MeasuredSurface((kept,), unit, len(points) - len(kept))


def surface_of_grid(
    x: AnyArray, y: AnyArray, heights: Array, unit: str | None = None
) -> MeasuredSurface:
    """Return the surface of heights (n_y, n_x) at x (n_x,) and y (n_y,); NaN where there is none.

    Raise ValueError if too few are left.
    """
    columns = np.broadcast_arrays(x, y[:, None], heights)
    return surface_of(np.stack([column.ravel() for column in columns], axis=1), unit)


def checked_size(columns: int, rows: int) -> tuple[int, int]:
    """Return the numbers of columns and rows of a grid; raise ValueError if it is too large."""
    if min(columns, rows) < 1 or columns * rows > MOST_POINTS:
        raise ValueError(
            Message(
                "it has {columns} × {rows} points; 1 to {most} million are possible",
                columns=columns,
                rows=rows,
                most=MOST_POINTS // 10**6,
            )
        )
    return columns, rows
