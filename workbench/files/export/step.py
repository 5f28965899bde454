"""STEP (ISO 10303-21, AP214): the lens as one solid with exact B-spline faces.

Four sides and a flat entrance face are planes, bounded by straight lines and by the B-spline curves
at the rims of freeform faces. Nothing is fitted or rounded. The wall of an elliptic lens is an
extruded ellipse, in four quarters; there the rim of a freeform face is fitted, as no B-spline curve
lies on both face and wall, and the error is reported. A single face is written as an open sheet.
"""

from collections.abc import Callable, Sequence
from typing import BinaryIO, NamedTuple

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline

from workbench.arrays import Array
from workbench.files.export.design import Design, Deviation
from workbench.files.export.step_model import (
    Model,
    Side,
    Skin,
    around,
    closed_solid,
    ellipse,
    elliptic_wall,
    real,
    spline_curve,
    spline_surface,
    write_shapes,
)

# Least and most pieces of a quarter of the rim.
_FEWEST, _MOST = 64, 4096
_DEGREE = 3
# Points closer than this part of the half-width count as one.
_TOLERANCE = 1e-8
BREP, _SURFACE = "ADVANCED_BREP", "MANIFOLD_SURFACE"  # kinds of shapes
# Corners of the lens, counterclockwise as seen from above; side k goes from corner k to k + 1.
_CORNERS = ((0, 0), (-1, 0), (-1, -1), (0, -1))
_OUTWARD = ((0, -1, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0))
_ALONG = ((1, 0, 0), (0, 1, 0), (1, 0, 0), (0, 1, 0))  # rising coordinate of each side
_RISING = (True, True, False, False)  # whether that is counterclockwise


class Rim(NamedTuple):
    """Curves along the quarters of the rim of an elliptic face, counterclockwise from +x.

    ``quarters`` are cubic splines from 0 to 1 with values (3,) in scene units, with ends on the
    axes. ``off`` is their largest distance from face and wall.
    """

    quarters: tuple[BSpline, ...]
    off: float

    @classmethod
    def of(cls, design: Design, tolerance: float) -> "Rim":
        """Return the rim of a lens within a tolerance, or with the most pieces."""
        count = _FEWEST
        while True:
            found = cls._through(design, count)
            if found.off <= tolerance or count >= _MOST:
                return found
            count *= 2

    @classmethod
    def _through(cls, design: Design, count: int) -> "Rim":
        r_x, r_y = design.net.half_width
        part = np.linspace(0, 1, count + 1)
        between = (part[1:] + part[:-1]) / 2
        quarters, off = [], 0.0
        for number in range(4):
            angle = (number + part) * (np.pi / 2)
            x, y = r_x * np.cos(angle), r_y * np.sin(angle)
            for ends, r in ((x, r_x), (y, r_y)):  # exactly on the axes
                ends[np.abs(ends) < 1e-9 * r] = 0.0
            z = design.net.at(x, y, design.heights)[0]
            curve = make_interp_spline(part, np.stack([x, y, z], axis=1), _DEGREE)
            x, y, z = curve(between).T
            aside = np.abs(np.hypot(x / r_x, y / r_y) - 1).max() * max(r_x, r_y)
            above = np.abs(z - design.net.at(x, y, design.heights)[0]).max()
            quarters.append(curve)
            off = max(off, float(aside), float(above))
        return cls(tuple(quarters), off)


def write_step(design: Design, file: BinaryIO) -> Deviation:
    """Write the lens as a solid."""
    model = Model(design.optic.onwards < 0)
    return _write(BREP, solid_shape, model, design.faces, file)


def write_step_face(design: Design, file: BinaryIO) -> Deviation:
    """Write the face of a design as a sheet; its normal points out of the body."""
    return _write(_SURFACE, _sheet, Model(design.outward < 0), [design], file)


def _write(
    kind: str, shape: "_Shape", model: "Model", faces: Sequence[Design], file: BinaryIO
) -> Deviation:
    item, off = shape_of(shape, model, faces)
    near = _TOLERANCE * max(faces[0].optic.half_width)
    write_shapes(kind, model, [item], faces[0], max(near, off), file)
    return deviation_of(faces, off)


def shape_of(shape: "_Shape", model: "Model", faces: Sequence[Design]) -> tuple[str, float]:
    """Add the shape of the designed element; return it, and how far its rim is off."""
    design = faces[0]
    near = _TOLERANCE * max(design.optic.half_width)
    rims = [] if design.outline.whole else [Rim.of(face, near) for face in faces]
    return shape(model, faces, rims), max((rim.off for rim in rims), default=0.0)


def deviation_of(faces: Sequence[Design], off: float) -> Deviation:
    """How far the written faces are off: by rounding, or by what is fitted at rims."""
    heights = np.concatenate([face.heights.ravel() for face in faces])
    rounding = float(np.abs([float(real(z)) for z in heights] - heights).max())
    if not off:
        return Deviation("rounding", rounding, faces[0].unit)
    return Deviation("error of the rim", max(rounding, off), faces[0].unit)


class _Net(NamedTuple):
    """Control net of a freeform face: control points (n_u, n_v, 3), also as entities."""

    face: Design
    places: Array
    points: list[list[str]]

    @classmethod
    def of(cls, face: Design, model: Model) -> "_Net":
        x, y = face.net.positions
        places = np.stack(np.broadcast_arrays(x[:, None], y, face.heights), axis=-1)
        return cls(face, places, [[model.point(place) for place in row] for row in places.tolist()])

    def rim(self, model: Model, side: int) -> str:
        points = self.points
        rims = ([row[0] for row in points], points[-1], [row[-1] for row in points], points[0])
        net = self.face.net
        return spline_curve(model, net.degree[side % 2], rims[side], net.knots[side % 2])


def _straight(model: Model, nets: Sequence[_Net]) -> tuple[Side, ...]:
    exit_, *entrance = nets
    upper, *lower = ([net.places[corner].tolist() for corner in _CORNERS] for net in nets)
    feet = lower[0] if lower else [[*place[:2], exit_.face.flat_z] for place in upper]
    sides = []
    for side in range(4):
        curve = exit_.rim(model, side)
        if entrance:
            foot = entrance[0].rim(model, side)
        else:
            first = feet[side if _RISING[side] else (side + 1) % 4]
            foot = model.line(first, _ALONG[side])
        plane = model.plane(feet[side], _OUTWARD[side], _ALONG[side])
        sides.append(Side(upper[side], feet[side], curve, foot, _RISING[side], plane))
    return tuple(sides)


def _arcs(rims: Sequence[Rim], model: Model, nets: Sequence[_Net]) -> tuple[Side, ...]:
    face = nets[0].face
    flat_z = face.flat_z
    flat = ellipse(model, face.net.half_width, flat_z)
    wall = elliptic_wall(model, face.net.half_width, flat_z, flat)
    sides = []
    for quarters in zip(*(rim.quarters for rim in rims), strict=True):
        upper, *lower = (quarter(0.0).tolist() for quarter in quarters)
        curve, *foot = (_arc(model, quarter) for quarter in quarters)
        below = lower[0] if lower else [*upper[:2], flat_z]
        sides.append(Side(upper, below, curve, foot[0] if foot else flat, True, wall))
    return tuple(sides)


def _arc(model: Model, quarter: BSpline) -> str:
    points = [model.point(place) for place in quarter.c.tolist()]
    return spline_curve(model, quarter.k, points, quarter.t)


def _sheet(model: Model, faces: Sequence[Design], rims: Sequence[Rim]) -> str:
    net = _Net.of(faces[0], model)
    surface = _surface(model, net, "freeform face")
    if rims:
        corners = [quarter(0.0).tolist() for quarter in rims[0].quarters]
        curves, rising = [_arc(model, quarter) for quarter in rims[0].quarters], (True,) * 4
    else:
        corners = [net.places[corner].tolist() for corner in _CORNERS]
        curves, rising = [net.rim(model, side) for side in range(4)], _RISING
    vertices = [model.vertex(place) for place in corners]
    face = model.face(surface, around(model, vertices, curves, rising))
    shell = model.add(f"OPEN_SHELL('',({face}))")
    return model.add(f"SHELL_BASED_SURFACE_MODEL('freeform face',({shell}))")


def solid_shape(
    model: Model, faces: Sequence[Design], rims: Sequence[Rim], name: str = "freeform lens"
) -> str:
    """Add the solid of the designed element."""
    faces[0].check_flat_side()
    nets = [_Net.of(face, model) for face in faces]
    surface, *entrance = (
        _surface(model, net, name)
        for net, name in zip(nets, ("exit face", "entrance face"), strict=False)
    )
    sides = _arcs(rims, model, nets) if rims else _straight(model, nets)
    if entrance:
        return closed_solid(model, sides, Skin(surface), Skin(entrance[0]), name)
    flat = Skin(model.plane(sides[0].lower, (0, 0, -1), (1, 0, 0)), against=True)
    return closed_solid(model, sides, Skin(surface), flat, name)


_Shape = Callable[[Model, Sequence[Design], Sequence[Rim]], str]


def _surface(model: Model, net: _Net, name: str) -> str:
    return spline_surface(model, net.face.net, net.points, name)
