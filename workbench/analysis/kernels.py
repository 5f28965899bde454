"""Compilation of all kernels of a design and its check in advance."""

import math
import os
import subprocess
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import torch

from workbench.analysis.cells.image import imaging
from workbench.analysis.validation import validate
from workbench.compiled import collect
from workbench.design import transport
from workbench.optics import ready
from workbench.optics.train.compiled import SMALL
from workbench.scene import Scene

# Together they use every loop of the independent traces.
_SOURCES = (
    {"kind": "collimated", "rays": [1, 1]},
    {"kind": "point", "position": [0, 0, -5], "rays": 1},
    {"kind": "collimated", "angular_diameter": 60},
)


def compile_all(
    goes_on: Callable[[], bool] = lambda: True, dtypes: Sequence[torch.dtype] = (torch.float32,)
) -> None:
    """Compile all kernels, or load them from disk, while ``goes_on`` returns true.

    `dtypes`: float types of the traces of designs.
    """
    try:
        transport.compile_all(goes_on, dtypes)
    finally:
        _compile_check(goes_on)


def _compile_check(goes_on: Callable[[], bool] = lambda: True) -> None:
    for source in _SOURCES:
        if goes_on():
            scene = Scene.from_data({**SMALL, "source": source})
            heights = {"lens.back": np.full((4, 4), 0.1)}
            validate(scene, np.ones((2, 2)), heights, rays=1)
            for _ in imaging(scene, heights, accuracy=math.inf):
                pass


def _obtain(names: Sequence[str], dtypes: Sequence[torch.dtype]) -> None:
    for name in names:
        for dtype in dtypes:
            if not ready.obtain(name, dtype):
                raise ready.failure(name, dtype) or RuntimeError(name)


def _compile_rest(dtypes: Sequence[torch.dtype]) -> None:
    """Compile all kernels that a design and its check call beside the train."""
    transport.compile_all(dtypes=())
    _obtain(("beams", "boxes"), dtypes)
    _compile_check()


# What set-up compiles, each part in a process of its own: 85 and 40 s of processor time for one
# float type. No kernel that Python calls is in both.
_PARTS: dict[str, Callable[[Sequence[torch.dtype]], None]] = {
    "train": lambda dtypes: _obtain(("train",), dtypes),
    "rest": _compile_rest,
}
# Few designs need float64, but many tests.
_DTYPES = {"": (torch.float32,), "test": (torch.float32, torch.float64)}


def _compile_side_by_side(extra: str) -> None:
    """Compile all parts at the same time, and collect their code in the program's folder.

    Processes with one folder would compile in turns; see `workbench.compiled`.
    """
    with TemporaryDirectory() as parent, ThreadPoolExecutor() as pool:

        def compile_in_own_folder(part: str) -> None:
            command = [sys.executable, "-m", __spec__.name, extra, part]
            folder = {"NUMBA_CACHE_DIR": f"{parent}/{part}"}
            subprocess.run(command, env=os.environ | folder, check=True)

        list(pool.map(compile_in_own_folder, _PARTS))
        for part in _PARTS:
            collect(Path(parent) / part)


if __name__ == "__main__":
    match sys.argv[1:]:
        case [extra, part]:
            _PARTS[part](_DTYPES[extra])
        case arguments:
            _compile_side_by_side(*arguments or [""])
