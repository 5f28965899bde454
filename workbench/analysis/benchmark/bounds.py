"""Errors of lenses for the sun beside their lower bounds."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, Table, TableColumn
from workbench.analysis.cells.image import ACCURACY
from workbench.analysis.validation import validate
from workbench.arrays import Array
from workbench.extended.blur import diffraction
from workbench.extended.blurring import convolved_in_place
from workbench.extended.bound import Bound
from workbench.extended.deblur import deblur_into_spots

_PICTURES = ("letter", "photo", "ball", "flame")
_RAYS = 1 << 20


@dataclass(frozen=True)
class BoundedDesign:
    """A lens beside its lower bounds; errors are relative L2."""

    scene: str  # name of the picture
    sharp: float  # error of the target, blurred as by the source
    bound: float  # certified lower bound
    spots: float  # certified lower bound for spots of the diffraction width √(λ · distance)
    light: float  # error of the best known light
    lens: float  # verified error of the designed lens

    @property
    def ratio(self) -> float:
        """The lens over its bound."""
        return self.lens / self.bound

    @property
    def to_spots(self) -> float:
        """The lens over the bound for spots."""
        return self.lens / self.spots

    @property
    def to_light(self) -> float:
        """The lens over the best light."""
        return self.lens / self.light


def lenses(iterations: int | None, notify: Notify) -> Iterator[BoundedDesign]:
    """Design the plate of the example *Sun plate* for four pictures."""
    for picture in _PICTURES:
        changes: dict[str, Any] = {"images[0].target.image": f"../targets/{picture}-256.png"}
        if iterations is not None:
            changes["run.iterations"] = iterations
        example = BenchmarkTask.of("sun-plate", changes=changes)
        yield compare_with_bound(picture, example, notify)


def compare_with_bound(name: str, example: BenchmarkTask, notify: Notify) -> BoundedDesign:
    """Find the lower bounds of an example and design its lens."""
    scene, target = example.scene, example.target
    notify(name, "its bound")
    bound = Bound(scene, target)
    blur = bound.blur.seen_in(scene.receiver.pixels)
    blurred = convolved_in_place(target, blur.spread()[0])
    found = bound.deblurred
    notify(name, "its bound for spots")
    pixel = 2 * scene.receiver.half_extent[0] / scene.receiver.pixels[0]
    spots = deblur_into_spots(target, blur, diffraction(scene) / pixel).bound
    best = example.designed(partial(notify, name))
    seen = validate(scene, target, best.state.heights, _RAYS, accuracy=ACCURACY)
    # By cells where they are exact: the noise of few rays is a third of the error of a good lens.
    lens = (seen.by_cells or seen).relative_l2_corrected
    return BoundedDesign(name, _error(blurred, target), found.bound, spots, found.error, lens)


def table(found: Sequence[BoundedDesign]) -> Table:
    """Lenses as rows."""
    columns = (
        TableColumn("scene", "picture"),
        TableColumn("sharp", "its sharp lens, blurred", ".1%"),
        TableColumn("bound", "no lens is below", ".2%"),
        TableColumn("spots", "no light in spots of √(λ · distance)", ".2%"),
        TableColumn("light", "best light", ".2%"),
        TableColumn("lens", "this lens", ".2%"),
        TableColumn("ratio", "over the bound", ".2f"),
        TableColumn("to_spots", "over that for spots", ".2f"),
        TableColumn("to_light", "over the best light", ".2f"),
    )
    return Table("Lenses for the sun and their bounds", columns, found)


def _error(image: Array, target: Array) -> float:
    share, wanted = image / image.sum(), target / target.sum()
    return float(np.linalg.norm(share - wanted) / np.linalg.norm(wanted))
