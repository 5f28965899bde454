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
            scene = Scene.from_data({**_TINY, "source": source})
            heights = {"lens.back": np.full((4, 4), 0.1)}
            validate(scene, np.ones((1, 1)), heights, rays=1)
            for _ in imaging(scene, heights, accuracy=math.inf):
                pass


def _obtain(*names: str) -> None:
    for name in names:
        if not ready.obtain(name, torch.float32):
            raise ready.failure(name, torch.float32) or RuntimeError(name)


def _compile_rest() -> None:
    """Compile all kernels that a design and its check call beside the train."""
    transport.compile_all(dtypes=())
    _obtain("beams", "boxes")
    _compile_check()


# What set-up compiles, each part in a process of its own. Measured: 85, 40 and 110 s of processor
# time. Few designs need float64, but many tests.
_PARTS: dict[str, Callable[[], object]] = {
    "train": lambda: _obtain("train"),
    "rest": _compile_rest,
    "float64": lambda: ready.compile_all(dtype=torch.float64),
}


def _compile_side_by_side(parts: Sequence[str]) -> None:
    """Compile parts in two processes at a time, and collect their code in the program's folder.

    Processes with one folder would compile in turns; see `workbench.compiled`.
    """
    with TemporaryDirectory() as parent, ThreadPoolExecutor(2) as pool:
        folders = [Path(parent) / part for part in parts]
        commands = [[sys.executable, "-m", __spec__.name, part] for part in parts]

        def compile_in(folder: Path, command: list[str]) -> None:
            subprocess.run(command, env=os.environ | {"NUMBA_CACHE_DIR": str(folder)}, check=True)

        list(pool.map(compile_in, folders, commands))
        for folder in folders:
            collect(folder)


if __name__ == "__main__":
    match sys.argv[1:]:
        case []:
            _compile_side_by_side(["train", "rest"])
        case ["test"]:
            _compile_side_by_side(list(_PARTS))
        case [part]:
            _PARTS[part]()
