"""A lens that sends the light roughly where it is wanted, within a second and without any search.

1. Optimal transport between the light that leaves the exit face and the target says which part of
   the light should go where. The cost −x·y is the one for which a thin lens under small angles can
   be exact (Glimm and Oliker 2003); the rest is left to the optimiser.
2. The laws of refraction and reflection say which slopes the face needs for that.
3. Least squares find the face of the B-spline space that comes closest to these slopes.

The flux on the face and the heights in 2 depend on the face itself: all of it is done twice. Light
in as many cells as slopes, and more fits to one transport, would cost a third of a start of
parallel light and change its image by a hundredth of its error. Light of a near source is another
one behind each face: with one fit in place of two to the last transport, measured rays of an LED
begin at 16.6 % in place of 9.9 %.
"""

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple, Self

import numpy as np
import torch

from workbench.arrays import Array
from workbench.design.levels import COARSE, image_of
from workbench.design.limits import HeightLimits, bounded
from workbench.design.loss import relative_error
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.chart import Chart, Pair, SlopesFor, between
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.view import ReceiverView
from workbench.geometry.surface import ControlNet
from workbench.optics.face_samples import SampledFace
from workbench.optics.glass import FlatGlass
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.sources import emitter_of
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import ExactMethod, PointSource, Scene

Vector = tuple[Array, Array, Array]

# Cells along each axis, of lens and screen alike; finer nets get more places for their slopes: at
# least so many for each control point, in a number that can be halved often. Rows of 896 cells take
# twice the time of those of 864: they lie a multiple of 1024 bytes apart, on the same places of a
# cache.
CELLS, _PER_CONTROL_POINT, _STEP = 256, 1.62, 96
# Light that leaves a face changes little from one of these cells to the next: each stands for so
# many along an axis.
_SHARED = 2
# Fits to a transport: the first face only tells where light is, the next one is a first lens.
_ROUGH_FITS, _FITS, _NEAR_FITS = 1, 1, 2
# Rounds of transport on the finest grid for a quick lens. Where the error of its image is less than
# this, the descent does the rest sooner; else as many rounds follow as bring light nearer, and the
# better one of both lenses is taken: each may be much better than the other.
FEW_ROUNDS, _GOOD = 3, 0.06
# Light that misses its places by more than this part of the receiver's width, where no net is too
# coarse for them, is sent to places in other coordinates: so many times, as long as what is left of
# the error each time is less than this part of it. A flame misses them by 0.0003.
_STRAIGHT, _CHARTS, _LESS = 0.001, 4, 0.9
# Blocks along an axis within which what a net cannot follow cancels out.
_BLOCKS = 16
# Where no face could bend the light as wanted, the normal is kept along the axis by this part of
# what it is where light goes straight on or back: n − 1, and 2 for a mirror.
UPRIGHT = 0.1


def transport_start(scene: Scene, target: Array) -> Array | None:
    """Control heights of a first lens.

    Parameters
    ----------
    scene : Scene
        The design task; an extended source counts as a point at its centre.
    target : ndarray, shape (n_y, n_x)
        The wanted image in any scale, row 0 at +y.

    Returns
    -------
    ndarray, shape (n_u, n_v), or None
        Heights, scene units, beyond their limits where these are too narrow for the task. None if
        no light leaves the lens even where its faces are parallel.
    """
    net = ControlNet.of(scene.optic)
    cells = cells_for(net)
    fit = SlopeFit(net, cells)
    light = _Light(scene, net, fit, cells)
    limits = HeightLimits.of(bounded(scene), net)
    view = ReceiverView.of(scene)
    wanted, weights = wanted_cells(scene, target, cells)

    passing = ((z, flux) for z in _candidates(limits) if (flux := light.flux(z)) is not None)
    heights, flux = next(passing, (None, None))
    if heights is None or flux is None:
        return None
    transport = Transport(flux, wanted, weights, FEW_ROUNDS)
    faces = _Faces(scene, light, fit, limits)
    heights = faces.fitted(view.places(transport), heights, _ROUGH_FITS)
    flux = light.flux_or(heights, flux)
    transport.improve(flux, FEW_ROUNDS)
    fits = _FITS if scene.source.place is None else _NEAR_FITS
    heights = faces.fitted(view.places(transport), heights, fits)
    first = _Judged.of(scene, target, heights)
    if first.error < _GOOD:
        return first.heights
    transport.improve(flux)
    to = view.places(transport)
    best = min(first, _Judged.of(scene, target, faces.fitted(to, heights, fits)))
    begins = transport.back()
    for _ in range(_CHARTS):
        if best.error < _GOOD or faces.missed(to, best.heights) < _STRAIGHT:
            break
        chart = Chart.of(view, wanted, faces.slopes_for(best.heights), begins)
        transport = chart.transport(light.flux_or(best.heights, flux), wanted)
        begins = chart.begins(transport)
        to = chart.places(transport)
        heights = faces.fitted(to, best.heights, fits)
        before, best = best, min(best, _Judged.of(scene, target, heights))
        if best.error > _LESS * before.error:
            break
    return best.heights


class _Judged(NamedTuple):
    """A lens and how far its image is from the target; the better one is less."""

    error: float
    heights: Array

    @classmethod
    def of(cls, scene: Scene, target: Array, heights: Array) -> Self:
        return cls(first_error(scene, target, {scene.optic.face: heights}), heights)

    def __lt__(self, other: object) -> bool:
        return isinstance(other, _Judged) and self.error < other.error


def cells_for(net: ControlNet) -> int:
    """Cells along each axis of a first lens on a net."""
    return max(CELLS, _STEP * math.ceil(_PER_CONTROL_POINT * max(net.shape) / _STEP))


def wanted_cells(scene: Scene, target: Array, cells: int) -> tuple[Array, tuple[float, float]]:
    """The light that is wanted in each of ``cells`` by ``cells``, and what ways along x and y cost.

    Along x first and y upwards, as the lens is; all together 1.
    """
    view = ReceiverView.of(scene)
    wanted = view.wanted(target / target.max() * scene.receiver.relative_measure(), cells)
    return wanted / wanted.sum(), view.weights(view.half_extent)


class _Faces(NamedTuple):
    """Finds faces that send light where a transport says."""

    scene: Scene
    light: "_Light"
    fit: SlopeFit
    limits: HeightLimits

    def fitted(self, to: Pair, heights: Array, fits: int) -> Array:
        """Control heights of a face, from those of one like it, found in so many fits."""
        for _ in range(fits):
            heights = self.limits.placed(self.fit.heights(*self._wanted(to, heights)))
        return heights

    def missed(self, to: Pair, heights: Array) -> float:
        """How far a face as it is found by `fitted` sends light from where it should go.

        In parts of the receiver's width, a root mean square. What a net of control points cannot
        follow is left out: only what no smooth face can.
        """
        wanted, extent = self._wanted(to, heights), self.scene.receiver.half_extent
        found = self.fit.slopes(self.fit.heights(*wanted))
        square = 0.0
        for axis, half in enumerate(extent):
            beside = to[0] + (axis == 0) * half, to[1] + (axis == 1) * half
            rate = float(np.median(self._wanted(beside, heights)[axis] - wanted[axis]))
            square += float(np.square(_coarsely(found[axis] - wanted[axis]) / (2 * rate)).mean())
        return math.sqrt(square)

    def slopes_for(self, heights: Array) -> SlopesFor:
        """The slopes that light needs in any cell of a face like another."""
        z = self.fit.surface(heights)
        cells, direction = len(z), self.light.direction(z)

        def slopes(cell: Pair, to: Pair) -> Pair:
            x, y = (
                ((2 * place + 1) / cells - 1) * half
                for place, half in zip(cell, self.scene.optic.half_width, strict=True)
            )
            d_x, d_y, d_z = (between(part, cell) for part in direction)
            return self._slopes((x, y, between(z, cell)), (d_x, d_y, d_z), to)

        return slopes

    def _wanted(self, to: Pair, heights: Array) -> Pair:
        """Slopes in all cells of a face like another that send light to places."""
        z = self.fit.surface(heights)
        return self._slopes((self.light.x, self.light.y, z), self.light.direction(z), to)

    def _slopes(self, place: Vector, coming: Vector, to: Pair) -> Pair:
        """Slopes of the face that send light from places on it to places on the receiver."""
        optic, (d_x, d_y, d_z) = self.scene.optic, coming
        out_x, out_y, out_z = self.scene.receiver.towards(optic, place, *to)
        # Snell's law as vectors: the normal is along n d_in − d_out; of a mirror, n is 1.
        n = optic.index
        normal_z = np.maximum(n * d_z - out_z, UPRIGHT * optic.deflection)
        return -(n * d_x - out_x) / normal_z, -(n * d_y - out_y) / normal_z


def first_error(scene: Scene, target: Array, heights: Mapping[str, Array]) -> float:
    """How far the image of a lens is from the target, in the image by which a descent begins.

    Heights beyond their limits are brought within first.
    """
    limits = HeightLimits.of_faces(bounded(scene))
    image = image_of(COARSE, scene, target, scene.receiver.half_extent)
    near = {face: torch.as_tensor(limits[face].nearest(z)) for face, z in heights.items()}
    return relative_error(image.step(near).state, target)


def _candidates(limits: HeightLimits) -> Iterator[Array]:
    """Lenses that light may leave: the undesigned one; plates, that reflect none of it totally."""
    yield limits.undesigned
    yield np.full_like(limits.undesigned, limits.undesigned.mean())
    yield np.full_like(limits.undesigned, limits.lower.min())


class _Light:
    """Light on the exit face: its flux in each cell, and its direction from inside.

    It comes from one place, the middle of the source; what a file says of its intensity counts.
    """

    def __init__(self, scene: Scene, net: ControlNet, fit: SlopeFit, cells: int) -> None:
        r_x, r_y = scene.optic.half_width
        middle = 2 * (np.arange(cells) + 0.5) / cells - 1
        self.x, self.y = (middle * r_x)[:, None], (middle * r_y)[None, :]
        self._entrance_z, self._face = scene.optic.front_z, scene.optic.face
        self._along: tuple[float, float, float] | None = None
        self._glass: FlatGlass | None = None
        self._fit, self._given = fit, emitter_of(scene.source, scene.optic).origins
        sharp = scene.source.sharp
        if self._given.pattern is not None:  # a file's origin need not be where its light is
            x, y, z = (float(c) for c in self._given.middle(self.x, self.y, self._entrance_z))
            sharp = PointSource(kind="point", position=(x, y, z))
        if isinstance(sharp, PointSource):  # a first lens needs no triangles
            sharp = sharp.model_copy(update={"intersection": ExactMethod()})
        scene = scene.model_copy(update={"source": sharp})
        origins = emitter_of(scene.source, scene.optic).origins
        (x, y, z), n = origins.places[0], scene.optic.index
        if origins.infinite:  # by Snell's law, one direction in the glass
            self._along = x / n, y / n, math.sqrt(1 - (x**2 + y**2) / n**2)
        else:
            self._away_x, self._away_y = self.x - x, self.y - y
            self._from_z = z
            if n > 1:
                entering = TransmittanceLaw.constant(1 / n, 0.0)  # it bends as any other
                self._glass = FlatGlass(self._entrance_z - z, entering, origins.lambertian)
        self._sharp = origins
        samples = cells // _SHARED, cells // _SHARED
        path = Path.of(scene, net, torch.float64, samples=samples)
        # From beside a curved outline no cell of the face has a ray of its own, but corners have.
        by_cells = origins.infinite or scene.mirror is not None or SampledFace.of(path) is not None
        self._by_corners = not by_cells
        if not by_cells:
            path = Path.of(scene, net, torch.float64, samples=Corners(*samples))
        self._reference = Reference(path)

    def flux(self, heights: Array) -> Array | None:
        """Flux that leaves the face, in each cell; all together 1. None if there is none."""
        with torch.no_grad():
            leaving = self._reference.arrival({self._face: torch.as_tensor(heights)}).rays.flux
        flux = leaving.numpy().astype(np.float64)
        if self._by_corners:
            across, up = self._reference.splits
            flux = flux[:-1] * across[:-1, 1:2] + flux[1:] * across[1:, :1]
            flux = flux[:, :-1] * up[:-1, 1] + flux[:, 1:] * up[1:, 0]
        flux = flux.repeat(_SHARED, 0).repeat(_SHARED, 1)
        if self._given.pattern is not None:
            flux = flux * self._brighter(self._fit.surface(heights))
        total = float(flux.sum())
        return flux / total if total > 0 else None

    def flux_or(self, heights: Array, flux: Array) -> Array:
        """`flux`, or another one if a lens reflects all light: it is improved blindly."""
        passed = self.flux(heights)
        return flux if passed is None else passed

    def _brighter(self, z: Array) -> Array:
        """Light that enters on its way to each place, over that of the point in the middle."""
        d_x, d_y, d_z = self.direction(z)
        depth = z - self._entrance_z
        x, y = self.x - depth * d_x / d_z, self.y - depth * d_y / d_z
        given, even = (o.density(x, y, self._entrance_z) for o in (self._given, self._sharp))
        return given / even

    def direction(self, z: Array) -> tuple[Array, Array, Array]:
        """Unit vectors at places of the face with heights z."""
        if self._along is not None:
            d_x, d_y, d_z = (np.full_like(z, part) for part in self._along)
            return d_x, d_y, d_z
        if self._glass is None:
            return _unit(self._away_x, self._away_y, z - self._from_z)
        depth = torch.as_tensor((z - self._entrance_z).clip(0))
        radius2 = torch.as_tensor(self._away_x**2 + self._away_y**2)
        slope = self._glass.slope(radius2, depth).numpy()
        return _unit(self._away_x * slope, self._away_y * slope, np.ones_like(z))


def _unit(x: Array, y: Array, z: Array) -> tuple[Array, Array, Array]:
    """Vectors of length 1 along others."""
    length = np.sqrt(x**2 + y**2 + z**2)
    return x / length, y / length, z / length


def _coarsely(values: Array) -> Array:
    """Means of values over blocks of cells."""
    size = len(values) // _BLOCKS
    kept = values[: size * _BLOCKS, : size * _BLOCKS]
    return np.asarray(kept.reshape(_BLOCKS, size, _BLOCKS, size).mean((1, 3)))
