"""Shift and turn of a measurement in the plane of its face, by the fine relief of the face alone.

A long form error, such as astigmatism, resembles the change of height when a face is shifted, and a
plain fit takes a part of it for a shift. So all that a coarse net can hold is left out here, of the
residual and of its derivatives: what remains is fine relief, which no form error resembles. Tilt
and height follow from the mean plane of the residual.
"""

import numpy as np

from workbench.analysis.inspection.alignment import Alignment, block_errors, solved
from workbench.analysis.inspection.fit import Cells, Fit
from workbench.analysis.inspection.placement import DesignedFace
from workbench.analysis.inspection.residual import points_on
from workbench.arrays import Array
from workbench.geometry.surface import ControlNet

_ROUNDS = 2
_BLOCKS = 8  # along x and y, for standard errors


def by_relief(found: Alignment, face: DesignedFace, net: ControlNet) -> Alignment:
    """Return an alignment with the shift, the turn and the scale of the relief finer than ``net``.

    The alignment is returned unchanged where the fine relief determines them less well.
    """
    placement, scaled = found.placement, found.scale_error is not None
    for _ in range(_ROUNDS):
        cells = Cells.of(points_on(face, placement, found.patch).offsets, net.half_width)
        x, y, heights = cells.points.T
        z, slope_x, slope_y = face.net.at(x, y, face.heights)
        centre = np.average(np.column_stack([x, y, z]), axis=0, weights=cells.weights)
        x, y, z = x - centre[0], y - centre[1], z - centre[2]
        rows = [-slope_x, -slope_y, slope_x * y - slope_y * x]
        if scaled:
            rows.append(z - slope_x * x - slope_y * y)
        columns = np.column_stack(rows)
        fine = Fit(net, cells).rest(np.column_stack([columns, heights]))
        columns_left, left = fine[:, :-1], fine[:, -1]
        step = -solved(columns_left, cells.weights, left)
        plane = np.column_stack([np.ones_like(x), y, -x])
        rise, turn_x, turn_y = -solved(plane, cells.weights, heights + columns @ step)
        shift, turn = np.array([*step[:2], rise]), np.array([turn_x, turn_y, step[2]])
        placement = placement.moved(centre, turn, shift, *step[3:])
    left = left + columns_left @ step
    errors = block_errors(cells.points, columns_left, cells.weights, left, face, _BLOCKS)
    if not _at_rim(errors[:2], errors[2], face) < _at_rim(
        found.shift_error[:2], np.radians(found.turn_error[2]), face
    ):
        return found
    return found._replace(
        placement=placement,
        turn_error=np.array([*found.turn_error[:2], np.degrees(errors[2])]),
        shift_error=np.array([*errors[:2], found.shift_error[2]]),
        scale_error=float(errors[3]) if scaled else None,
    )


def _at_rim(shift: Array, turn: float, face: DesignedFace) -> float:
    """Standard error of the place of the face's rim."""
    return float(np.hypot(np.linalg.norm(shift), max(face.net.half_width) * turn))
