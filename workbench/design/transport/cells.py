"""Values and light of cells: between their middles, where a ray meets them, and in perspective.

Places are counted in cells from the middle of the first one. Beyond the middles of the outer cells
the nearest of these counts.
"""

import numpy as np

from workbench.arrays import Array
from workbench.compiled import jit
from workbench.optics.kernels import threads

Pair = tuple[Array, Array]
Vector = tuple[Array, Array, Array]

# Newton steps of a search, at most; the part of all cells that each goes at most; the least area
# of a cell there, as a part of what it was; and how near a search comes, in cells. So near that it
# matters to none whether one of two mirror images takes a step more: with 1e-3, first lenses of
# mirrored tasks were uneven by 1e-11, with 1e-8 they are by 2e-15, and first lenses take no longer.
_MOST_STEPS, _FAR, _LEAST_AREA, _NEAR = 40, 0.1, 1e-3, 1e-8
# The same of rays that meet a face; these steps are not halved.
_MOST_STEPS_OF_RAYS, _NEAR_FACE = 40, 0.01
# How fast a face is taken to fall away from a ray, for each height, at least: with less, Newton
# steps of light that comes steeply to a steep face do not settle.
_LEAST_FALL = 0.5


def between(values: Array, at: Pair) -> Array:
    """Values (m_0, m_1) of cells at places along both axes, linear between the middles of cells."""
    at_0, at_1 = (np.ascontiguousarray(place, np.float64) for place in at)
    found = np.empty_like(at_0)
    flat = at_0.ravel(), at_1.ravel(), found.ravel()
    values = np.ascontiguousarray(values, np.float64)  # other layouts would be compiled anew

    def work(begin: int, end: int) -> None:
        _between(values, *flat, begin, end)

    threads.run_lines(work, found.size, found.size)
    return found


def whence(values: Pair, wanted: Pair, begin: Pair) -> Pair:
    """Places where two values are as wanted, or as near to it as a search comes.

    Newton steps, halved where they lead no nearer: where an image is dark, faces spread light over
    many times the area that it comes from. `values` (m_0, m_1): where the cells go along both axes,
    in cells, neighbours stay neighbours; `wanted`, `begin`: what is searched for, and where each
    search begins, of the shape of the result.
    """
    to_0, to_1 = (np.ascontiguousarray(each, np.float64) for each in values)
    wanted_0, wanted_1 = (np.ascontiguousarray(each, np.float64) for each in wanted)
    at_0, at_1 = (np.array(each, np.float64, order="C") for each in begin)
    flat = wanted_0.ravel(), wanted_1.ravel(), at_0.ravel(), at_1.ravel()

    def work(begin: int, end: int) -> None:
        _whence(to_0, to_1, *flat, begin, end)

    threads.run_lines(work, at_0.size, at_0.size)
    return at_0, at_1


@jit(allocates=False)
def _between(values, at_0, at_1, found, begin, end):  # type: ignore[no-untyped-def]
    """The places from number ``begin`` to ``end``; see `between`."""
    m_0, m_1 = values.shape
    for k in range(begin, end):
        i, f = located(at_0[k], m_0)
        j, g = located(at_1[k], m_1)
        found[k] = mixed(values, i, f, j, g)


@jit(allocates=False)
def _whence(to_0, to_1, wanted_0, wanted_1, at_0, at_1, begin, end):  # type: ignore[no-untyped-def]
    """The places from number ``begin`` to ``end``; see `whence`."""
    m_0, m_1 = to_0.shape
    far_0, far_1 = _FAR * m_0, _FAR * m_1
    for k in range(begin, end):
        cell_0, cell_1 = at_0[k], at_1[k]
        least, step_0, step_1 = np.inf, 0.0, 0.0
        for _ in range(_MOST_STEPS):
            i, f = located(cell_0, m_0)
            j, g = located(cell_1, m_1)
            off_0 = mixed(to_0, i, f, j, g) - wanted_0[k]
            off_1 = mixed(to_1, i, f, j, g) - wanted_1[k]
            far = off_0**2 + off_1**2
            if far < least:
                least, at_0[k], at_1[k] = far, cell_0, cell_1
                if far < _NEAR**2:
                    break
                x_x, x_y = _slopes(to_0, i, f, j, g)
                y_x, y_y = _slopes(to_1, i, f, j, g)
                area = max(x_x * y_y - x_y * y_x, _LEAST_AREA)
                step_0 = min(max((y_y * off_0 - x_y * off_1) / area, -far_0), far_0)
                step_1 = min(max((x_x * off_1 - y_x * off_0) / area, -far_1), far_1)
            else:
                step_0, step_1 = step_0 / 2, step_1 / 2
            if max(abs(step_0), abs(step_1)) < _NEAR:
                break
            cell_0 = min(max(at_0[k] - step_0, -0.5), m_0 - 0.5)
            cell_1 = min(max(at_1[k] - step_1, -0.5), m_1 - 0.5)


@jit(allocates=False)
def located(place, count):  # type: ignore[no-untyped-def]
    """The cell before a place along an axis, and which part of the way to the next one it is."""
    inside = min(max(place, 0.0), count - 1.0)
    cell = min(int(inside), count - 2)
    return cell, inside - cell


@jit(allocates=False)
def mixed(values, i, f, j, g):  # type: ignore[no-untyped-def]
    """Value at parts f and g of the way from a cell to the next ones."""
    before = (1 - g) * values[i, j] + g * values[i, j + 1]
    behind = (1 - g) * values[i + 1, j] + g * values[i + 1, j + 1]
    return (1 - f) * before + f * behind


@jit(allocates=False)
def _slopes(values, i, f, j, g):  # type: ignore[no-untyped-def]
    """What a value changes by along both axes, as for `mixed`."""
    a, b, c, d = values[i, j], values[i, j + 1], values[i + 1, j], values[i + 1, j + 1]
    return (1 - g) * (c - a) + g * (d - b), (1 - f) * (b - a) + f * (d - c)


def met(face: Vector, cell: tuple[float, float], place: Pair, rise: Pair) -> Vector:
    """Where rays meet a face that is straight between the middles of even cells.

    `face` (m_0, m_1): its height, and its slopes along both axes, in the middles of cells; `cell`:
    widths of a cell, all cells together have their middle at 0; `place`, `rise` (n_0, n_1): where
    rays are at height 0, and how far they go for each height, along both axes. Returns height and
    slopes (n_0, n_1) where they meet it.
    """
    grids = [np.ascontiguousarray(part, np.float64) for part in face]
    x, y, a, b = (np.ascontiguousarray(part, np.float64) for part in (*place, *rise))
    found = np.empty_like(x), np.empty_like(x), np.empty_like(x)
    start = float(grids[0].mean())

    def work(begin: int, end: int) -> None:
        _met(*grids, *cell, x, y, a, b, start, *found, begin, end)

    threads.run_lines(work, len(x), x.size)
    return found


@jit(allocates=False)
def _met(  # type: ignore[no-untyped-def]
    z, z_x, z_y, width_0, width_1, x, y, a, b, start, height, slope_x, slope_y, begin, end
):
    """The rays of the lines from number ``begin`` to ``end``; see `met`."""
    m_0, m_1 = z.shape
    near = _NEAR_FACE * min(width_0, width_1)
    for k in range(begin, end):
        for n in range(x.shape[1]):
            at = start
            for _ in range(_MOST_STEPS_OF_RAYS):
                place_0 = (x[k, n] + a[k, n] * at) / width_0 + (m_0 - 1) / 2
                place_1 = (y[k, n] + b[k, n] * at) / width_1 + (m_1 - 1) / 2
                i, f = located(place_0, m_0)
                j, g = located(place_1, m_1)
                slope_x[k, n], slope_y[k, n] = mixed(z_x, i, f, j, g), mixed(z_y, i, f, j, g)
                fall = 1.0
                # Beyond the rim the face is level.
                if 0 <= place_0 <= m_0 - 1:
                    fall -= a[k, n] * slope_x[k, n]
                if 0 <= place_1 <= m_1 - 1:
                    fall -= b[k, n] * slope_y[k, n]
                step = (mixed(z, i, f, j, g) - at) / max(fall, _LEAST_FALL)
                at += step
                if abs(step) < near:
                    break
            height[k, n] = at


def in_perspective(image: Array, onto: Array, cells: int, samples: int) -> Array:
    """Light (cells, cells) of an image in the cells of a plane on which it is seen in perspective.

    `image` (n_0, n_1): the light of each pixel, beside them is none; `onto` (3, 3): takes (x, y, 1)
    of a place, in cells from the rim of the first one, to a multiple of (a, b, 1) of the same in
    pixels; `samples`: along each axis of a cell, they find its light.
    """
    light = np.empty((cells, cells))
    image, onto = (np.ascontiguousarray(each, np.float64) for each in (image, onto))
    area = abs(float(np.linalg.det(onto))) / samples**2

    def work(begin: int, end: int) -> None:
        _in_perspective(image, onto, area, samples, begin, end, light)

    threads.run_lines(work, cells, cells**2 * samples**2)
    return light


@jit(allocates=False)
def _in_perspective(image, onto, area, samples, begin, end, light):  # type: ignore[no-untyped-def]
    """The lines of cells from number ``begin`` to ``end``; see `in_perspective`."""
    n_0, n_1 = image.shape
    for k in range(begin, end):
        for n in range(light.shape[1]):
            light[k, n] = 0.0
            for i in range(samples):
                x = k + (i + 0.5) / samples
                for j in range(samples):
                    y = n + (j + 0.5) / samples
                    far = onto[2, 0] * x + onto[2, 1] * y + onto[2, 2]
                    a = (onto[0, 0] * x + onto[0, 1] * y + onto[0, 2]) / far
                    b = (onto[1, 0] * x + onto[1, 1] * y + onto[1, 2]) / far
                    if 0 <= a < n_0 and 0 <= b < n_1:
                        light[k, n] += image[int(a), int(b)] * area / abs(far) ** 3
