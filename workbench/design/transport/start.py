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
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import torch

from workbench.design.levels import COARSE, image_of
from workbench.design.limits import HeightLimits, bounded
from workbench.design.loss import relative_error
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.face import SlopeFit
from workbench.geometry.surface import ControlNet
from workbench.optics.glass import FlatGlass
from workbench.optics.path import Path
from workbench.optics.reference import Reference
from workbench.optics.sources import emitter_of
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import AnyReceiver, PointSource, Scene

Array = npt.NDArray[np.float64]

# Cells along each axis, of lens and screen alike; finer nets get more places for their slopes.
CELLS = 256
# Light that leaves a face changes little from one of these cells to the next: each stands for so
# many along an axis.
_SHARED = 2
# Fits to a transport: the first face only tells where light is, the next one is a first lens.
_ROUGH_FITS, _FITS, _NEAR_FITS = 1, 1, 2
# Rounds of transport on the finest grid for a quick lens. Where the error of its image is less than
# this, the descent does the rest sooner; else as many rounds follow as bring light nearer, and the
# better one of both lenses is taken: each may be much better than the other.
FEW_ROUNDS, _GOOD = 1, 0.06
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
    cells = max(CELLS, 2 * max(net.shape))
    fit = SlopeFit(net, cells)
    light = _Light(scene, net, fit, cells)
    limits = HeightLimits.of(bounded(scene), net)
    wanted, weights = wanted_cells(scene, target, cells)

    passing = ((z, flux) for z in _candidates(limits) if (flux := light.flux(z)) is not None)
    heights, flux = next(passing, (None, None))
    if heights is None or flux is None:
        return None
    transport = Transport(flux, wanted, weights, FEW_ROUNDS)
    faces = _Faces(scene, light, fit, limits)
    heights = faces.bent(transport, heights, _ROUGH_FITS)
    # A lens that reflects all light totally is improved blindly.
    passed = light.flux(heights)
    flux = flux if passed is None else passed
    transport.improve(flux, FEW_ROUNDS)
    fits = _FITS if scene.source.place is None else _NEAR_FITS
    heights = faces.bent(transport, heights, fits)
    error = first_error(scene, target, {scene.optic.face: heights})
    if error < _GOOD:
        return heights
    transport.improve(flux)
    other = faces.bent(transport, heights, fits)
    return other if first_error(scene, target, {scene.optic.face: other}) < error else heights


def wanted_cells(scene: Scene, target: Array, cells: int) -> tuple[Array, tuple[float, float]]:
    """The light that is wanted in each of ``cells`` by ``cells``, and what ways along x and y cost.

    Along x first and y upwards, as the lens is; all together 1.
    """
    optic, receiver = scene.optic, scene.receiver
    image = target / target.max() * receiver.relative_measure()
    wanted = _resampled(image[::-1].T, cells)
    r_x, r_y = (a * b for a, b in zip(optic.half_width, receiver.half_extent, strict=True))
    return wanted / wanted.sum(), (math.sqrt(r_x / r_y), math.sqrt(r_y / r_x))


def destinations(transport: Transport, receiver: AnyReceiver) -> tuple[Array, Array]:
    """Where on the receiver the light of each cell should go, in the receiver's coordinates."""
    places = zip(transport.map(), receiver.half_extent, receiver.middle, strict=True)
    to_u, to_v = (((2 * to + 1) / len(to) - 1) * half + middle for to, half, middle in places)
    return to_u, to_v


class _Faces(NamedTuple):
    """Finds faces that send light where a transport says."""

    scene: Scene
    light: "_Light"
    fit: SlopeFit
    limits: HeightLimits

    def bent(self, transport: Transport, heights: Array, fits: int) -> Array:
        """Control heights of a face, from those of one like it, found in so many fits."""
        light, optic, receiver = self.light, self.scene.optic, self.scene.receiver
        n = optic.index
        to_u, to_v = destinations(transport, receiver)
        for _ in range(fits):
            z = self.fit.surface(heights)
            d_x, d_y, d_z = light.direction(z)
            out_x, out_y, out_z = receiver.towards(optic, (light.x, light.y, z), to_u, to_v)
            # Snell's law as vectors: the normal is along n d_in − d_out; of a mirror, n is 1.
            normal_z = np.maximum(n * d_z - out_z, UPRIGHT * optic.deflection)
            slope_x = -(n * d_x - out_x) / normal_z
            slope_y = -(n * d_y - out_y) / normal_z
            heights = self.limits.placed(self.fit.heights(slope_x, slope_y))
        return heights


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
        path = Path.of(scene, net, torch.float64, samples=(cells // _SHARED, cells // _SHARED))
        self._reference = Reference(path)

    def flux(self, heights: Array) -> Array | None:
        """Flux that leaves the face, in each cell; all together 1. None if there is none."""
        with torch.no_grad():
            leaving = self._reference.arrival({self._face: torch.as_tensor(heights)}).rays.flux
        flux = leaving.numpy().astype(np.float64).repeat(_SHARED, 0).repeat(_SHARED, 1)
        if self._given.pattern is not None:
            flux = flux * self._brighter(self._fit.surface(heights))
        total = float(flux.sum())
        return flux / total if total > 0 else None

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
        light = self._glass.light(torch.as_tensor(self._away_x**2 + self._away_y**2), depth)
        slope = (light.part * light.steepness).numpy()
        return _unit(self._away_x * slope, self._away_y * slope, np.ones_like(z))


def _unit(x: Array, y: Array, z: Array) -> tuple[Array, Array, Array]:
    """Vectors of length 1 along others."""
    length = np.sqrt(x**2 + y**2 + z**2)
    return x / length, y / length, z / length


def _resampled(image: Array, cells: int) -> Array:
    """The light of an image in the cells of another grid over the same area."""
    into_0, into_1 = (_overlaps(count, cells) for count in image.shape)
    return np.asarray(into_0 @ image @ into_1.T)


def _overlaps(pixels: int, cells: int) -> Array:
    """Which part of each pixel lies in each cell of the same line, shape (cells, pixels)."""
    below = (np.linspace(0, pixels, cells + 1)[:, None] - np.arange(pixels)).clip(0, 1)
    return np.diff(below, axis=0)
