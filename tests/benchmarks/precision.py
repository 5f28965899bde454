"""What float32 costs in accuracy."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import torch

from tests.benchmarks.kernels import Descent
from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, wavy
from workbench.analysis.benchmark.table import Table, TableColumn
from workbench.arrays import Array

_EXAMPLES = (
    "tophat",
    "ball",
    "flame-512",
    "flame-x1",
    "flame-x3",
    "flame-x5",
    "flame-point",
    "flame-grid",
)


@dataclass(frozen=True)
class PrecisionDifference:
    """Float32 against float64 for one lens.

    Attributes
    ----------
    scene : str
        Name of the example.
    image, gradient : float
        Relative L2 distance.
    loss : float
        Relative difference.
    """

    scene: str
    image: float
    loss: float
    gradient: float


def differences(iterations: int | None, notify: Notify) -> Iterator[PrecisionDifference]:
    """Compare both float types on the examples, with a lens that bends light everywhere."""
    for name in _EXAMPLES:
        notify(name, "")
        example = BenchmarkTask.of(name)
        yield difference(example, wavy(example.scene))


def difference(example: BenchmarkTask, heights: Array) -> PrecisionDifference:
    """Compare both float types on one lens, heights (n_u, n_v)."""
    coarse, fine = (Descent(example, heights, dtype)() for dtype in (torch.float32, torch.float64))
    return PrecisionDifference(
        scene=example.name,
        image=_distance(coarse[0], fine[0]),
        loss=abs(coarse[1] / fine[1] - 1),
        gradient=_distance(coarse[2], fine[2]),
    )


def table(found: Sequence[PrecisionDifference]) -> Table:
    """The differences as rows."""
    columns = (
        TableColumn("scene", "scene"),
        TableColumn("image", "image", ".1e"),
        TableColumn("loss", "loss", ".1e"),
        TableColumn("gradient", "gradient", ".1e"),
    )
    return Table("Relative difference of float32 from float64", columns, found)


def _distance(a: Array, b: Array) -> float:
    return float(np.linalg.norm(a - b) / np.linalg.norm(b))
