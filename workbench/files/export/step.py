"""STEP (ISO 10303-21, AP214): the lens as one solid whose exit face is *the* B-spline surface.

Four sides and the entrance face are planes, bounded by straight lines and by the B-spline curves
at the rim of the exit face. Nothing is fitted, and no number is rounded. The wall of an elliptic
lens is an ellipse that is extruded, in four quarters; there the rim of the exit face is fitted, as
no B-spline curve is on both faces, and what remains is told. The header tells neither user nor
time, so the same lens gives the same file.
"""

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from typing import BinaryIO, NamedTuple

import numpy as np
import numpy.typing as npt

from workbench.files.export.design import METRES, Design, Deviation
from workbench.files.export.rim import Rim

Array = npt.NDArray[np.float64]

# Points closer than this part of the lens count as one.
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
_SI_PREFIX = {"mm": ".MILLI.", "cm": ".CENTI.", "m": "$"}
# Corners of the lens, counterclockwise as seen from above; side k goes from corner k to k + 1.
_CORNERS = ((0, 0), (-1, 0), (-1, -1), (0, -1))
_OUTWARD = ((0, -1, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0))
_ALONG = ((1, 0, 0), (0, 1, 0), (1, 0, 0), (0, 1, 0))  # rising coordinate of each side
_RISING = (True, True, False, False)  # whether that is the way around


def write_step(design: Design, file: BinaryIO) -> Deviation:
    """Write the lens as a solid."""
    model = _Model(design.flat_z > design.heights.min())
    size = max(design.scene.optic.half_width)
    rim = None if design.outline.whole else Rim.of(design, _TOLERANCE * size)
    tolerance = max(_TOLERANCE * size, 0.0 if rim is None else rim.off)
    solid = _solid(model, design, _straight if rim is None else partial(_arcs, rim))
    _product(model, solid, _context(model, design, tolerance))
    file.write(_HEADER.encode())
    file.writelines(f"#{i}={entity};\n".encode() for i, entity in enumerate(model.entities, 1))
    file.write(_FOOTER.encode())
    written = np.array([float(_real(z)) for z in design.heights.flat])
    rounding = float(np.abs(written - design.heights.ravel()).max())
    if rim is None:
        return Deviation("rounding", rounding, design.unit)
    return Deviation("error of the rim", max(rounding, rim.off), design.unit)


class _Model:
    """Entities, numbered from 1.

    Parameters
    ----------
    turned : bool
        Whether the freeform face is below the flat one: then outside is where inside would be.
    """

    def __init__(self, turned: bool) -> None:
        self.entities: list[str] = []
        self.turned = turned

    def add(self, entity: str) -> str:
        """Take in an entity; its reference."""
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

    def face(self, surface: str, loop: Sequence[tuple[str, bool]]) -> str:
        """A face whose normal is that of its surface, its loop counterclockwise around it.

        Where the model is turned, the normal and the loop are the other way.
        """
        if self.turned:
            loop = [(edge, not forward) for edge, forward in reversed(loop)]
        edges = [
            self.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if forward else '.F.'})")
            for edge, forward in loop
        ]
        around = self.add(f"EDGE_LOOP('',{_list(edges)})")
        bound = self.add(f"FACE_OUTER_BOUND('',{around},.T.)")
        return self.add(f"ADVANCED_FACE('',({bound}),{surface},{'.F.' if self.turned else '.T.'})")


class _Side(NamedTuple):
    """A side of the lens; its curves go from one corner to the next.

    Attributes
    ----------
    upper, lower : sequence of float
        Its first corner, counterclockwise as seen from above, on the exit and on the entrance face.
    top, foot : str
        Curves along its edges.
    rising : bool
        Whether these go counterclockwise.
    wall : str
        Its surface.
    """

    upper: Sequence[float]
    lower: Sequence[float]
    top: str
    foot: str
    rising: bool
    wall: str


def _straight(
    model: _Model, design: Design, net: list[list[str]], places: Array
) -> tuple[_Side, ...]:
    """The sides of a rectangle."""
    flat_z = design.flat_z
    rims = ([row[0] for row in net], net[-1], [row[-1] for row in net], net[0])
    upper = [places[corner].tolist() for corner in _CORNERS]
    lower = [[*place[:2], flat_z] for place in upper]
    sides = []
    for side, rim in enumerate(rims):
        curve = _curve(model, design.net.degree[side % 2], rim, design.net.knots[side % 2])
        first = lower[side if _RISING[side] else (side + 1) % 4]
        foot = model.line(first, _ALONG[side])
        plane = model.plane(lower[side], _OUTWARD[side], _ALONG[side])
        sides.append(_Side(upper[side], lower[side], curve, foot, _RISING[side], plane))
    return tuple(sides)


def _arcs(
    rim: Rim, model: _Model, design: Design, net: list[list[str]], places: Array
) -> tuple[_Side, ...]:
    """The quarters of an ellipse."""
    (r_x, r_y), flat_z = design.net.half_width, design.flat_z
    middle = (0.0, 0.0, flat_z)
    wide = r_x >= r_y  # readers want the longer semi-axis first
    placement = model.placement(middle, (0, 0, 1), (1, 0, 0) if wide else (0, 1, 0))
    if r_x == r_y:
        foot = model.add(f"CIRCLE('',{placement},{_real(r_x)})")
        wall = model.add(f"CYLINDRICAL_SURFACE('',{placement},{_real(r_x)})")
    else:
        axes = ",".join(map(_real, (max(r_x, r_y), min(r_x, r_y))))
        foot = model.add(f"ELLIPSE('',{placement},{axes})")
        upwards = model.add(f"VECTOR('',{model.direction((0, 0, 1))},1.)")
        wall = model.add(f"SURFACE_OF_LINEAR_EXTRUSION('',{foot},{upwards})")
    sides = []
    for quarter in rim.quarters:
        points = [model.point(place) for place in quarter.c.tolist()]
        curve = _curve(model, quarter.k, points, quarter.t)
        upper = quarter(0.0).tolist()
        sides.append(_Side(upper, [*upper[:2], flat_z], curve, foot, True, wall))
    return tuple(sides)


_Sides = Callable[[_Model, Design, list[list[str]], Array], tuple[_Side, ...]]


def _solid(model: _Model, design: Design, sides_of: _Sides) -> str:
    x, y = design.net.positions
    places = np.stack(np.broadcast_arrays(x[:, None], y, design.heights), axis=-1)
    net = [[model.point(place) for place in row] for row in places.tolist()]
    surface = _surface(model, design, net)

    sides = sides_of(model, design, net, places)
    over, under = (
        [model.vertex(place) for place in corners]
        for corners in ([side.upper for side in sides], [side.lower for side in sides])
    )
    tops, bottoms = [], []
    for number, side in enumerate(sides):
        ends = number, (number + 1) % 4
        first, last = ends if side.rising else ends[::-1]
        tops.append((model.edge(over[first], over[last], side.top), side.rising))
        bottoms.append((model.edge(under[first], under[last], side.foot), side.rising))
    rise = (0, 0, -1 if model.turned else 1)
    uprights = [model.edge(under[k], over[k], model.line(sides[k].lower, rise)) for k in range(4)]

    faces = [model.face(surface, tops)]
    for number, side in enumerate(sides):
        top, forward = tops[number]
        around = [bottoms[number], (uprights[(number + 1) % 4], True)]
        loop = [*around, (top, not forward), (uprights[number], False)]
        faces.append(model.face(side.wall, loop))
    below = [(edge, not forward) for edge, forward in reversed(bottoms)]
    faces.append(model.face(model.plane(sides[0].lower, (0, 0, -1), (1, 0, 0)), below))
    shell = model.add(f"CLOSED_SHELL('',{_list(faces)})")
    return model.add(f"MANIFOLD_SOLID_BREP('freeform lens',{shell})")


def _surface(model: _Model, design: Design, net: list[list[str]]) -> str:
    (p, q), (along_u, along_v) = design.net.degree, map(_knots, design.net.knots)
    points = _list("\n" + _list(row) for row in net)  # a line would be megabytes long
    return model.add(
        f"B_SPLINE_SURFACE_WITH_KNOTS('exit face',{p},{q},{points},.UNSPECIFIED.,.F.,.F.,.F.,"
        f"{along_u[0]},{along_v[0]},{along_u[1]},{along_v[1]},.UNSPECIFIED.)"
    )


def _curve(model: _Model, degree: int, points: list[str], along: Array) -> str:
    multiplicities, knots = _knots(along)
    return model.add(
        f"B_SPLINE_CURVE_WITH_KNOTS('',{degree},{_list(points)},.UNSPECIFIED.,"
        f".F.,.F.,{multiplicities},{knots},.UNSPECIFIED.)"
    )


def _knots(knots: Array) -> tuple[str, str]:
    """Multiplicities, and the knots themselves."""
    values, counts = np.unique(knots, return_counts=True)
    return _list(map(str, counts.tolist())), _list(map(_real, values.tolist()))


def _context(model: _Model, design: Design, tolerance: float) -> str:
    """Units and tolerance."""
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


def _product(model: _Model, solid: str, context: str) -> None:
    """What AP214 wants to know of a part before it shows its shape."""
    add = model.add
    origin = model.placement((0, 0, 0), (0, 0, 1), (1, 0, 0))
    shape = add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({origin},{solid}),{context})")
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
    """The shortest text that is read as the same number, as ISO 10303-21 writes reals."""
    mantissa, _, exponent = repr(float(value)).partition("e")
    if "." not in mantissa:
        mantissa += "."
    return f"{mantissa}E{exponent}" if exponent else mantissa
