"""How much light of an LED lands on a rectangle, and how evenly, by which faces are shaped."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, Table, TableColumn
from workbench.analysis.validation import validate
from workbench.arrays import Array, Mask
from workbench.geometry.faces import NO_LOCKS

_RAYS = 4_000_000
_SEEDS = 1, 2


class _Variant(NamedTuple):
    """Which faces of the lens of the example *LED to a rectangle* are shaped, and how."""

    faces: str
    changes: Mapping[str, Any]
    plane_exit: bool = False


_FREEFORM = {"shape": "bspline"}
_VARIANTS = (
    _Variant("flat, freeform", {}),
    _Variant(
        "freeform, plane; PMMA",
        {
            "lens.front": _FREEFORM | {"control_points": [32, 16], "height_range": [-5.0, 14.0]},
            "lens.thickness": 16.0,
            "lens.material": "PMMA",
        },
        plane_exit=True,
    ),
    _Variant("two freeform, automatic range", {"lens.front": _FREEFORM}),
    _Variant("two freeform, -4 to 4 mm", {"lens.front": _FREEFORM | {"height_range": [-4.0, 4.0]}}),
    _Variant("flat, freeform; coated (1 %)", {"lens.coating": [0.01, 0.01]}),
)


@dataclass(frozen=True)
class LedDesign:
    """A lens close to an LED."""

    scene: str  # its entrance and its exit face
    seconds: float  # what its run took
    # Part of the LED's light that lands on the rectangle, as independent random rays verify it.
    efficiency: float
    # Relative standard deviation of the irradiance on the rectangle, without the scatter of these
    # rays.
    deviation: float

    @property
    def merit(self) -> float:
        """Efficiency × (1 − relative standard deviation)."""
        return self.efficiency * (1 - self.deviation)


def lenses(iterations: int | None, notify: Notify) -> Iterator[LedDesign]:
    """Design the lens of the example *LED to a rectangle* with one and two freeform faces."""
    for variant in _VARIANTS:
        changes = dict(variant.changes)
        if iterations is not None:
            changes["run.iterations"] = iterations
        example = BenchmarkTask.of("led-rectangle", changes=changes)
        yield designed(variant.faces, example, variant.plane_exit, notify)


def designed(name: str, example: BenchmarkTask, plane_exit: bool, notify: Notify) -> LedDesign:
    """Design a lens, and check how much light lands where the target is bright.

    `name`: what the design is called; `example`: the design task; its target is bright or dark;
    `plane_exit`: whether the exit face stays as its base is; `notify`: gets what is done.
    """
    scene, target = example.scene, example.target
    locked = {"lens.back": np.ones(scene.optic.net_shape, bool)} if plane_exit else NO_LOCKS
    best = example.designed(partial(notify, name), locked)
    notify(name, "its check")
    checks = [validate(scene, target, best.state.heights, _RAYS, seed) for seed in _SEEDS]
    bright = target > target.max() / 2
    on_screen = np.mean([each.account.on_screen for each in checks])
    images = [each.irradiance / each.irradiance.sum() for each in checks]
    efficiency = float(on_screen * np.mean([image[bright].sum() for image in images]))
    return LedDesign(name, best.seconds, efficiency, _deviation(images, bright))


def _deviation(images: Sequence[Array], where: Mask) -> float:
    """Relative standard deviation of two images of the same light; their scatter is independent."""
    one, other = (image[where] / image[where].mean() - 1 for image in images)
    return math.sqrt(max(float((one * other).mean()), 0.0))


def table(found: Sequence[LedDesign]) -> Table:
    """Lenses as rows."""
    columns = (
        TableColumn("scene", "faces"),
        TableColumn("seconds", "run, s", ".0f"),
        TableColumn("efficiency", "efficiency", ".1%"),
        TableColumn("deviation", "RSD", ".3f"),
        TableColumn("merit", "efficiency × (1 − RSD)", ".2f"),
    )
    note = "RSD is the relative standard deviation of the irradiance on the rectangle."
    return Table("An LED close to its lens", columns, found, note)
