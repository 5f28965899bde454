"""An image of a lens whose error is bounded: lattices refined until two of them agree."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from workbench.analysis.cells.drawing import Drawing
from workbench.analysis.cells.lattice import CellLattice
from workbench.analysis.cells.spots import Spots
from workbench.analysis.metrics import relative_l2
from workbench.analysis.tracing.elements import LightSource
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.train import OpticalTrain
from workbench.arrays import Array
from workbench.geometry.body import check_body
from workbench.progress import Steps, of_equal, within
from workbench.scene import Scene

ACCURACY = 1e-3
"""Relative error of an image that is good enough for a check of a lens."""

# Cells for all points of the source together in the first three levels at most: some seconds on two
# cores. No later level is begun that would follow more rays than this: half a minute at most.
_BEGIN, _MOST = 1 << 22, 1 << 26
# Nor more than so many for each random ray of the check, if that is more than what is planned for
# the first levels times this. Cells that are lost in part take more: no image is worth twice that.
_EACH, _PLANNED, _PARTLY = 16, 2, 2
# Least cells along an axis: as a rule, and where a source has many points.
_ENOUGH, _FEWEST = 32, 8
# From level to level the error is taken to fall by such a factor at most, and at least.
_FASTEST, _SLOWEST = 4.0, 1.25


@dataclass(frozen=True, eq=False)
class CellImage:
    """The image of a lens by cells."""

    irradiance: Array  # (n_y, n_x), flux per area on the screen for a source of flux 1, row 0 at +y
    bound: float  # bound of the error of the image, ‖I − I_exact‖ / ‖I‖, from two levels of cells
    cells: tuple[int, int]  # cells along x and y of the finer level
    # The accuracy that was asked for. Where the bound is above it, finer cells would have taken too
    # many rays.
    wanted: float
    # Whether its origins stand for a source of some size, so that finer cells need more of them.
    sized: bool = False

    def error(self, target: Array) -> tuple[float, float]:
        """Relative L2 distance to a target in any scale, and the bound of its own error."""
        image = self.irradiance
        size = float(np.linalg.norm(image) / image.sum() / np.linalg.norm(target) * target.sum())
        return relative_l2(image, target), self.bound * size


def imaging(
    scene: Scene,
    heights: Mapping[str, Array],
    accuracy: float = ACCURACY,
    pose: Pose | None = None,
    threads: int | None = None,
    random_rays: int | None = None,
) -> Steps[CellImage | None]:
    """Find the image of a lens by cells, step by step.

    Each level has cells of half the width of those before, and a source of some size has twice as
    many origins; see `LightSource.finer`. Where each place of a lens makes a wide spot of a disc of
    directions, `Spots` are drawn, whose outlines have twice as many corners. If its error is a
    factor r smaller, the difference of the two images over r − 1 is the error of the finer one. The
    factor is measured from three levels, and is taken to be at most 4, that of second order: where
    the error falls sooner, as it mostly does, the bound is above it.

    `scene`: lens, source and screen; filter and run settings play no part; `heights` (n_u, n_v);
    `accuracy`: cells are refined until the bound is below this, or too many rays would be followed;
    `pose`: how the lens stands; straight and centred by default; `threads`: how many trace; as many
    as there are cores by default; `random_rays`: random rays of the check. Up to 16 rays of cells
    are followed at each level for each of these, or 8 million, and never more than 67 million, the
    default. The third level may take twice as many. Returns None if three levels would take too
    many rays, light passes several elements, or no cell has light on the receiver, as before an
    emitter that nearly touches the lens. Raises `Refused` if the lens is no body or may touch the
    screen; see `check_body`.
    """
    if scene.is_train:
        return None
    levels = Levels(scene, heights, pose)
    if not levels.possible:
        return None
    most = _MOST
    if random_rays is not None:
        most = min(max(_EACH * random_rays, _PLANNED * _BEGIN), _MOST)
    images: list[Array] = []
    bound, level = math.inf, 0
    while True:
        drawing = levels.drawing(level)
        # Each level takes most of what is left of the whole.
        image = yield from within(drawing.tracing(threads), partial(_done, level))
        images = [*images[-2:], image]
        if level >= 2:
            bound = _bound(*images)
            more = levels.more(level)
            # Where origins double too, a level that is not the last one takes longer than random
            # rays that are as exact.
            hopeless = more > 1 and bound > _FASTEST * accuracy
            if bound <= accuracy or hopeless or 4 * more * drawing.rays > most:
                break
        elif 4 * levels.more(level) * drawing.rays > _PARTLY * most:
            return None
        level += 1
    if not image.any():  # random rays tell whether there is light that these cells do not meet
        return None
    irradiance = image / scene.receiver.pixel_measure
    return CellImage(irradiance, bound, levels.cells(level), accuracy, levels.sized)


class Levels:
    """Images of a lens by finer and finer cells, each the sum over all lines of the light.

    `possible`: whether the source has few enough points for three levels.
    """

    def __init__(
        self, scene: Scene, heights: Mapping[str, Array], pose: Pose | None = None
    ) -> None:
        scene.check_one_element("the image by cells")
        check_body(scene, heights)
        lines = [
            (
                line.part,
                OpticalTrain.of(line.scene, heights, 1, 0, pose or Pose(), [scene.receiver]),
            )
            for line in scene.lines
        ]
        train = lines[0][1]
        self._scene, self._lines, self._source = scene, lines, train.source
        self._wide = Spots.suit(scene, train)
        each = Spots.work if self._wide else train.source.finer(2).origins
        self._first = _first(scene, len(lines) * each)
        self.possible = min(self._first) >= _FEWEST
        self.sized = _more(train.source, 0) > 1

    def cells(self, level: int) -> tuple[int, int]:
        """Cells along x and y; levels are counted from 0."""
        n_x, n_y = self._first
        return n_x << level, n_y << level

    def drawing(self, level: int) -> "LinesDrawing":
        """What draws the image of a level."""
        return LinesDrawing([(part, self._of_line(train, level)) for part, train in self._lines])

    def _of_line(self, train: OpticalTrain, level: int) -> Drawing:
        """Spots of wide light, or cells from some origins."""
        if self._wide:
            return Spots(self._scene, train, self.cells(level), level)
        light = train.source.finer(level)
        return CellLattice(self._scene, train.lit_by(light), self.cells(level))

    def more(self, level: int) -> float:
        """How many times as many origins there are at the next level."""
        return 1.0 if self._wide else _more(self._source, level)


class LinesDrawing:
    """The image of all lines of the light, of which each has its part of the flux and a drawing.

    Attributes
    ----------
    rays : int
        Rays followed; known once all is traced.
    """

    def __init__(self, lines: Sequence[tuple[float, Drawing]]) -> None:
        self._lines, self.rays = lines, 0

    def tracing(self, threads: int | None = None) -> Steps[Array]:
        """See `Drawing.tracing`."""
        image: Array | float = 0.0
        for done, (part, drawing) in enumerate(self._lines):
            steps = within(drawing.tracing(threads), partial(of_equal, len(self._lines), done))
            image = image + part * (yield from steps)
            self.rays += drawing.rays
        return np.asarray(image)


def _done(level: int, fraction: float) -> float:
    """The part of the whole that is done with a part of a level."""
    return 1 - math.pow(0.25, level + fraction)


def _more(light: LightSource, level: int) -> float:
    """How many times as many origins there are at the next level."""
    return light.finer(level + 1).origins / light.finer(level).origins


def _first(scene: Scene, each: float) -> tuple[int, int]:
    """Cells along x and y of the first level, if one of the third takes so much work."""
    # Where light is parallel, cells end where the polynomials of the face do.
    spans = [n - p for n, p in zip(scene.optic.net_shape, scene.optic.degree, strict=True)]
    n_x, n_y = (count * -(-_ENOUGH // count) for count in spans)
    if (wanted := 16 * n_x * n_y * each) > _BEGIN:
        shrink = math.sqrt(_BEGIN / wanted)
        n_x, n_y = (int(n * shrink) for n in (n_x, n_y))
    return n_x, n_y


def _bound(coarse: Array, middle: Array, fine: Array) -> float:
    """Bound of the relative error of the finest of three levels."""
    before, last = (float(np.linalg.norm(i)) for i in (middle - coarse, fine - middle))
    if last == 0:
        return 0.0
    factor = min(max(before / last, _SLOWEST), _FASTEST)
    return last / float(np.linalg.norm(fine)) / (factor - 1)
