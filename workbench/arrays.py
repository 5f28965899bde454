"""Types of arrays, by the numbers in them. Shapes stand where an array is described."""

from typing import Any

import numpy as np
import numpy.typing as npt

AnyArray = npt.NDArray[np.floating[Any]]
Array = npt.NDArray[np.float64]
Index = npt.NDArray[np.intp]
Mask = npt.NDArray[np.bool_]
