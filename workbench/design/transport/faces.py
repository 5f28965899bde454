"""Faces that send light to given places on a receiver, found on even cells of the element."""

import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import scipy
import torch

from workbench.arrays import Array
from workbench.design.limits import HeightLimits, bounded
from workbench.design.transport.cells import Pair, Vector, between
from workbench.design.transport.turning import Turning, half_angle
from workbench.design.transport.view import ReceiverView
from workbench.geometry.basis import clamped_knots, sparse_basis
from workbench.geometry.surface import ControlNet
from workbench.optics.glass import FlatGlass
from workbench.optics.interfaces import TransmittanceLaw
from workbench.optics.kernels import threads
from workbench.optics.path import Path
from workbench.optics.plan import traced_lines
from workbench.optics.reference import Reference
from workbench.optics.sources import emitter_of
from workbench.scene import ExactMethod, PointSource, Scene

SlopesFor = Callable[[Pair, Pair], Pair]
"""Slopes along x and y that light needs at places in cells of the lens to places u, v."""

# Blocks along an axis within which what a net cannot follow cancels out.
_BLOCKS = 16
_ALL = slice(None)
# Light that leaves a face changes little from one of these cells to the next: each stands for so
# many along an axis.
_SHARED = 2
# In half-widths of the element: rays that meet the face so near to the middles of cells are theirs;
# and the number of rays along an axis that show it.
_NEAR, _FEW_RAYS = 1e-6, 16


class SlopeFit:
    """Least squares on a tensor grid of even places, for one net and many fields of slopes.

    The normal equations are a sum of two Kronecker products; the eigenvectors of the pairs of
    small matrices along each axis make them diagonal (Lynch, Rice and Thomas 1964).

    `net`: where the control heights sit; `places`: places along each axis, at least as many as
    control points: the middles of equal cells.
    """

    def __init__(self, net: ControlNet, places: int) -> None:
        self._x, self._y = (
            _axis(count, degree, places)
            for count, degree in zip(net.shape, net.degree, strict=True)
        )
        self._width_x, self._width_y = (2 * r for r in net.half_width)
        stretch_x, stretch_y = (
            self._x.stretch / self._width_x**2,
            self._y.stretch / self._width_y**2,
        )
        self._stretch = stretch_x[:, None] + stretch_y[None, :]
        # The mean height does not matter to slopes, nor do heights that no place sees.
        self._seen = self._stretch > 1e-10 * self._stretch.max()

    def surface(self, heights: Array) -> Array:
        """Heights of the face at the places, shape (places, places)."""
        return np.asarray((self._y.value @ (self._x.value @ heights).T).T)

    def slopes(self, heights: Array) -> tuple[Array, Array]:
        """Slopes dz/dx and dz/dy of the face at the places, each of shape (places, places)."""
        x, y = self._x, self._y
        along_x = (y.value @ (x.slope @ heights).T).T / self._width_x
        along_y = (y.slope @ (x.value @ heights).T).T / self._width_y
        return np.asarray(along_x), np.asarray(along_y)

    def heights(self, slope_x: Array, slope_y: Array) -> Array:
        """Control heights of the face, up to a constant.

        `slope_x`, `slope_y` (places, places): wanted slopes dz/dx and dz/dy at the places.
        """
        x, y = self._x, self._y
        moments = (y.value.T @ (x.slope.T @ (slope_x / self._width_x)).T).T
        moments += (y.slope.T @ (x.value.T @ (slope_y / self._width_y)).T).T
        amplitudes = np.zeros_like(moments)
        np.divide(x.modes.T @ moments @ y.modes, self._stretch, out=amplitudes, where=self._seen)
        return np.asarray(x.modes @ amplitudes @ y.modes.T)


class _Axis(NamedTuple):
    """Splines along an axis from 0 to 1."""

    # (places, count), basis functions and their derivatives at the places.
    value: "scipy.sparse.csr_array"
    slope: "scipy.sparse.csr_array"
    # (count, count), vectors that make the mass matrix the identity and the stiffness matrix
    # diagonal.
    modes: Array
    stretch: Array  # (count,), that diagonal


@lru_cache(maxsize=8)  # both axes of most nets, one design after the other, and refits share it
def _axis(count: int, degree: int, places: int) -> _Axis:
    knots, middles = clamped_knots(count, degree), (np.arange(places) + 0.5) / places
    value, slope = (sparse_basis(knots, degree, middles, derivative) for derivative in (0, 1))
    mass = (value.T @ value).toarray()
    # A trace of ridge: with few places a mass matrix need not be definite.
    mass += 1e-12 * np.trace(mass) / count * np.eye(count)
    stretch, modes = _eigenvectors_of_mirrored((slope.T @ slope).toarray(), mass)
    return _Axis(value, slope, modes, stretch)


def _eigenvectors_of_mirrored(stiffness: Array, mass: Array) -> tuple[Array, Array]:
    """Eigenvalues and vectors of two matrices that are the same when counted from the other end.

    Vectors that are even and those that are odd are found apart, in a quarter of the time.
    """
    half = len(mass) // 2
    rest = len(mass) - half  # with the middle of an odd number
    values, modes = np.empty(len(mass)), np.zeros(mass.shape)
    for sign, size, found in ((1, rest, slice(None, rest)), (-1, half, slice(rest, None))):
        pair = (
            _folded(_folded(matrix, size, half, sign).T, size, half, sign)
            for matrix in (stiffness, mass)
        )
        values[found], vectors = scipy.linalg.eigh(*pair)
        modes[:size, found] = vectors
        modes[::-1][:half, found] = sign * vectors[:half]
    return values, modes


def _folded(rows: Array, size: int, half: int, sign: int) -> Array:
    folded = rows[:size].copy()
    folded[:half] += sign * rows[::-1][:half]
    return folded


class FaceLight:
    """Light on the exit face: its flux in each cell, and its direction from inside.

    It comes from one place, the middle of the source; what a file says of its intensity counts.
    """

    def __init__(self, scene: Scene, net: ControlNet, fit: SlopeFit, cells: int) -> None:
        r_x, r_y = scene.optic.half_width
        middle = 2 * (np.arange(cells) + 0.5) / cells - 1
        self.x, self.y = (middle * r_x)[:, None], (middle * r_y)[None, :]
        self._entrance_z, self._face = scene.optic.front_z, scene.optic.designed_face
        self._along: tuple[float, float, float] | None = None
        self._glass: FlatGlass | None = None
        self._fit, self._given = fit, emitter_of(scene.source, scene.optic).origins
        sharp = scene.source.sharp
        if self._given.pattern is not None:  # a file's origin need not be where its light is
            x, y, z = (float(c) for c in self._given.middle(self.x, self.y, self._entrance_z))
            sharp = PointSource(kind="point", position=(x, y, z))
        if isinstance(sharp, PointSource):  # a first design needs no triangles
            sharp = sharp.model_copy(update={"intersection": ExactMethod()})
        scene = scene.model_copy(update={"source": sharp})
        self._scene, self._net = scene, net
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
        self._reference = Reference(Path.of(scene, net, torch.float64, samples=samples))

    def flux(self, heights: Array) -> Array | None:
        """Flux that leaves the face, in each cell; all together 1. None if there is none."""
        with torch.no_grad():
            leaving = self._reference.arrival({self._face: torch.as_tensor(heights)}).rays.flux
        flux = leaving.numpy().astype(np.float64)
        flux = flux.repeat(_SHARED, 0).repeat(_SHARED, 1)
        if self._given.pattern is not None:
            flux = flux * self._brighter(self._fit.surface(heights))
        total = float(flux.sum())
        return flux / total if total > 0 else None

    def flux_or(self, heights: Array, flux: Array) -> Array:
        """`flux`, or another one if a lens reflects all light: it is improved blindly."""
        passed = self.flux(heights)
        return flux if passed is None else passed

    def goes_to(self, heights: Array) -> Pair | None:
        """Where on the receiver the light of each cell lands, in the receiver's coordinates.

        None where some of it lands nowhere, or where rays do not meet the face in the middles of
        cells.
        """
        if not self._meets_middles(heights):
            return None
        cells = len(self.x), self.y.size
        lines = traced_lines(self._scene, self._net, None, True, cells, (False, False))
        strongest = max(lines, key=lambda line: line.part)
        with torch.no_grad():
            hits = strongest.tracer.nodes({self._face: torch.tensor(heights)}).hits
        column, row = hits[:2].double().numpy().transpose(0, 2, 1)
        if not (np.isfinite(column).all() and np.isfinite(row).all()):
            return None
        u, v = self._scene.receiver.from_pixels(column, row)
        return u, v

    def _meets_middles(self, heights: Array) -> bool:
        """Whether rays of few cells meet the face in the middles of these."""
        few = _FEW_RAYS, _FEW_RAYS
        reference = Reference(Path.of(self._scene, self._net, torch.float64, samples=few))
        with torch.no_grad():
            rays = reference.arrival({self._face: torch.tensor(heights)}).rays
        middle = 2 * (np.arange(_FEW_RAYS) + 0.5) / _FEW_RAYS - 1
        r_x, r_y = self._scene.optic.half_width
        x, y = (place.numpy() for place in rays.position[:2])
        away = np.abs(x - r_x * middle[:, None]).max(), np.abs(y - r_y * middle).max()
        return bool(max(away) <= _NEAR * max(r_x, r_y))

    def _brighter(self, z: Array) -> Array:
        """Light that enters on its way to each place, over that of the point in the middle."""
        d_x, d_y, d_z = self.direction(z)
        depth = z - self._entrance_z
        x, y = self.x - depth * d_x / d_z, self.y - depth * d_y / d_z
        given, even = (o.density(x, y, self._entrance_z) for o in (self._given, self._sharp))
        return given / even

    def direction(self, z: Array, lines: slice = _ALL) -> Vector:
        """Unit vectors at places of the face with heights z, in some lines of cells along x."""
        if self._along is not None:
            d_x, d_y, d_z = (np.full_like(z, part) for part in self._along)
            return d_x, d_y, d_z
        away_x = self._away_x[lines]
        if self._glass is None:
            return unit(away_x, self._away_y, z - self._from_z)
        depth = torch.as_tensor((z - self._entrance_z).clip(0))
        radius2 = torch.as_tensor(away_x**2 + self._away_y**2)
        slope = self._glass.slope(radius2, depth).numpy()
        return unit(away_x * slope, self._away_y * slope, np.ones_like(z))


def unit(x: Array, y: Array, z: Array) -> Vector:
    """Vectors of length 1 along others."""
    length = np.sqrt(x**2 + y**2 + z**2)
    return x / length, y / length, z / length


class Faces:
    """Finds faces that send light where a transport says.

    `scene`: the design task; an extended source counts as a point at its centre; `net`: of the
    face, with fewer control points than cells along each axis. `light`: light on the face; `view`:
    of the receiver.
    """

    def __init__(self, scene: Scene, net: ControlNet, cells: int) -> None:
        self.scene, self.view = scene, ReceiverView.of(scene)
        self._fit, self._limits = SlopeFit(net, cells), HeightLimits.of(bounded(scene), net)
        self.light = FaceLight(scene, net, self._fit, cells)
        self._turning, self._half_angle = Turning.at_exit(scene.optic), half_angle(scene)

    def begin(self) -> tuple[Array, Array] | None:
        """Heights of a lens that light leaves, and its flux in each cell; None if there is none."""
        for heights in self._candidates():
            flux = self.light.flux(heights)
            if flux is not None:
                return heights, flux
        return None

    def _candidates(self) -> Iterator[Array]:
        """The undesigned lens; plates, that reflect none of the light totally."""
        undesigned = self._limits.undesigned
        yield undesigned
        yield np.full_like(undesigned, undesigned.mean())
        yield np.full_like(undesigned, self._limits.lower.min())

    def fitted(self, to: Pair, heights: Array, fits: int) -> Array:
        """Control heights of a face, from those of one like it, found in so many fits."""
        for _ in range(fits):
            heights = self._limits.placed(self._fit.heights(*self._within_reach(to, heights)))
        return heights

    def missed(self, to: Pair, heights: Array) -> float:
        """How far a face as it is found by `fitted` sends light from where it should go.

        In parts of the receiver's width, a root mean square. What a net of control points cannot
        follow is left out: only what no smooth face can.
        """
        wanted, extent = self._wanted(to, heights), self.scene.receiver.half_extent
        found = self._fit.slopes(self._fit.heights(*wanted))
        square = 0.0
        for axis, half in enumerate(extent):
            beside = to[0] + (axis == 0) * half, to[1] + (axis == 1) * half
            rate = float(np.median(self._wanted(beside, heights)[axis] - wanted[axis]))
            square += float(np.square(_coarsely(found[axis] - wanted[axis]) / (2 * rate)).mean())
        return math.sqrt(square)

    def slopes_for(self, heights: Array) -> SlopesFor:
        """The slopes that light needs in any cell of a face like another."""
        z = self._fit.surface(heights)
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
        z = self._fit.surface(heights)
        return self._slopes((self.light.x, self.light.y, z), self.light.direction(z), to)

    def _slopes(self, place: Vector, coming: Vector, to: Pair) -> Pair:
        return self._turning.slopes(coming, self._towards(place, to))

    def _towards(self, place: Vector, to: Pair) -> Vector:
        x, y, z = self.scene.receiver.towards(self.scene.optic, place, *to)
        return x, y, z

    def _within_reach(self, to: Pair, heights: Array) -> Pair:
        """Slopes for light that should go to places, or as near to them as a face can send it."""
        z, (u, v) = self._fit.surface(heights), to
        slope_x, slope_y = np.empty_like(z), np.empty_like(z)

        def work(begin: int, end: int) -> None:
            lines = slice(begin, end)
            found = self._slopes_within_reach(z[lines], (u[lines], v[lines]), lines)
            slope_x[lines], slope_y[lines] = found

        threads.run_lines(work, len(z), z.size)
        return slope_x, slope_y

    def _slopes_within_reach(self, z: Array, to: Pair, lines: slice) -> Pair:
        coming = self.light.direction(z, lines)
        going = self._towards((self.light.x[lines], self.light.y, z), to)
        index = self.scene.optic.index
        # Of a source that is seen at a slant less counts, and from farther away.
        spread = self._half_angle * np.maximum(1 - index**2 * (1 - coming[2] ** 2), 0.0) / index
        return self._turning.slopes(coming, self._turning.reached(coming, going, spread))


def _coarsely(values: Array) -> Array:
    size = len(values) // _BLOCKS
    kept = values[: size * _BLOCKS, : size * _BLOCKS]
    return np.asarray(kept.reshape(_BLOCKS, size, _BLOCKS, size).mean((1, 3)))
