"""Images of a lens with bounded error, by cells that are halved until two images agree."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from workbench.analysis.cells.drawing import Drawing
from workbench.analysis.cells.lattice import CellLattice
from workbench.analysis.cells.spots import Spots
from workbench.analysis.metrics import enough, relative_l2
from workbench.analysis.tracing.elements import LightSource
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.train import OpticalTrain
from workbench.arrays import Array
from workbench.geometry.as_made import scatterer_of
from workbench.geometry.body import check_body
from workbench.geometry.surface import nets_of
from workbench.progress import Steps, of_equal, within
from workbench.scene import Scene

ACCURACY = 1e-3
"""Relative error of an image that suffices for a check."""

# Most rays of the first three levels (seconds on two cores) and of a later level (half a minute).
_BEGIN, _MOST = 1 << 22, 1 << 26
# Most rays of a level for each random ray of the check, least limit in units of _BEGIN, and factor
# of the limit for partly lost cells.
_EACH, _PLANNED, _PARTLY = 16, 2, 2
_ENOUGH, _FEWEST = 32, 8  # least cells along an axis, and for a source of many points
_FASTEST, _SLOWEST = 4.0, 1.25  # largest and least ratio of the errors of two levels
_AIM = 0.8  # part of the accuracy that a level in between is to reach


@dataclass(frozen=True, eq=False)
class CellImage:
    """The image of a lens by cells."""

    irradiance: Array  # (n_y, n_x), flux per area for a source of flux 1, row 0 at +y
    bound: float  # of the error ‖I − I_exact‖ / ‖I‖, from two levels
    cells: tuple[int, int]  # along x and y, of the finer level
    wanted: float  # requested accuracy
    lost: Mapping[str, float]  # parts of the emitted flux, by keys of the light account
    sized: bool = False  # whether finer levels have more origins, as for an extended source

    def error(self, target: Array) -> tuple[float, float]:
        """Return the relative L2 distance to a target in any scale, and its error bound."""
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
    target: Array | None = None,
) -> Steps[CellImage | None]:
    """Compute the image of a lens by cells in steps, until the bound is below ``accuracy``.

    `target` (n_y, n_x): an image that is far from it has to be as accurate as `enough` says.

    Each level has cells of half the width, and twice as many origins of an extended source; see
    `LightSource.finer`. A disc of directions is drawn as `Spots`. If the error falls by a factor r,
    the difference of the two images over r − 1 is the error of the finer one. The factor comes from
    three levels and is at most 4 (second order). Spots, which need not end where polynomials do,
    have a last level in between if that suffices by this order of convergence; its bound is also at
    least the distance to the level before beyond the bound of that.

    A level has at most 16 rays for each of ``random_rays``, or 8 million, and at most 67 million.
    Returns None if three levels need more, if something scatters the light, or if no cell has
    light on the receiver. Raises `Refused` if the lens is no solid body or may touch the screen.
    """
    if scatterer_of(scene) is not None:
        return None
    levels = Levels(scene, heights, pose)
    if not levels.possible:
        return None
    most = _MOST
    if random_rays is not None:
        most = min(max(_EACH * random_rays, _PLANNED * _BEGIN), _MOST)
    images: list[Array] = []
    bound, factor, level, step, wanted = math.inf, _FASTEST, 0.0, 1.0, accuracy
    while True:
        drawing = levels.drawing(level)
        image = yield from within(drawing.tracing(threads), partial(_done, level))
        images = [*images[-2:], image]
        if step < 1:
            bound = max(bound * factor**-step, _apart(*images[-2:]) - bound)
            break
        if level >= 2:
            bound, factor = _bound(*images)
            if target is not None and image.any():
                wanted = enough(accuracy, relative_l2(image, target) - bound)
            more = levels.more(level)
            # Where origins double too, random rays are faster than several more levels.
            hopeless = more > 1 and bound > _FASTEST * wanted
            if bound > wanted and levels.gradual:
                step = min(math.log(bound / (_AIM * wanted), factor), 1.0)
            if bound <= wanted or hopeless or 4**step * more * drawing.rays > most:
                break
        elif 4 * levels.more(level) * drawing.rays > _PARTLY * most:
            return None
        level += step
    if not image.any():  # random rays may still find light
        return None
    irradiance = image / scene.receiver.pixel_measure
    return CellImage(irradiance, bound, levels.cells(level), wanted, drawing.lost, levels.sized)


class Levels:
    """Images of a lens by finer cells, summed over the lines of the spectrum.

    ``possible`` is false if the source has too many points for three levels; ``gradual`` is true if
    there are levels in between.
    """

    def __init__(
        self, scene: Scene, heights: Mapping[str, Array], pose: Pose | None = None
    ) -> None:
        scene.check_no_diffuser("the image by cells")
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
        self.gradual = Spots.suit(scene, train)
        each = Spots.work if self.gradual else train.source.finer(2).origins
        self._first = _first(scene, len(lines) * each)
        self.possible = min(self._first) >= _FEWEST
        self.sized = _more(train.source, 0) > 1

    def cells(self, level: float) -> tuple[int, int]:
        """Return the cells along x and y of a level from 0."""
        n_x, n_y = self._first
        return round(n_x * 2**level), round(n_y * 2**level)

    def drawing(self, level: float) -> "LinesDrawing":
        """Return the drawing of a level."""
        return LinesDrawing([(part, self._of_line(train, level)) for part, train in self._lines])

    def _of_line(self, train: OpticalTrain, level: float) -> Drawing:
        """Return the spots or cells of a line."""
        if self.gradual:
            return Spots(self._scene, train, self.cells(level))
        light = train.source.finer(int(level))
        return CellLattice(self._scene, train.lit_by(light), self.cells(level))

    def more(self, level: float) -> float:
        """Return the ratio of the origins of the next level."""
        return 1.0 if self.gradual else _more(self._source, int(level))


class LinesDrawing:
    """Image of all lines of the spectrum, each with its part of the flux and its drawing."""

    def __init__(self, lines: Sequence[tuple[float, Drawing]]) -> None:
        self._lines, self.rays = lines, 0
        self.lost: dict[str, float] = {}

    def tracing(self, threads: int | None = None) -> Steps[Array]:
        """See `Drawing.tracing`."""
        image: Array | float = 0.0
        for done, (part, drawing) in enumerate(self._lines):
            steps = within(drawing.tracing(threads), partial(of_equal, len(self._lines), done))
            image = image + part * (yield from steps)
            self.rays += drawing.rays
            for name, flux in drawing.lost.items():
                self.lost[name] = self.lost.get(name, 0.0) + part * flux
        return np.asarray(image)


def _done(level: float, fraction: float) -> float:
    """Fraction of the whole that is done after a fraction of a level.

    The first three levels count as three quarters of the whole, each further one as half of the
    remainder.
    """
    if level <= 2:
        return (4**level * (1 + 3 * fraction) - 1) / 84
    return 1 - 0.5 ** math.ceil(level) * (2 - fraction)


def _more(light: LightSource, level: int) -> float:
    """How many times as many origins there are at the next level."""
    return light.finer(level + 1).origins / light.finer(level).origins


def _first(scene: Scene, each: float) -> tuple[int, int]:
    """Cells along x and y of the first level, if one of the third takes so much work."""
    # Where light is parallel, cells end where the polynomials of the finest face do.
    nets = nets_of(scene).values()
    spans = (max(net.shape[axis] - net.degree[axis] for net in nets) for axis in (0, 1))
    n_x, n_y = (count * -(-_ENOUGH // count) for count in spans)
    if (wanted := 16 * n_x * n_y * each) > _BEGIN:
        shrink = math.sqrt(_BEGIN / wanted)
        n_x, n_y = (int(n * shrink) for n in (n_x, n_y))
    return n_x, n_y


def _bound(coarse: Array, middle: Array, fine: Array) -> tuple[float, float]:
    """Bound of the relative error of the finest of three levels, and by what it falls each time."""
    before, last = (float(np.linalg.norm(i)) for i in (middle - coarse, fine - middle))
    if last == 0:
        return 0.0, _FASTEST
    factor = min(max(before / last, _SLOWEST), _FASTEST)
    return _apart(middle, fine) / (factor - 1), factor


def _apart(coarse: Array, fine: Array) -> float:
    return float(np.linalg.norm(fine - coarse) / np.linalg.norm(fine))
