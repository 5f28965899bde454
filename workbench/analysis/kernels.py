"""Compilation of all kernels of a design and its check in advance."""

import math
import multiprocessing
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import torch

from workbench.analysis.cells.image import imaging
from workbench.analysis.validation import validate
from workbench.design import transport
from workbench.scene import Scene

_TINY = {
    "version": 3,
    "elements": [
        {
            "kind": "lens",
            "name": "lens",
            "half_width": [1, 1],
            "material": {"index": 1.5},
            "thickness": 0.5,
            "reflection": "schlick",
            "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": [4, 4]}],
        }
    ],
    "images": [
        {
            "receiver": {
                "kind": "plane",
                "position": [0, 0, 5],
                "half_width": [1, 1],
                "pixels": [1, 1],
            },
            "target": {"builtin": "tophat"},
        }
    ],
}
# Together they use every loop of the independent traces.
_SOURCES = (
    {"kind": "collimated", "rays": [1, 1]},
    {"kind": "point", "position": [0, 0, -5], "rays": 1},
    {"kind": "collimated", "angular_diameter": 60},
)
_FINE = (torch.float64,)


def compile_all(
    goes_on: Callable[[], bool] = lambda: True, dtypes: Sequence[torch.dtype] = (torch.float32,)
) -> None:
    """Compile all kernels, or load them from disk, while ``goes_on`` returns true.

    `dtypes`: float types of the traces of designs.
    """
    try:
        transport.compile_all(goes_on, dtypes)
    finally:
        for source in _SOURCES:
            if goes_on():
                scene = Scene.from_data({**_TINY, "source": source})
                heights = {"lens.back": np.full((4, 4), 0.1)}
                validate(scene, np.ones((1, 1)), heights, rays=1)
                for _ in imaging(scene, heights, accuracy=math.inf):
                    pass


def _compile_side_by_side() -> None:
    """Compile the kernels of both float types in two processes."""
    with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
        parts = [pool.submit(compile_all), pool.submit(transport.compile_all, dtypes=_FINE)]
        for part in parts:
            part.result()


if __name__ == "__main__":
    _compile_side_by_side()
