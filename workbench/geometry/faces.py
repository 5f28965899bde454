"""Arrays over the control points of each freeform face, by the name of the face."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

Kind = TypeVar("Kind", np.float64, np.bool_)


class FaceArrays(Mapping[str, npt.NDArray[Kind]]):
    """Read-only mapping of face names to arrays (n_u, n_v); writeable arrays are copied.

    Examples
    --------
    >>> plate = FaceArrays({"lens.back": np.full((4, 4), 0.5)})
    >>> plate["lens.back"].shape
    (4, 4)
    >>> plate == FaceArrays({"lens.back": np.full((4, 4), 0.5)})
    True
    """

    def __init__(self, arrays: Mapping[str, npt.NDArray[Kind]]) -> None:
        self._arrays: dict[str, npt.NDArray[Kind]] = {
            face: _sealed(array) for face, array in arrays.items()
        }

    def __getitem__(self, face: str) -> npt.NDArray[Kind]:
        return self._arrays[face]

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, FaceArrays):
            return NotImplemented
        return self.keys() == other.keys() and all(
            np.array_equal(array, other[face]) for face, array in self.items()
        )

    def __hash__(self) -> int:
        return hash(frozenset(self))

    def __reduce__(self) -> tuple[Any, ...]:
        return FaceArrays, (self._arrays,)  # unpickled arrays are writeable

    def __repr__(self) -> str:
        shapes = ", ".join(f"{face}: {array.shape}" for face, array in self.items())
        return f"FaceArrays({shapes})"


def _sealed(array: npt.NDArray[Kind]) -> npt.NDArray[Kind]:
    if array.flags.writeable:
        array = array.copy()
        array.flags.writeable = False
    return array


ControlHeights = FaceArrays[np.float64]
"""Heights z of the control points of each face, scene units."""

Locks = FaceArrays[np.bool_]
"""Locked control points of each face; a face without locks may be missing."""


@dataclass(frozen=True)
class ControlPoint:
    """A control point: its face and its index along x and y, from 0."""

    face: str
    index: tuple[int, int]


NO_LOCKS: Locks = FaceArrays({})
"""No control point is locked."""

NO_FACES: ControlHeights = FaceArrays({})
"""Empty mapping."""
