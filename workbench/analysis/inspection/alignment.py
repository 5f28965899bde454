"""Alignment of a measurement to a designed face: least squares of distances along the normal.

Each Gauss-Newton step solves for a small rotation, a shift and, if asked for, a growth. Points far
off, such as dust, get Tukey's weight of 0. A direction that the face does not determine, such as a
rotation about the axis of a sphere, stays as it is.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from workbench.analysis.inspection.fit import cells_of
from workbench.analysis.inspection.placement import DesignedFace, Offsets, Placement
from workbench.analysis.inspection.starts import first_placements, relief, thinned
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message

_STARTS, _FEW, _MANY = 6, 1000, 50_000  # placements and points of the search, points of the end
# Most steps, and by how much the last ones move the points, in half-widths; the longest step.
_STEPS, _NEAR, _CONVERGED, _LONGEST = 60, 1e-3, 1e-9, 0.2
_TUKEY = 4.685 * 1.4826  # times the median of the absolute distances
_UNDETERMINED, _ROUNDING = 1e-13, 1e-7  # eigenvalue of the normalised equations; size of a column
_BLOCKS = 4  # along x and y; errors within a block may hang together
# How far points may be off, in parts of the relief; beside a flat face, in half-widths.
_FARTHEST, _FLAT = 0.3, 1e-4
_ALIKE = 1.1  # placements of a symmetric face differ by less than this factor
_MIRRORED = 0.5  # a mirror image fits better by this factor


class Alignment(NamedTuple):
    """Where a measurement stands, with standard errors."""

    placement: Placement
    # Rotation vector in degrees (3,), shift of the middle of the points (3,), and growth, if asked
    # for; infinite where the face does not determine it.
    turn_error: Array
    shift_error: Array
    scale_error: float | None
    patch: Array  # (n, 3), points of the part of the file that the face is compared with


def aligned(
    patches: Sequence[Array], face: DesignedFace, file: str, with_scale: bool = False
) -> Alignment:
    """Align the patch of points (n, 3) that fits a face best, in the unit of the face.

    Raise Refused, with ``file``, if none fits, or if a mirror image of it does.
    """
    found = [
        (_rms(points, end, face), end, patch)
        for patch in patches
        for points in [thinned(patch, _FEW)]
        for start in first_placements(points, face, _STARTS)
        for end in [_descended(points, start, face, _NEAR)]
    ]
    true, mirrored = (
        [each for each in found if each[1].mirrored == which] for which in (False, True)
    )
    least, *_ = min(true, key=lambda each: each[0])
    best_mirrored = min(mirrored, key=lambda each: each[0])
    limit = max(_FARTHEST * relief(face.samples), _FLAT * max(face.net.half_width))
    if best_mirrored[0] < min(_MIRRORED * least, limit):
        raise Refused(file, _mirrored(best_mirrored[1]))
    if not least < limit:
        raise Refused(
            file,
            Message(
                "its points do not fit {face}: they are off by {off:.3g} and the relief of the "
                "face is {relief:.3g}; check the part, the face and the unit",
                face=face.name,
                off=least,
                relief=relief(face.samples),
            ),
        )
    # A symmetric face fits in several places: the one with the least turn is taken.
    alike = [each for each in true if each[0] <= _ALIKE * least]
    _, start, patch = min(alike, key=lambda each: float(np.linalg.norm(each[1].rotation_vector)))
    points = thinned(patch, _MANY)
    end = _descended(points, start, face, _CONVERGED, with_scale)
    there = end.applied(points)
    beside = face.offsets(there)
    weights, rows, _ = _equations(there, beside, with_scale)
    inside = there[beside.inside]
    errors = block_errors(inside, rows, weights, beside.distance, face, _BLOCKS)
    scale_error = float(errors[6]) if with_scale else None
    return Alignment(end, np.degrees(errors[:3]), errors[3:6], scale_error, patch)


def _descended(
    points: Array, start: Placement, face: DesignedFace, converged: float, scaled: bool = False
) -> Placement:
    placement, largest = start, max(face.net.half_width)
    for _ in range(_STEPS):
        there = placement.applied(points)
        found = face.offsets(there)
        if found.inside.sum() < len(points) / 20:
            break
        weights, rows, centre = _equations(there, found, scaled)
        step = -solved(rows, weights, found.distance)
        # Slopes hold nearby only.
        far = max(np.abs(step[3:6]).max() / largest, np.abs(step[:3]).max())
        step *= min(1.0, _LONGEST / max(far, 1e-300))
        placement = placement.moved(centre, step[:3], step[3:6], *step[6:])
        if far < converged:
            break
    return placement


def _equations(there: Array, found: Offsets, scaled: bool) -> tuple[Array, Array, Array]:
    """Weights (m,), derivatives (m, 6 or 7) of the distances, and the centre of the points."""
    inside = there[found.inside]
    centre = inside.mean(axis=0)
    arm = inside - centre
    columns = [np.cross(arm, found.normals), found.normals]
    if scaled:
        columns.append((arm * found.normals).sum(axis=1)[:, None])
    typical = _TUKEY * float(np.median(np.abs(found.distance)))
    weights = np.clip(1 - (found.distance / max(typical, 1e-300)) ** 2, 0, None) ** 2
    return weights, np.concatenate(columns, axis=1), centre


def solved(rows: Array, weights: Array, values: Array) -> Array:
    """Return the weighted least squares solution (k,); 0 where the rows (m, k) leave it open."""
    inverse, _ = _inverse(rows.T @ (weights[:, None] * rows))
    return inverse @ (rows.T @ (weights * values))


def _inverse(normal: Array) -> tuple[Array, Array]:
    """Pseudo-inverse, and which unknowns (k,) the equations leave open."""
    size = np.sqrt(np.diag(normal))
    size = size.clip(max(_ROUNDING * float(size.max()), 1e-300))
    values, vectors = np.linalg.eigh(normal / np.outer(size, size))
    open_ = values < _UNDETERMINED * values[-1]
    kept = vectors[:, ~open_]
    inverse = (kept / values[~open_]) @ kept.T / np.outer(size, size)
    return inverse, (vectors[:, open_] ** 2).sum(axis=1) > _UNDETERMINED


def block_errors(
    points: Array, rows: Array, weights: Array, left: Array, face: DesignedFace, blocks: int
) -> Array:
    """Return standard errors (k,) of a solution, from sums over blocks of the face.

    What is ``left`` (m,) at neighbouring ``points`` (m, 2 or 3) hangs together; blocks do not.
    Infinite where the rows (m, k) leave an unknown open.
    """
    block = cells_of(points, face.net.half_width, (blocks, blocks))
    gradient = rows * (weights * left)[:, None]
    sums = np.stack([np.bincount(block, each, minlength=blocks**2) for each in gradient.T], axis=1)
    inverse, undetermined = _inverse(rows.T @ (weights[:, None] * rows))
    errors = np.sqrt(np.diag(inverse @ (sums.T @ sums) @ inverse).clip(0))
    errors[undetermined] = np.inf
    return np.asarray(errors)


def _rms(points: Array, placement: Placement, face: DesignedFace) -> float:
    """RMS of the distances of the points within the outline; robust, and infinite for few."""
    found = face.offsets(placement.applied(points))
    if found.inside.sum() < len(points) / 2:
        return np.inf
    return 1.4826 * float(np.median(np.abs(found.distance)))


def _mirrored(placement: Placement) -> Message:
    if placement.rotation[2, 2] < 0:
        return Message("it is a mirror image of the face: reverse the sign of its heights")
    return Message("it is a mirror image of the face: reverse the sign of its x")
