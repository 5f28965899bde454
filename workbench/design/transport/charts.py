"""The chart of a task, found by lenses of few cells.

How light misses its places changes slowly from one cell to the next. A chart of 216 cells along
each axis, made of three transports and fits, takes 0.1 to 0.2 s of the processor, and the first
lens of 864 cells needs no other one. It begins with the lens of these few cells.
"""

from typing import NamedTuple

from workbench.arrays import Array
from workbench.design.transport.back_and_forth import Transport
from workbench.design.transport.chart import Chart
from workbench.design.transport.grids import PER_CONTROL_POINT, Grids
from workbench.design.transport.halves import halved
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene

# Cells along each axis are halved as long as so many are left.
_FEWEST = 128
# Light that misses its places by more than this part of the receiver's width, where no net is too
# coarse for them, needs another chart: a flame misses them by 0.0003. Then so many are tried, as
# long as it misses them by more than the second number, and by less than this part of before.
_STRAIGHT, _NEAR, _CHARTS, _LESS = 0.001, 2e-4, 6, 0.8


class Charted(NamedTuple):
    """A chart and a lens found in it."""

    chart: Chart  # with as many cells as light is wanted in
    heights: Array  # (n_u, n_v), control heights of the lens, which few cells have found


def chart_of(scene: Scene, net: ControlNet, wanted: Array, fits: int) -> Charted | None:
    """A chart in which light misses its places least; None where the view does as well.

    `scene`: the design task; an extended source counts as a point at its centre; `net`: of the
    face; `wanted` (cells, cells): the light that is wanted in each cell of the view, which are
    those of the chart; all together 1; `fits`: fits to each transport.
    """
    halvings = 0
    while len(wanted) % 2 == 0 and len(wanted) >= 2 * _FEWEST:
        wanted, halvings = halved(wanted), halvings + 1
    most = int(len(wanted) / PER_CONTROL_POINT)
    m_x, m_y = (min(points, most) for points in net.shape)
    coarse = ControlNet((m_x, m_y), net.degree, net.half_width)
    grids = Grids.of(scene, coarse, wanted)
    begin = grids.begin()
    if begin is None:
        return None
    found = _straightest(grids, *begin, fits)
    if found is None:
        return None
    chart, heights = found
    return Charted(chart.finer(halvings), coarse.carry(heights, net))


def _straightest(grids: Grids, heights: Array, flux: Array, fits: int) -> Charted | None:
    """The chart of some grids and the lens found in it."""
    view, faces, light, wanted = grids.view, grids.faces, grids.light, grids.wanted
    transport = Transport(flux, wanted, view.weights(view.half_extent))
    for again in (False, True):
        if again:
            flux = light.flux_or(heights, flux)
            transport.improve(flux)
        to = view.places(transport)
        heights = faces.fitted(to, heights, fits)
    best, least, begins = None, faces.missed(to, heights), transport.back()
    if least < _STRAIGHT:
        return None
    for _ in range(_CHARTS):
        chart = Chart.of(view, wanted, faces.slopes_for(heights), begins)
        transport = chart.transport(light.flux_or(heights, flux), wanted)
        begins, to = chart.begins(transport), chart.places(transport)
        heights = faces.fitted(to, heights, fits)
        before, missed = least, faces.missed(to, heights)
        if missed < least:
            best, least = Charted(chart, heights), missed
        if least < _NEAR or missed > _LESS * before:
            break
    return best
