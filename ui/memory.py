"""Memory of values that share their arrays."""

from collections.abc import Iterator
from dataclasses import fields, is_dataclass

import numpy as np
import numpy.typing as npt


def arrays(value: object) -> Iterator[npt.NDArray[np.generic]]:
    """All arrays in a value made of data classes and tuples, some perhaps more than once."""
    if isinstance(value, np.ndarray):
        yield value
    elif isinstance(value, tuple):
        for each in value:
            yield from arrays(each)
    elif is_dataclass(value):
        for field in fields(value):
            yield from arrays(getattr(value, field.name))


def distinct_bytes(*values: object) -> int:
    """Bytes of all arrays in some values, each counted once."""
    return sum({id(array): array.nbytes for array in arrays(values)}.values())
