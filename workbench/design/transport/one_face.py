"""First lenses of one free face: light goes roughly where it is wanted, without any search.

1. Optimal transport between the light that leaves the exit face and the target says which part of
   the light should go where. The cost −x·y is the one for which a thin lens under small angles can
   be exact (Glimm and Oliker 2003). Where it is far from that, places on the receiver get other
   coordinates first (`workbench.design.transport.chart`); the optimiser does the rest.
2. The laws of refraction and reflection say which slopes the face needs for that.
3. Least squares find the face of the B-spline space that comes closest to these slopes.

The flux on the face and the heights in 2 depend on the face itself: all of it is done with few
cells first, which also find the other coordinates. Light in as many cells as slopes, and more
fits to one transport, would cost a third of a start of parallel light and change its image by a
hundredth of its error. Light of a near source is another one behind each face: with one fit in
place of two to the last transport, measured rays of an LED begin at 16.6 % in place of 9.9 %.
"""

import math
from collections.abc import Mapping
from typing import NamedTuple, Self

from workbench.arrays import Array
from workbench.design.images import WideImage
from workbench.design.levels import COARSE, cells_of
from workbench.design.limits import HeightLimits, bounded
from workbench.design.loss import relative_error
from workbench.design.transport.chart import PER_CONTROL_POINT, rough_lens
from workbench.design.transport.faces import Faces
from workbench.design.transport.view import ReceiverView
from workbench.geometry.surface import ControlNet
from workbench.optics.account import UnbalancedAccount
from workbench.optics.plan import tensors_of
from workbench.scene import Scene

# Cells along each axis, of lens and screen alike; finer nets get more places for their slopes, in a
# number that can be halved often. Rows of 896 cells take twice the time of those of 864: they lie a
# multiple of 1024 bytes apart, on the same places of a cache.
CELLS, _STEP = 256, 96
# Fits to a transport of parallel light, and of a near source's.
_FITS, _NEAR_FITS = 1, 2
# Rounds of transport on the finest grid. A quick lens has none: under the blur of the sun, a
# photograph begins 1.149 in place of 1.136 times its lower bound off, and ends as low. Where the
# error of an image is less than this, the descent does the rest sooner: words and dots end at 2.07
# and 1.91 % so, and at 1.97 and 1.73 % after six rounds, which take 2 to 3 s of the processor more.
# Else the rounds follow that bring light nearer, and the better one of both lenses is taken: each
# may be much better than the other.
FEW_ROUNDS, _GOOD = 2, 0.1


def transport_start(scene: Scene, target: Array, quick: bool = False) -> Array | None:
    """Control heights of a first design.

    `scene`: the design task; an extended source counts as a point at its centre; `target` (n_y,
    n_x): the wanted image in any scale, row 0 at +y. Returns (n_u, n_v): heights, scene units,
    beyond their limits where these are too narrow for the task. None if no light leaves the lens
    even where its faces are parallel.
    """
    net = ControlNet.of(scene.optic)
    wanted, _ = wanted_cells(scene, target, cells_for(net))
    fits = _FITS if scene.source.place is None else _NEAR_FITS
    rough = rough_lens(scene, net, wanted, fits)
    if rough is None:
        return None
    faces, heights = Faces(scene, net, len(wanted)), rough.heights
    times = len(wanted) // len(rough.flux)
    spread = rough.flux.repeat(times, 0).repeat(times, 1) / times**2
    flux = faces.light.flux_or(heights, spread)
    rounds = 0 if quick else FEW_ROUNDS
    transport, places = rough.transported(faces.view, flux, wanted, rounds)
    heights = faces.fitted(places(transport), heights, fits)
    if quick:
        return heights
    first = _Judged.of(scene, target, heights)
    if first.error < _GOOD:
        return first.heights
    transport.improve(faces.light.flux_or(heights, flux))
    heights = faces.fitted(places(transport), heights, fits)
    return min(first, _Judged.of(scene, target, heights)).heights


class _Judged(NamedTuple):
    """A lens and how far its image is from the target; the better one is less."""

    error: float
    heights: Array

    @classmethod
    def of(cls, scene: Scene, target: Array, heights: Array) -> Self:
        try:
            error = first_error(scene, target, {scene.optic.designed_face: heights})
        except UnbalancedAccount:  # the samples are too few for such a face
            error = math.inf
        return cls(error, heights)

    def __lt__(self, other: object) -> bool:
        return isinstance(other, _Judged) and self.error < other.error


def cells_for(net: ControlNet) -> int:
    """Cells along each axis of a first design on a net."""
    return max(CELLS, _STEP * math.ceil(PER_CONTROL_POINT * max(net.shape) / _STEP))


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
    image = WideImage(scene, target, cells_of(COARSE, scene), scene.receiver.half_extent)
    near = {face: limits[face].nearest(z) for face, z in heights.items()}
    return relative_error(image.step(tensors_of(near, scene)).state, target)
