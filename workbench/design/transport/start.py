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
from workbench.design.transport.chart import Chart
from workbench.design.transport.face import SlopeFit
from workbench.design.transport.face_light import FaceLight
from workbench.design.transport.faces import Faces
from workbench.design.transport.view import ReceiverView
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene

# Cells along each axis, of lens and screen alike; finer nets get more places for their slopes: at
# least so many for each control point, in a number that can be halved often. Rows of 896 cells take
# twice the time of those of 864: they lie a multiple of 1024 bytes apart, on the same places of a
# cache.
CELLS, _PER_CONTROL_POINT, _STEP = 256, 1.62, 96
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
    light = FaceLight(scene, net, fit, cells)
    limits = HeightLimits.of(bounded(scene), net)
    view = ReceiverView.of(scene)
    wanted, weights = wanted_cells(scene, target, cells)

    passing = ((z, flux) for z in _candidates(limits) if (flux := light.flux(z)) is not None)
    heights, flux = next(passing, (None, None))
    if heights is None or flux is None:
        return None
    transport = Transport(flux, wanted, weights, FEW_ROUNDS)
    faces = Faces(scene, light, fit, limits)
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
