"""STEP (ISO 10303-21, AP214): the lens as one solid with exact B-spline faces.

Four sides and a flat entrance face are planes, bounded by straight lines and by the B-spline curves
at the rims of freeform faces. Nothing is fitted or rounded. The wall of an elliptic lens is an
extruded ellipse, in four quarters; there the rim of a freeform face is fitted, as no B-spline curve
lies on both face and wall, and the error is reported. The header has neither user nor time: the
same lens gives the same file. A single face is written as an open sheet.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import BinaryIO, NamedTuple

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline

from workbench.arrays import Array
from workbench.files.export.design import METRES, Design, Deviation

# Least and most pieces of a quarter of the rim.
_FEWEST, _MOST = 64, 4096
_DEGREE = 3
# Points closer than this part of the half-width count as one.
_TOLERANCE = 1e-8
_HEADER = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('freeform lens'),'2;1');
FILE_NAME('freeform lens','1970-01-01T00:00:00',(''),(''),'','freeform-lens-workbench','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
"""
_FOOTER = "ENDSEC;\nEND-ISO-10303-21;\n"
_BREP, _SURFACE = "ADVANCED_BREP", "MANIFOLD_SURFACE"  # kinds of shapes
_SI_PREFIX = {"mm": ".MILLI.", "cm": ".CENTI.", "m": "$"}
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
    model = _Model(design.scene.optic.onwards < 0)
    return _write(_BREP, _solid, model, design.faces, file)


def write_step_face(design: Design, file: BinaryIO) -> Deviation:
    """Write the face of a design as a sheet; its normal points out of the body."""
    return _write(_SURFACE, _sheet, _Model(design.outward < 0), [design], file)


def _write(
    kind: str, shape: "_Shape", model: "_Model", faces: Sequence[Design], file: BinaryIO
) -> Deviation:
    design = faces[0]
    near = _TOLERANCE * max(design.scene.optic.half_width)
    rims = [] if design.outline.whole else [Rim.of(face, near) for face in faces]
    off = max((rim.off for rim in rims), default=0.0)
    item = shape(model, faces, rims)
    _product(model, f"{kind}_SHAPE_REPRESENTATION", item, _context(model, design, max(near, off)))
    file.write(_HEADER.encode())
    file.writelines(f"#{i}={entity};\n".encode() for i, entity in enumerate(model.entities, 1))
    file.write(_FOOTER.encode())
    heights = np.concatenate([face.heights.ravel() for face in faces])
    rounding = float(np.abs([float(_real(z)) for z in heights] - heights).max())
    if not rims:
        return Deviation("rounding", rounding, design.unit)
    return Deviation("error of the rim", max(rounding, off), design.unit)


class _Model:
    """Numbered entities; ``turned`` swaps inside and outside, for a face below the flat side."""

    def __init__(self, turned: bool) -> None:
        self.entities: list[str] = []
        self.turned = turned

    def add(self, entity: str) -> str:
        self.entities.append(entity)
        return f"#{len(self.entities)}"

    def point(self, place: Iterable[float]) -> str:
        return self.add(f"CARTESIAN_POINT('',{_list(map(_real, place))})")

    def vertex(self, place: Iterable[float]) -> str:
        return self.add(f"VERTEX_POINT('',{self.point(place)})")

    def direction(self, direction: Iterable[float]) -> str:
        return self.add(f"DIRECTION('',{_list(map(_real, direction))})")

    def plane(self, place: Iterable[float], normal: Sequence[float], along: Sequence[float]) -> str:
        return self.add(f"PLANE('',{self.placement(place, normal, along)})")

    def placement(
        self, place: Iterable[float], axis: Sequence[float], along: Sequence[float]
    ) -> str:
        parts = [self.point(place), self.direction(axis), self.direction(along)]
        return self.add(f"AXIS2_PLACEMENT_3D('',{','.join(parts)})")

    def line(self, place: Iterable[float], direction: Sequence[float]) -> str:
        vector = self.add(f"VECTOR('',{self.direction(direction)},1.)")
        return self.add(f"LINE('',{self.point(place)},{vector})")

    def edge(self, start: str, end: str, curve: str) -> str:
        return self.add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")

    def face(self, surface: str, loop: Sequence[tuple[str, bool]], turned: bool = False) -> str:
        """Add a face with the normal of its surface and a counterclockwise loop.

        Where the face or the model is turned, normal and loop are reversed.
        """
        turned = turned != self.turned
        if turned:
            loop = [(edge, not forward) for edge, forward in reversed(loop)]
        edges = [
            self.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if forward else '.F.'})")
            for edge, forward in loop
        ]
        around = self.add(f"EDGE_LOOP('',{_list(edges)})")
        bound = self.add(f"FACE_OUTER_BOUND('',{around},.T.)")
        return self.add(f"ADVANCED_FACE('',({bound}),{surface},{'.F.' if turned else '.T.'})")


class _Net(NamedTuple):
    """Control net of a freeform face: control points (n_u, n_v, 3), also as entities."""

    face: Design
    places: Array
    points: list[list[str]]

    @classmethod
    def of(cls, face: Design, model: _Model) -> "_Net":
        x, y = face.net.positions
        places = np.stack(np.broadcast_arrays(x[:, None], y, face.heights), axis=-1)
        return cls(face, places, [[model.point(place) for place in row] for row in places.tolist()])

    def rim(self, model: _Model, side: int) -> str:
        points = self.points
        rims = ([row[0] for row in points], points[-1], [row[-1] for row in points], points[0])
        net = self.face.net
        return _curve(model, net.degree[side % 2], rims[side], net.knots[side % 2])


class _Side(NamedTuple):
    """A side of the lens; its curves go from one corner to the next.

    Its first corner, counterclockwise from above, is ``upper`` on the exit face and ``lower`` on
    the other; ``top`` and ``foot`` are its curves, ``rising`` whether these go counterclockwise.
    """

    upper: Sequence[float]
    lower: Sequence[float]
    top: str
    foot: str
    rising: bool
    wall: str


def _straight(model: _Model, nets: Sequence[_Net]) -> tuple[_Side, ...]:
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
        sides.append(_Side(upper[side], feet[side], curve, foot, _RISING[side], plane))
    return tuple(sides)


def _arcs(rims: Sequence[Rim], model: _Model, nets: Sequence[_Net]) -> tuple[_Side, ...]:
    face = nets[0].face
    (r_x, r_y), flat_z = face.net.half_width, face.flat_z
    middle = (0.0, 0.0, flat_z)
    wide = r_x >= r_y  # readers require the longer semi-axis first
    placement = model.placement(middle, (0, 0, 1), (1, 0, 0) if wide else (0, 1, 0))
    if r_x == r_y:
        ellipse = model.add(f"CIRCLE('',{placement},{_real(r_x)})")
        wall = model.add(f"CYLINDRICAL_SURFACE('',{placement},{_real(r_x)})")
    else:
        axes = ",".join(map(_real, (max(r_x, r_y), min(r_x, r_y))))
        ellipse = model.add(f"ELLIPSE('',{placement},{axes})")
        upwards = model.add(f"VECTOR('',{model.direction((0, 0, 1))},1.)")
        wall = model.add(f"SURFACE_OF_LINEAR_EXTRUSION('',{ellipse},{upwards})")
    sides = []
    for quarters in zip(*(rim.quarters for rim in rims), strict=True):
        upper, *lower = (quarter(0.0).tolist() for quarter in quarters)
        curve, *foot = (_arc(model, quarter) for quarter in quarters)
        below = lower[0] if lower else [*upper[:2], flat_z]
        sides.append(_Side(upper, below, curve, foot[0] if foot else ellipse, True, wall))
    return tuple(sides)


def _arc(model: _Model, quarter: BSpline) -> str:
    points = [model.point(place) for place in quarter.c.tolist()]
    return _curve(model, quarter.k, points, quarter.t)


def _sheet(model: _Model, faces: Sequence[Design], rims: Sequence[Rim]) -> str:
    net = _Net.of(faces[0], model)
    surface = _surface(model, net, "freeform face")
    if rims:
        corners = [quarter(0.0).tolist() for quarter in rims[0].quarters]
        curves, rising = [_arc(model, quarter) for quarter in rims[0].quarters], (True,) * 4
    else:
        corners = [net.places[corner].tolist() for corner in _CORNERS]
        curves, rising = [net.rim(model, side) for side in range(4)], _RISING
    vertices = [model.vertex(place) for place in corners]
    face = model.face(surface, _around(model, vertices, curves, rising))
    shell = model.add(f"OPEN_SHELL('',({face}))")
    return model.add(f"SHELL_BASED_SURFACE_MODEL('freeform face',({shell}))")


def _around(
    model: _Model, vertices: Sequence[str], curves: Sequence[str], rising: Sequence[bool]
) -> list[tuple[str, bool]]:
    loop = []
    for number, (curve, forward) in enumerate(zip(curves, rising, strict=True)):
        ends = number, (number + 1) % 4
        first, last = ends if forward else ends[::-1]
        loop.append((model.edge(vertices[first], vertices[last], curve), forward))
    return loop


def _solid(model: _Model, faces: Sequence[Design], rims: Sequence[Rim]) -> str:
    nets = [_Net.of(face, model) for face in faces]
    surface, *entrance = (
        _surface(model, net, name)
        for net, name in zip(nets, ("exit face", "entrance face"), strict=False)
    )
    sides = _arcs(rims, model, nets) if rims else _straight(model, nets)
    over, under = (
        [model.vertex(place) for place in corners]
        for corners in ([side.upper for side in sides], [side.lower for side in sides])
    )
    rising = [side.rising for side in sides]
    tops = _around(model, over, [side.top for side in sides], rising)
    bottoms = _around(model, under, [side.foot for side in sides], rising)
    rise = (0, 0, -1 if model.turned else 1)
    uprights = [model.edge(under[k], over[k], model.line(sides[k].lower, rise)) for k in range(4)]

    shell = [model.face(surface, tops)]
    for number, side in enumerate(sides):
        top, forward = tops[number]
        around = [bottoms[number], (uprights[(number + 1) % 4], True)]
        loop = [*around, (top, not forward), (uprights[number], False)]
        shell.append(model.face(side.wall, loop))
    if entrance:
        shell.append(model.face(entrance[0], bottoms, turned=True))
    else:
        below = [(edge, not forward) for edge, forward in reversed(bottoms)]
        shell.append(model.face(model.plane(sides[0].lower, (0, 0, -1), (1, 0, 0)), below))
    closed = model.add(f"CLOSED_SHELL('',{_list(shell)})")
    return model.add(f"MANIFOLD_SOLID_BREP('freeform lens',{closed})")


_Shape = Callable[[_Model, Sequence[Design], Sequence[Rim]], str]


def _surface(model: _Model, net: _Net, name: str) -> str:
    space = net.face.net
    (p, q), (along_u, along_v) = space.degree, map(_knots, space.knots)
    points = _list("\n" + _list(row) for row in net.points)  # a line would be megabytes long
    return model.add(
        f"B_SPLINE_SURFACE_WITH_KNOTS('{name}',{p},{q},{points},.UNSPECIFIED.,.F.,.F.,.F.,"
        f"{along_u[0]},{along_v[0]},{along_u[1]},{along_v[1]},.UNSPECIFIED.)"
    )


def _curve(model: _Model, degree: int, points: list[str], along: Array) -> str:
    multiplicities, knots = _knots(along)
    return model.add(
        f"B_SPLINE_CURVE_WITH_KNOTS('',{degree},{_list(points)},.UNSPECIFIED.,"
        f".F.,.F.,{multiplicities},{knots},.UNSPECIFIED.)"
    )


def _knots(knots: Array) -> tuple[str, str]:
    values, counts = np.unique(knots, return_counts=True)
    return _list(map(str, counts.tolist())), _list(map(_real, values.tolist()))


def _context(model: _Model, design: Design, tolerance: float) -> str:
    if design.unit == "inch":
        millimetre = model.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
        factor = _real(METRES["inch"] / METRES["mm"])
        measure = model.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({factor}),{millimetre})")
        exponents = model.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
        length = model.add(
            f"(CONVERSION_BASED_UNIT('INCH',{measure})LENGTH_UNIT()NAMED_UNIT({exponents}))"
        )
    else:
        prefix = _SI_PREFIX[design.unit]
        length = model.add(f"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.))")
    angle = model.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    solid_angle = model.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
    uncertainty = model.add(
        f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({_real(tolerance)}),{length},"
        "'distance_accuracy_value','')"
    )
    return model.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
        f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty}))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid_angle}))"
        "REPRESENTATION_CONTEXT('',''))"
    )


def _product(model: _Model, representation: str, item: str, context: str) -> None:
    add = model.add
    origin = model.placement((0, 0, 0), (0, 0, 1), (1, 0, 0))
    shape = add(f"{representation}('',({origin},{item}),{context})")
    application = add("APPLICATION_CONTEXT('automotive design')")
    add(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,"
        f"{application})"
    )
    mechanical = add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    product = add(f"PRODUCT('freeform lens','freeform lens','',({mechanical}))")
    add(f"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))")
    formation = add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    stage = add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    definition = add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")
    defined = add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    add(f"SHAPE_DEFINITION_REPRESENTATION({defined},{shape})")


def _list(items: Iterable[str]) -> str:
    return f"({','.join(items)})"


def _real(value: float) -> str:
    mantissa, _, exponent = repr(float(value)).partition("e")
    if "." not in mantissa:
        mantissa += "."
    return f"{mantissa}E{exponent}" if exponent else mantissa
