"""Shifts of the nodes of a mesh against the curvature between them; and the adjoint.

Hits between nodes are interpolated linearly; see `workbench.optics.kernels.beam_image`.
"""

import numpy as np

from workbench.compiled import jit

# Hits further from the image than this, in pixels, stay there: nothing overflows.
FARTHEST = 1e7
_TWELFTH = 1 / 12
_ONE = np.uintp(1)


@jit(allocates=False, error_model="numpy", forceinline=True)
def _second_diff(before, here, after):  # type: ignore[no-untyped-def]
    """Second difference of hits; those of neighbours are exact in float32, too."""
    return (before - here) + (after - here)


@jit(allocates=False, error_model="numpy")
def shift(hits, along_u, i, inner, shifted):  # type: ignore[no-untyped-def]
    """Shift the hits of a row of nodes by a twelfth of their second differences.

    `hits` (n, m): columns or rows in which rays hit; infinite for those that never do; `along_u`
    (m, 3): see `workbench.optics.kernels.beam_cells.Mesh`; what ends a grid stays where it is, and
    so does what has a neighbour that hits nowhere or far away; `i`: which row; `inner`: whether it
    lies between two rows of cells of equal width; `shifted` (m,): the result; infinite or within
    ``FARTHEST``.
    """
    m, kind = np.uintp(hits.shape[1]), shifted.dtype.type
    zero, twelfth, far, here = kind(0), kind(_TWELFTH), kind(FARTHEST), hits[i]
    # Loops have no branches: the compiler makes vectors of them.
    if inner:
        before, after = hits[i - 1], hits[i + 1]
        for j in range(m):
            second_diff = _second_diff(before[j], here[j], after[j])
            shifted[j] = here[j] - (twelfth * second_diff if abs(second_diff) < far else zero)
    else:
        for j in range(m):
            shifted[j] = here[j]
    for j in range(_ONE, m - _ONE):
        second_diff = _second_diff(here[j - _ONE], here[j], here[j + _ONE])
        part = twelfth * kind(along_u[j, 2])
        shifted[j] -= part * second_diff if abs(second_diff) < far else zero
    for j in range(m):
        place = min(max(shifted[j], -far), far)
        shifted[j] = place if abs(here[j]) < np.inf else kind(np.inf)


@jit(allocates=False, error_model="numpy", forceinline=True)
def count_shift(hits, i, inner, moved, counts):  # type: ignore[no-untyped-def]
    """Cotangents of the second differences along v of a row of nodes; see `shift_back`."""
    kind = counts.dtype.type
    zero, twelfth, far = kind(0), kind(_TWELFTH), kind(FARTHEST)
    counts[:] = zero
    if not inner:
        return
    before, here, after = hits[i - 1], hits[i], hits[i + 1]
    for j in range(np.uintp(len(counts))):
        second_diff = _second_diff(before[j], here[j], after[j])
        counts[j] = -twelfth * moved[j] if abs(second_diff) < far else zero


@jit(allocates=False, error_model="numpy")
def shift_back(hits, along_u, i, moved, counts, along, result):  # type: ignore[no-untyped-def]
    """Adjoint of `shift` for a row of nodes.

    `hits`, `along_u`, `i`: see `shift`; `moved` (m,): cotangent of the shifted hits; changed;
    `counts`: of three rows (m,) what `count_shift` finds; `along` (m,): space for the same along u;
    `result` (m,): cotangent of the hits.
    """
    before, middle, behind = counts
    m, kind, here = np.uintp(hits.shape[1]), moved.dtype.type, hits[i]
    zero, two, twelfth, far = kind(0), kind(2), kind(_TWELFTH), kind(FARTHEST)
    along[0], along[m - _ONE] = zero, zero
    for j in range(_ONE, m - _ONE):
        second_diff = _second_diff(here[j - _ONE], here[j], here[j + _ONE])
        count = -twelfth * kind(along_u[j, 2]) * moved[j]
        along[j] = count if abs(second_diff) < far else zero
    for j in range(m):
        moved[j] += before[j] - two * middle[j] + behind[j] - two * along[j]
    for j in range(m - _ONE):
        moved[j] += along[j + _ONE]
    for j in range(_ONE, m):
        moved[j] += along[j - _ONE]
    for j in range(m):
        result[j] = moved[j] if abs(here[j]) < far else zero
