"""Transport to places in coordinates of their own, in which one face can bend light as is wanted.

Light from a place x of a face to a place y of the receiver needs a slope s(x, y) there. Transport
with a quadratic cost finds a map whose destinations are a gradient in x. Where s differs from the
coordinate of y by what depends on x alone and is a gradient itself, the slopes of all places are
those of one face. Where it does not, as on a screen that leans and by angles that are not small,
slopes have a curl, and light misses its places. So y gets new coordinates, by where its light comes
from in the transport before: s(x(y), y), less a gradient in x. A transport that stays the same by
that has no curl at all. The first design for a photograph on the wall of *Wall washer* at 50° is
27.5 % off in the receiver's own coordinates, 13.5 % as it is seen and 3.9 % by slopes.

How light misses its places changes slowly from one cell to the next, so lenses of few cells find
the chart. One of 216 cells along each axis, made of three transports and fits, takes 0.1 to 0.2 s
of the processor. The first design of 864 cells goes on from that lens and its transport.
"""

from collections.abc import Callable
from typing import NamedTuple, Self

import numpy as np

from workbench.arrays import Array
from workbench.design.transport.back_and_forth import MOST_ROUNDS, Transport, doubled, halved, push
from workbench.design.transport.cells import Pair, between, whence
from workbench.design.transport.faces import Faces, SlopesFor
from workbench.design.transport.view import ReceiverView
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene

# Cells for each control point along an axis, at least.
PER_CONTROL_POINT = 1.62
# Cells along each axis are halved as long as so many are left.
_FEWEST = 128
# Charts that are tried at most, as long as light misses its places by more than this part of the
# receiver's width, and by less than this part of before. The first one always is: light that misses
# its places by 0.2 of 256 pixels in the view, and by 0.02 of them in a chart, makes first designs
# of a photograph that are 6.0 and 3.4 % off.
_CHARTS, _NEAR, _LESS = 6, 2e-4, 0.8
# Cells over which coordinates are smoothed: where light comes from is known to a cell.
_SMOOTH = 1.0
# Parts of a cell of the view along an axis, in a chart.
_PARTS = 3


class Chart(NamedTuple):
    """Where cells of a view lie in other coordinates."""

    view: ReceiverView  # of the receiver
    # (cells, cells), for each of its cells, in cells of a rectangle that holds them.
    x: Array
    y: Array
    weights: tuple[float, float]  # what ways along x and y cost there

    @classmethod
    def of(cls, view: ReceiverView, wanted: Array, slopes_for: SlopesFor, begins: Pair) -> Self:
        """The chart by the slopes that light needs from where it comes.

        `view`: of the receiver; `wanted` (cells, cells): light in each of its cells; all together
        1; `slopes_for`: says the slopes; `begins`: in which cell of the lens the light of each of
        its cells comes from.
        """
        cells = len(wanted)
        slopes = _along_seen(view, wanted, slopes_for, begins)
        bounds = np.array([[f[wanted > 0].min(), f[wanted > 0].max()] for f in slopes])
        middle, half = bounds.mean(axis=1), np.diff(bounds)[:, 0] / 2 * (1 + 2 / cells)
        x, y = (
            np.ascontiguousarray(((f - m) / r + 1) * cells / 2 - 0.5)
            for f, m, r in zip(slopes, middle, half, strict=True)
        )
        return cls(view, x, y, view.weights((float(half[0]), float(half[1]))))

    def transport(
        self,
        flux: Array,
        wanted: Array,
        rounds: int = MOST_ROUNDS,
        coarse: Transport | None = None,
    ) -> Transport:
        """Transport of the lens's flux to the light of each cell, where the chart has it."""
        wanted = push(wanted, self.x, self.y, _PARTS)
        return Transport(flux, wanted, self.weights, rounds, coarse)

    def places(self, transport: Transport) -> Pair:
        """Where on the receiver a transport brings light, in the receiver's coordinates."""
        return self.view.at(self._back(*transport.map()), len(self.x))

    def finer(self, halvings: int) -> Self:
        """The same with cells halved along each axis, so many times."""
        x, y = self.x, self.y
        for _ in range(halvings):
            x, y = (2 * doubled(f) + 0.5 for f in (x, y))
        return self._replace(x=x, y=y)

    def begins(self, transport: Transport) -> Pair:
        """In which cell of the lens the light of each cell of the view comes from."""
        x, y = transport.back()
        return between(x, (self.x, self.y)), between(y, (self.x, self.y))

    def _back(self, to_x: Array, to_y: Array) -> Pair:
        return whence((self.x, self.y), (to_x, to_y), (to_x, to_y))


def _along_seen(view: ReceiverView, wanted: Array, slopes_for: SlopesFor, begins: Pair) -> Pair:
    """Slopes less a gradient of the place on the lens, in the scale of the view's coordinates.

    What is left out is linear in the place, so that the rest differs as little as may be from the
    view's coordinates. It has to be a gradient exactly: the slopes that send all light to one place
    are none on a face that leans, and with these left out light on a screen beside a mirror missed
    its places by 0.7 % of the screen in place of 0.07 %.
    """
    from scipy.ndimage import gaussian_filter  # late: it takes long to import

    cells, half_width = len(wanted), view.scene.optic.half_width
    grid = view.grid(cells)
    needed = slopes_for(begins, view.at(grid, cells))
    scale = 0.0  # slopes for each step along the view's coordinates, from one place of the lens
    for axis, half in enumerate(view.half_extent):
        beside = grid[0] + (axis == 0), grid[1] + (axis == 1)
        more = slopes_for(begins, view.at(beside, cells))[axis] - needed[axis]
        scale += float((more * wanted).sum()) / (2 * half / cells) / 2
    x, y = (  # without a unit, so that what is left out does not depend on it
        ((2 * place + 1) / cells - 1) * (r / max(half_width))
        for place, r in zip(begins, half_width, strict=True)
    )
    seen, none, one = view.seen(cells), np.zeros_like(x), np.ones_like(x)
    gradients = np.array([[x, y, none, one, none], [none, x, y, none, one]])  # [2, 5, cells, cells]
    off = np.stack([s / scale - t for s, t in zip(needed, seen, strict=True)])
    share = np.sqrt(wanted)
    rows = np.moveaxis(gradients * share, 1, -1).reshape(-1, 5)
    parts = np.linalg.lstsq(rows, (off * share).ravel(), rcond=1e-6)[0]
    off -= np.einsum("k,akxy->axy", parts, gradients)
    along_x, along_y = (
        t + gaussian_filter(f, _SMOOTH, mode="nearest") for t, f in zip(seen, off, strict=True)
    )
    return along_x, along_y


class Rough(NamedTuple):
    """A lens of few cells."""

    chart: Chart | None  # None where the view does as well
    transport: Transport  # in the chart, or in the view
    heights: Array  # (n_u, n_v), control heights
    flux: Array  # of its exit face, in each cell; all together 1

    def transported(
        self, view: ReceiverView, flux: Array, wanted: Array, rounds: int
    ) -> tuple[Transport, Callable[[Transport], Pair]]:
        """Transport of more cells that begins with that of few.

        `flux` (cells, cells): that leaves the exit face; `wanted` (cells, cells): light in each
        cell of the view; all together 1; `rounds`: the most on the finest grid. Returns it, and
        what says where on the receiver it brings light, in the receiver's coordinates.
        """
        if self.chart is None:
            weights = view.weights(view.half_extent)
            return Transport(flux, wanted, weights, rounds, self.transport), view.places
        chart = self.chart.finer((len(wanted) // len(self.flux)).bit_length() - 1)
        return chart.transport(flux, wanted, rounds, self.transport), chart.places


def rough_lens(scene: Scene, net: ControlNet, wanted: Array, fits: int) -> Rough | None:
    """A lens of few cells, in a chart in which light misses its places least.

    `scene`: the design task; an extended source counts as a point at its centre; `net`: of the
    face; `wanted` (cells, cells): the light that is wanted in each cell of the view, which are
    those of the chart; all together 1; `fits`: fits to each transport. None if no light leaves the
    lens even where its faces are parallel.
    """
    while len(wanted) % 2 == 0 and len(wanted) >= 2 * _FEWEST:
        wanted = halved(wanted)
    most = int(len(wanted) / PER_CONTROL_POINT)
    m_x, m_y = (min(points, most) for points in net.shape)
    coarse = ControlNet((m_x, m_y), net.degree, net.half_width)
    faces = Faces(scene, coarse, len(wanted))
    begin = faces.begin()
    if begin is None:
        return None
    found = _straightest(faces, wanted, *begin, fits)
    return found._replace(heights=coarse.carry(found.heights, net))


def _straightest(faces: Faces, wanted: Array, heights: Array, flux: Array, fits: int) -> Rough:
    view, light = faces.view, faces.light
    transport = Transport(flux, wanted, view.weights(view.half_extent))
    for again in (False, True):
        if again:
            flux = light.flux_or(heights, flux)
            transport.improve(flux)
        to = view.places(transport)
        heights = faces.fitted(to, heights, fits)
    best, begins = Rough(None, transport, heights, flux), transport.back()
    least = faces.missed(to, heights)
    for _ in range(_CHARTS):
        chart = Chart.of(view, wanted, faces.slopes_for(heights), begins)
        transport = chart.transport(light.flux_or(heights, flux), wanted)
        begins, to = chart.begins(transport), chart.places(transport)
        heights = faces.fitted(to, heights, fits)
        before, missed = least, faces.missed(to, heights)
        if missed < least:
            best, least = Rough(chart, transport, heights, flux), missed
        if least < _NEAR or missed > _LESS * before:
            break
    return best
