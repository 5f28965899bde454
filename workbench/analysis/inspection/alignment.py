"""Alignment of a measurement to a designed face: least squares of distances along the normal.

Each Gauss-Newton step solves for a small rotation, a shift and, if asked for, a growth. Points far
off, such as dust, get Tukey's weight of 0. A direction that the face does not determine, such as a
rotation about the axis of a sphere, stays as it is.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from workbench.analysis.inspection.placement import DesignedFace, Offsets, Placement
from workbench.analysis.inspection.starts import first_placements, relief, thinned
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.messages import Message

_STARTS, _FEW, _MANY = 8, 3000, 200_000  # placements and points of the search, points of the end
_STEPS, _CONVERGED = 60, 1e-10  # of the half-width
_TUKEY = 4.685 * 1.4826  # times the median of the absolute distances
_UNDETERMINED = 1e-13  # eigenvalue of the normalised equations
_BLOCKS = 4  # along x and y; errors within a block may hang together
_FARTHEST = 0.3  # of the face's relief that the points of a part may be off
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
        for end in [_descended(points, start, face, False)]
    ]
    true, mirrored = (
        [each for each in found if each[1].mirrored == which] for which in (False, True)
    )
    least, *_ = min(true, key=lambda each: each[0])
    best_mirrored = min(mirrored, key=lambda each: each[0])
    limit = _FARTHEST * relief(face.samples)
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
    end = _descended(points, start, face, with_scale)
    return Alignment(end, *_standard_errors(points, end, face, with_scale), patch)


def _descended(points: Array, start: Placement, face: DesignedFace, scaled: bool) -> Placement:
    placement, largest = start, max(face.net.half_width)
    for _ in range(_STEPS):
        there = placement.applied(points)
        found = face.offsets(there)
        if found.inside.sum() < len(points) / 20:
            break
        weights, rows, centre = _equations(there, found, scaled)
        normal, right = rows.T @ (weights[:, None] * rows), rows.T @ (weights * found.distance)
        step = -_solved(normal, right)
        # Linearised slopes hold nearby only.
        step *= min(1.0, 0.2 * largest / max(float(np.abs(step[3:6]).max()), 1e-300))
        step *= min(1.0, 0.2 / max(float(np.abs(step[:3]).max()), 1e-300))
        placement = placement.moved(centre, step[:3], step[3:6], *step[6:])
        if np.abs(step[:3]).max() * largest + np.abs(step[3:6]).max() < _CONVERGED * largest:
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


def _solved(normal: Array, right: Array) -> Array:
    inverse, _ = _inverse(normal)
    return inverse @ right


def _inverse(normal: Array) -> tuple[Array, Array]:
    """Pseudo-inverse, and which unknowns (k,) the equations leave open."""
    size = np.sqrt(np.diag(normal).clip(1e-300))
    values, vectors = np.linalg.eigh(normal / np.outer(size, size))
    open_ = values < _UNDETERMINED * values[-1]
    kept = vectors[:, ~open_]
    inverse = (kept / values[~open_]) @ kept.T / np.outer(size, size)
    return inverse, (vectors[:, open_] ** 2).sum(axis=1) > 1e-6


def _standard_errors(
    points: Array, placement: Placement, face: DesignedFace, scaled: bool
) -> tuple[Array, Array, float | None]:
    """Errors from sums over blocks of the face: form errors hang together over some distance."""
    there = placement.applied(points)
    found = face.offsets(there)
    weights, rows, _ = _equations(there, found, scaled)
    inverse, undetermined = _inverse(rows.T @ (weights[:, None] * rows))
    block = np.zeros(len(rows), dtype=np.intp)
    for axis, r in enumerate(face.net.half_width):
        place = (there[found.inside, axis] / r + 1) / 2 * _BLOCKS
        block = block * _BLOCKS + place.astype(np.intp).clip(0, _BLOCKS - 1)
    gradient = rows * (weights * found.distance)[:, None]
    sums = np.stack(
        [np.bincount(block, column, minlength=_BLOCKS**2) for column in gradient.T], axis=1
    )
    errors = np.sqrt(np.diag(inverse @ (sums.T @ sums) @ inverse).clip(0))
    errors[undetermined] = np.inf
    return np.degrees(errors[:3]), errors[3:6], float(errors[6]) if scaled else None


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
