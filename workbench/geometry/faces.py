"""What is known of each freeform face of a lens, by the name of the face."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
import numpy.typing as npt

Kind = TypeVar("Kind", np.float64, np.bool_)


class FaceArrays(Mapping[str, npt.NDArray[Kind]]):
    """An array over the control points of each freeform face, which nobody can change.

    Parameters
    ----------
    arrays : mapping of str to ndarray, shape (n_u, n_v)
        Arrays by the names of their faces; "entrance" and "exit" are those of a lens. Those
        that can be written to are copied.

    Examples
    --------
    >>> plate = FaceArrays({"exit": np.full((4, 4), 0.5)})
    >>> plate["exit"].shape
    (4, 4)
    >>> plate == FaceArrays({"exit": np.full((4, 4), 0.5)})
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
        return FaceArrays, (self._arrays,)  # arrays come out of a pickle as ones to write to

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
"""Control points of each face that keep their heights; a face without any may be left out."""


@dataclass(frozen=True)
class ControlPoint:
    """One of the control points of an optic.

    Attributes
    ----------
    face : str
        The name of its face.
    index : tuple[int, int]
        Its place in the net of that face, along x and along y, counted from 0.
    """

    face: str
    index: tuple[int, int]


NO_LOCKS: Locks = FaceArrays({})
"""All control points may move."""

NO_FACES: ControlHeights = FaceArrays({})
"""The heights of no face."""
