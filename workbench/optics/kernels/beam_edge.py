"""What an edge of a beam, or a triangle of nearly no width, adds to pixels; and the adjoint.

Most edges are in one to three pixels and need no loop. Of a longer edge wholly on the image, the
pixels at both ends give the number of crossings, so its loop has no branch but its end. This saves
a fifth where such edges are many. See `workbench.optics.kernels.beam_raster`.
"""

import numpy as np

from workbench.compiled import jit

# A triangle is a sliver if its area is at most this times its length, in pixels, and times the
# length again if that is more than a pixel. The density of a sliver has few digits, and its
# gradient fewer. So a sliver is drawn as the mean of two triangles, with one corner moved four
# times as far to either side; the image is exact to the square of this distance. With all light of
# a sliver in one pixel, pixels jumped by 1e-4 of the norm of the image where beams fold over.
SLIVER = 1e-5
_ONE = np.uintp(1)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _clip(start, way, last):  # type: ignore[no-untyped-def]
    """Parts of an edge between which it is on rows of the image."""
    if min(start, start + way) >= 0.0 and max(start, start + way) < last:
        return 0.0, 1.0
    if way == 0.0:
        return 1.0, 0.0
    first, second = -start / way, (last - start) / way
    return max(min(first, second), 0.0), min(max(first, second), 1.0)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _pixel(place, way, last):  # type: ignore[no-untyped-def]
    """Column that an edge enters at a place; −1 and ``last`` for all beside the image."""
    entered = np.floor(place) if way >= 0.0 else np.ceil(place) - 1.0
    return int(min(max(entered, -1.0), last))


@jit(allocates=False, error_model="numpy", forceinline=True)
def _leaves(pixel, start, way, last):  # type: ignore[no-untyped-def]
    """Part of an edge at which it leaves a column."""
    if way > 0.0:
        return (pixel + 1 - start) / way if pixel < last else np.inf
    if way < 0.0:
        return (pixel - start) / way if pixel >= 0 else np.inf
    return np.inf


@jit(allocates=False, error_model="numpy", forceinline=True)
def _crossings(x, y, d_x, d_y, j, i, to_j, to_i):  # type: ignore[no-untyped-def]
    """Where an edge between neighbouring pixels leaves the first, and where it enters the last."""
    at_x = (max(j, to_j) - x) / d_x if j != to_j else 1.0
    at_y = (max(i, to_i) - y) / d_y if i != to_i else 1.0
    if at_x < at_y:
        return at_x, at_y, np.uintp(i), np.uintp(to_j)
    return at_y, at_x, np.uintp(to_i), np.uintp(j)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _first(start, way, pixel, last):  # type: ignore[no-untyped-def]
    """Where an edge leaves its first pixel along an axis, and how far it is from there to the next.

    Both as parts of the edge; infinite is the first one if the edge never leaves that pixel.
    """
    each = 1.0 / way
    ahead = 1.0 if way > 0.0 else 0.0
    leaves = (np.float64(pixel) + ahead - start) * each
    return leaves if pixel != last else np.inf, abs(each)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _cross(pixel, last, leaves, each, crosses):  # type: ignore[no-untyped-def]
    """The pixel of an edge along an axis, the next one if it crosses, and where the edge leaves it.

    Without branches: no processor foresees which axis it is.
    """
    one = 1 if last > pixel else -1
    pixel += one if crosses else 0
    leaves += each if crosses else 0.0
    return pixel, leaves if pixel != last else np.inf


@jit(allocates=False, error_model="numpy", forceinline=True)
def _enter(x, y, d_x, d_y, n_x, n_y):  # type: ignore[no-untyped-def]
    """Where an edge enters the rows of the image, and where it leaves them or ends."""
    t, end = _clip(y, d_y, n_y)
    column = _pixel(x + d_x * t, d_x, n_x)
    i = min(max(_pixel(y + d_y * t, d_y, n_y), 0), n_y - 1)
    return t, end, column, i, _leaves(column, x, d_x, n_x), _leaves(i, y, d_y, n_y)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _go_on(column, i, leaves_x, leaves_y, x, y, d_x, d_y, n_x, n_y):  # type: ignore[no-untyped-def]
    """The next pixel of an edge, and the parts of its way at which it leaves column and row."""
    if leaves_x <= leaves_y:
        column += 1 if d_x > 0.0 else -1
        return column, i, _leaves(column, x, d_x, n_x), leaves_y
    i += 1 if d_y > 0.0 else -1
    return column, i, leaves_x, _leaves(i, y, d_y, n_y)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _add_piece(begin, end, x, d_x, flow, i, j, steps):  # type: ignore[no-untyped-def]
    """Add what crosses a piece of an edge, which is in one pixel."""
    light = (end - begin) * flow
    beyond = light * (x + 0.5 * (begin + end) * d_x - np.float64(j))
    steps[i, j] += light - beyond
    steps[i, j + _ONE] += beyond


@jit(allocates=False, error_model="numpy", forceinline=True)
def _add_long(x, y, d_x, d_y, first_j, first_k, to_j, to_k, flow, steps):  # type: ignore[no-untyped-def]
    """Add what crosses an edge over many pixels, from the first to the last of them."""
    j, k, begin = np.int64(first_j), np.int64(first_k), 0.0
    leaves_x, each_x = _first(x, d_x, j, to_j)
    leaves_y, each_y = _first(y, d_y, k, to_k)
    for _ in range(abs(to_j - j) + abs(to_k - k)):
        end = min(leaves_x, leaves_y, 1.0)
        _add_piece(begin, end, x, d_x, flow, np.uintp(k), np.uintp(j), steps)
        begin, by_x = end, leaves_x <= leaves_y
        j, leaves_x = _cross(j, to_j, leaves_x, each_x, by_x)
        k, leaves_y = _cross(k, to_k, leaves_y, each_y, not by_x)
    _add_piece(begin, 1.0, x, d_x, flow, np.uintp(k), np.uintp(j), steps)


@jit(allocates=False, error_model="numpy", forceinline=True)
def add_edge(x, y, to_x, to_y, jump, steps):  # type: ignore[no-untyped-def]
    """Add what crosses an edge to ``steps``: what a pixel has more than its left neighbour."""
    n_y, n_x = steps.shape[0], steps.shape[1] - 1
    d_x, d_y = to_x - x, to_y - y
    if jump == 0.0 or d_y == 0.0:
        return
    if min(x, to_x) >= 0.0 and max(x, to_x) < n_x and min(y, to_y) >= 0.0 and max(y, to_y) < n_y:
        j, k, to_j, to_k = np.int32(x), np.int32(y), np.int32(to_x), np.int32(to_y)
        if j == to_j and k == to_k:  # most edges are in one pixel
            _add_piece(0.0, 1.0, x, d_x, d_y * jump, np.uintp(k), np.uintp(j), steps)
            return
        if abs(j - to_j) <= 1 and abs(k - to_k) <= 1:  # most others are in two or three
            out, last, a, b = _crossings(x, y, d_x, d_y, j, k, to_j, to_k)
            flow = d_y * jump
            _add_piece(0.0, out, x, d_x, flow, np.uintp(k), np.uintp(j), steps)
            _add_piece(out, last, x, d_x, flow, a, b, steps)
            if last < 1.0:
                _add_piece(last, 1.0, x, d_x, flow, np.uintp(to_k), np.uintp(to_j), steps)
            return
        _add_long(x, y, d_x, d_y, j, k, to_j, to_k, d_y * jump, steps)
        return
    t, end, column, i, leaves_x, leaves_y = _enter(x, y, d_x, d_y, n_x, n_y)
    while t < end and 0 <= i < n_y:
        until = min(leaves_x, leaves_y, end)
        if column < 0:
            steps[i, 0] += (until - t) * d_y * jump
        elif column < n_x:
            _add_piece(t, until, x, d_x, d_y * jump, np.uintp(i), np.uintp(column), steps)
        t = until
        column, i, leaves_x, leaves_y = _go_on(
            column, i, leaves_x, leaves_y, x, y, d_x, d_y, n_x, n_y
        )


@jit(allocates=False, error_model="numpy", forceinline=True)
def _see_piece(begin, end, x, d_x, i, j, cotangent, right):  # type: ignore[no-untyped-def]
    """Integrals along a piece of an edge, which is in one pixel; see `see_edge`."""
    length, middle, here = end - begin, 0.5 * (begin + end), cotangent[i, j]
    ahead = np.float64(j) + 1.0 - (x + middle * d_x)
    lit = length * here
    later = middle * lit
    return length * right[i, j + _ONE] + lit * ahead, lit - later, later


@jit(allocates=False, error_model="numpy", forceinline=True)
def _see_long(x, y, d_x, d_y, first_j, first_k, to_j, to_k, cotangent, right):  # type: ignore[no-untyped-def]
    """Integrals along an edge over many pixels; see `see_edge`."""
    j, k, begin = np.int64(first_j), np.int64(first_k), 0.0
    beside, from_start, to_end = 0.0, 0.0, 0.0
    leaves_x, each_x = _first(x, d_x, j, to_j)
    leaves_y, each_y = _first(y, d_y, k, to_k)
    for _ in range(abs(to_j - j) + abs(to_k - k)):
        end = min(leaves_x, leaves_y, 1.0)
        more, start, rest = _see_piece(
            begin, end, x, d_x, np.uintp(k), np.uintp(j), cotangent, right
        )
        beside, from_start, to_end = beside + more, from_start + start, to_end + rest
        begin, by_x = end, leaves_x <= leaves_y
        j, leaves_x = _cross(j, to_j, leaves_x, each_x, by_x)
        k, leaves_y = _cross(k, to_k, leaves_y, each_y, not by_x)
    more, start, rest = _see_piece(begin, 1.0, x, d_x, np.uintp(k), np.uintp(j), cotangent, right)
    return beside + more, from_start + start, to_end + rest


@jit(allocates=False, error_model="numpy", forceinline=True)
def see_edge(x, y, to_x, to_y, cotangent, right):  # type: ignore[no-untyped-def]
    """Integrals of a cotangent of the image along an edge.

    Returns of what lies to the right of the edge, by y; of what lies on it, by the part of the way
    that is left to the end, and from the start.
    """
    n_y, n_x = cotangent.shape
    d_x, d_y = to_x - x, to_y - y
    if min(x, to_x) >= 0.0 and max(x, to_x) < n_x and min(y, to_y) >= 0.0 and max(y, to_y) < n_y:
        j, k, to_j, to_k = np.int32(x), np.int32(y), np.int32(to_x), np.int32(to_y)
        if j == to_j and k == to_k:  # most edges are in one pixel
            beside, from_start, to_end = _see_piece(
                0.0, 1.0, x, d_x, np.uintp(k), np.uintp(j), cotangent, right
            )
            return beside * d_y, from_start, to_end
        if abs(j - to_j) <= 1 and abs(k - to_k) <= 1:  # most others are in two or three
            out, last, a, b = _crossings(x, y, d_x, d_y, j, k, to_j, to_k)
            beside, from_start, to_end = _see_piece(
                0.0, out, x, d_x, np.uintp(k), np.uintp(j), cotangent, right
            )
            more, start, end = _see_piece(out, last, x, d_x, a, b, cotangent, right)
            beside, from_start, to_end = beside + more, from_start + start, to_end + end
            if last < 1.0:
                more, start, end = _see_piece(
                    last, 1.0, x, d_x, np.uintp(to_k), np.uintp(to_j), cotangent, right
                )
                beside, from_start, to_end = beside + more, from_start + start, to_end + end
            return beside * d_y, from_start, to_end
        beside, from_start, to_end = _see_long(x, y, d_x, d_y, j, k, to_j, to_k, cotangent, right)
        return beside * d_y, from_start, to_end
    beside, from_start, to_end = 0.0, 0.0, 0.0
    t, end, column, i, leaves_x, leaves_y = _enter(x, y, d_x, d_y, n_x, n_y)
    while t < end and 0 <= i < n_y:
        until = min(leaves_x, leaves_y, end)
        if column < 0:
            beside += (until - t) * right[i, 0]
        elif column < n_x:
            more, start, rest = _see_piece(
                t, until, x, d_x, np.uintp(i), np.uintp(column), cotangent, right
            )
            beside, from_start, to_end = beside + more, from_start + start, to_end + rest
        t = until
        column, i, leaves_x, leaves_y = _go_on(
            column, i, leaves_x, leaves_y, x, y, d_x, d_y, n_x, n_y
        )
    return beside * d_y, from_start, to_end


@jit(allocates=False, error_model="numpy", forceinline=True)
def _length(x_1, y_1, x_2, y_2):  # type: ignore[no-untyped-def]
    """Length of a triangle along columns or rows, by two sides from one corner."""
    return max(abs(x_1), abs(y_1), abs(x_2), abs(y_2))


@jit(allocates=False, error_model="numpy", forceinline=True)
def is_sliver(x_1, y_1, x_2, y_2, area):  # type: ignore[no-untyped-def]
    """Whether a triangle, given by two of its sides, is too narrow to have a density."""
    length = _length(x_1, y_1, x_2, y_2)
    return abs(area) <= SLIVER * length * max(length, 1.0)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _widened(x_1, y_1, x_2, y_2, side):  # type: ignore[no-untyped-def]
    """Two sides of a sliver with a corner moved to one side of it, and its area; see `SLIVER`."""
    length = _length(x_1, y_1, x_2, y_2)
    if length < SLIVER:  # a point
        length, x_1, y_1, x_2, y_2 = SLIVER, SLIVER, 0.0, 0.0, 0.0
    part = side * 4.0 * SLIVER * max(1.0, 1.0 / length)
    if x_1 * x_1 + y_1 * y_1 >= x_2 * x_2 + y_2 * y_2:
        x_2, y_2 = x_2 - part * y_1, y_2 + part * x_1
    else:
        x_1, y_1 = x_1 + part * y_2, y_1 - part * x_2
    return x_1, y_1, x_2, y_2, 0.5 * (x_1 * y_2 - x_2 * y_1)


@jit(allocates=False, error_model="numpy")
def add_sliver(x, y, x_1, y_1, x_2, y_2, flux, steps):  # type: ignore[no-untyped-def]
    """Add the light of a sliver, given by a corner and two sides, to ``steps``."""
    for side in (-1.0, 1.0):
        to_x, to_y, on_x, on_y, area = _widened(x_1, y_1, x_2, y_2, side)
        xs, ys = (x, x + to_x, x + on_x), (y, y + to_y, y + on_y)
        for k in range(3):
            b = (k + 1) % 3
            add_edge(xs[k], ys[k], xs[b], ys[b], 0.5 * flux / area, steps)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _by_sides(one, two, first, second, third, density, d_area):  # type: ignore[no-untyped-def]
    """Cotangents of the corners of a triangle along one axis, by its sides along the other."""
    between = two - one
    return (
        density * (one * first[1] - two * third[2]) + d_area * -between,
        density * (one * first[2] + between * second[1]) + d_area * two,
        density * (between * second[2] - two * third[1]) - d_area * one,
    )


@jit(allocates=False, error_model="numpy")
def see_sliver(x, y, x_1, y_1, x_2, y_2, flux, cotangent, right):  # type: ignore[no-untyped-def]
    """Adjoint of `add_sliver`: cotangents of columns and rows of the corners, and of the flux."""
    d_x, d_y, d_flux = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0
    for side in (-1.0, 1.0):
        one_x, one_y, two_x, two_y, area = _widened(x_1, y_1, x_2, y_2, side)
        b_x, b_y, c_x, c_y = x + one_x, y + one_y, x + two_x, y + two_y
        first = see_edge(x, y, b_x, b_y, cotangent, right)
        second = see_edge(b_x, b_y, c_x, c_y, cotangent, right)
        third = see_edge(c_x, c_y, x, y, cotangent, right)
        mean, density = -(first[0] + second[0] + third[0]) / area, 0.5 * flux / area
        ends, d_area = (first, second, third), -0.5 * density * mean
        by_x = _by_sides(one_y, two_y, *ends, density, d_area)
        by_y = _by_sides(one_x, two_x, *ends, density, d_area)
        d_x = d_x[0] + by_x[0], d_x[1] + by_x[1], d_x[2] + by_x[2]
        d_y = d_y[0] - by_y[0], d_y[1] - by_y[1], d_y[2] - by_y[2]
        d_flux += 0.5 * mean
    return d_x, d_y, d_flux
