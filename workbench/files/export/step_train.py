"""STEP: all elements of a train as named solids in one file, each in its place.

Plane and spherical faces are planes and spheres. Other faces, and the rims of faces that are no
circles, are fitted by B-splines; the error is reported. Designed elements are as in `step`.
"""

import math
from functools import cached_property, partial
from typing import BinaryIO

import numpy as np

from workbench.arrays import Array
from workbench.files.export.design import Design, Deviation
from workbench.files.export.step import BREP, deviation_of, shape_of, solid_shape
from workbench.files.export.step_model import (
    Model,
    Side,
    Skin,
    closed_solid,
    ellipse,
    elliptic_wall,
    real,
    spline_curve,
    spline_surface,
    write_shapes,
)
from workbench.geometry.basis import basis_matrix, greville
from workbench.geometry.face_grids import element_sides
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet
from workbench.scene import Element, Face, PlaneFace
from workbench.scene.part import title_of

_DEGREE = 5
# Fewest and most control points along each axis of a fitted face.
_FEWEST, _MOST = 16, 256
# Error of a fit over the half-width that is small enough.
_TOLERANCE = 1e-8
# Corners of the square that is mapped onto an outline, counterclockwise from above; side k goes
# from corner k to k + 1.
_CORNERS = ((0, 0), (-1, 0), (-1, -1), (0, -1))


def write_step_train(design: Design, file: BinaryIO) -> Deviation:
    """Write all elements that are solid; the error is the largest of all fits."""
    scene, model, items = design.scene, Model(), []
    written: list[Design] = []  # designed faces
    off = 0.0
    for element in scene.elements:
        model.frame = Frame(element.origin, element.turn)
        if element.designed:
            model.turned = element.onwards < 0
            shape = partial(solid_shape, name=element.name)
            faces = design.of(element).faces
            written += faces
            item, error = shape_of(shape, model, faces)
            model.turned = False
        elif _is_solid(element):
            item, error = _fixed_solid(model, element)
        else:
            continue
        items.append(item)
        off = max(off, error)
    model.frame = None
    near = _TOLERANCE * min(min(element.half_width) for element in scene.elements)
    write_shapes(BREP, model, items, design, max(near, off), file)
    return deviation_of(written, off)


class _FixedFace:
    """A fixed face within an outline, in the coordinates of its element."""

    def __init__(self, element: Element, face: Face, z: float) -> None:
        self._outline, self._face, self._z = outline_of(element), face.undesigned, z
        self._half_width = element.half_width

    @cached_property
    def fitted(self) -> tuple[ControlNet, Array, float]:
        """Net, control points (n, n, 3), and their largest distance from face and wall."""
        count = _FEWEST
        while True:
            net = ControlNet((count, count), (_DEGREE, _DEGREE), self._half_width)
            knots = net.knots[0]
            sites = greville(knots, _DEGREE)
            into = np.linalg.inv(basis_matrix(knots, _DEGREE, sites))
            points = np.einsum("ia,abk,jb->ijk", into, self._at(sites), into)
            between = np.linspace(0, 1, 4 * count + 1)
            basis = basis_matrix(knots, _DEGREE, between)
            found = np.einsum("ai,ijk,bj->abk", basis, points, basis)
            off = float(np.abs(found - self._at(between)).max())
            if off <= _TOLERANCE * max(self._half_width) or count >= _MOST:
                return net, points, off
            count *= 2

    def _at(self, t: Array) -> Array:
        """Points (m, m, 3) over parameters (m,) in [0, 1]."""
        x, y = self._outline.from_square(2 * t[:, None] - 1, 2 * t - 1)
        if not self._outline.whole:  # corners on the axes: walls have their seam at +x
            (r_x, r_y), (a, b) = (
                self._half_width,
                (x / self._half_width[0], y / self._half_width[1]),
            )
            x, y = -r_x * math.sqrt(0.5) * (a + b), r_y * math.sqrt(0.5) * (a - b)
        return np.stack([x, y, self.heights(x, y)], axis=-1)

    def heights(self, x: Array, y: Array) -> Array:
        """Its z at (x, y)."""
        return self._z + self._face.sag(x, y)

    @property
    def corners(self) -> list[list[float]]:
        """Where its sides meet."""
        points = self._at(np.array([0.0, 1.0]))
        return [points[corner].tolist() for corner in _CORNERS]

    @property
    def _flat(self) -> bool:
        """Whether its rim is in a plane across the axis."""
        round_ = not self._outline.whole and len(set(self._half_width)) == 1
        return self._face.flat or (round_ and self._face.rotational)

    @property
    def off(self) -> float:
        """Error of what is fitted."""
        exact = self._face.flat or (self._flat and self._face.sphere_radius is not None)
        return 0.0 if exact else self.fitted[2]

    def skin(self, model: Model) -> Skin:
        """Add its surface."""
        radius = self._face.sphere_radius
        if self._face.flat:
            return Skin(model.plane((0, 0, self._z), (0, 0, 1), (1, 0, 0)))
        if radius is not None:
            # Its poles and its seam are beside the face.
            away = 1 if radius > 0 else -1
            place = model.placement((0, 0, self._z + radius), (0, 1, 0), (0, 0, away))
            sphere = f"SPHERICAL_SURFACE('',{place},{real(abs(radius))})"
            return Skin(model.add(sphere), radius > 0)
        net, points, _ = self.fitted
        entities = [[model.point(place) for place in row] for row in points.tolist()]
        return Skin(
            spline_surface(model, net, entities, f"{title_of(type(self._face)).lower()} face")
        )

    def rim(self, model: Model) -> list[str]:
        """Add the curves of its sides, counterclockwise from above."""
        corners = self.corners
        if self._flat and not self._outline.whole:
            return [ellipse(model, self._half_width, corners[0][2])] * 4
        if self._flat:
            ways = np.diff([*corners, corners[0]], axis=0)
            ways /= np.linalg.norm(ways, axis=1, keepdims=True)
            pairs = zip(corners, ways.tolist(), strict=True)
            return [model.line(corner, way) for corner, way in pairs]
        net, points, _ = self.fitted
        sides = points[:, 0], points[-1], points[::-1, -1], points[0, ::-1]
        return [
            spline_curve(model, _DEGREE, [model.point(p) for p in side.tolist()], net.knots[0])
            for side in sides
        ]


def _is_solid(element: Element) -> bool:
    """Whether its sides are apart: those of a diffuser are one plane."""
    middle = np.zeros(1)
    front, back = element_sides(element, middle, middle, {})
    return not np.array_equal(front, back)


def _fixed_solid(model: Model, element: Element) -> tuple[str, float]:
    """Add the solid of a fixed element; return it, and the error of what is fitted."""
    front, *others = (_FixedFace(element, placed.face, placed.z) for placed in element.placed_faces)
    if others:
        back = others[-1]
    else:  # a plate
        side = np.linspace(-1, 1, 65)
        x, y = outline_of(element).from_square(side[:, None], side)
        flat = element.flat_z(front.heights(x, y))
        back = _FixedFace(element, PlaneFace(), flat)
    tops, feet = back.rim(model), front.rim(model)
    walls = _walls(model, element, front.corners)
    parts = zip(back.corners, front.corners, tops, feet, walls, strict=True)
    sides = [Side(upper, lower, top, foot, True, wall) for upper, lower, top, foot, wall in parts]
    solid = closed_solid(model, sides, back.skin(model), front.skin(model), element.name)
    return solid, max(front.off, back.off)


def _walls(model: Model, element: Element, corners: list[list[float]]) -> list[str]:
    if outline_of(element).whole:
        outward, along = ((0, -1, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0)), ((1, 0, 0), (0, 1, 0)) * 2
        planes = zip(corners, outward, along, strict=True)
        return [model.plane(*plane) for plane in planes]
    rim = ellipse(model, element.half_width, 0.0)
    return [elliptic_wall(model, element.half_width, 0.0, rim)] * 4
