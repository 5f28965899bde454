"""Entities of a STEP file (ISO 10303-21, AP214): curves, surfaces and solids with walls.

The header has neither user nor time: the same shapes give the same file.
"""

from collections.abc import Iterable, Sequence
from typing import BinaryIO, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.files.export.design import METRES, Design
from workbench.geometry.frames import Frame
from workbench.geometry.surface import ControlNet

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


class Model:
    """Numbered entities.

    ``turned`` swaps inside and outside, for a face below the flat side; ``frame`` is where the
    coordinates of points and directions stand.
    """

    def __init__(self, turned: bool = False) -> None:
        self.entities: list[str] = []
        self.turned = turned
        self.frame: Frame | None = None

    def add(self, entity: str) -> str:
        """Add an entity; return its number."""
        self.entities.append(entity)
        return f"#{len(self.entities)}"

    def point(self, place: Iterable[float]) -> str:
        """Add a point."""
        if self.frame is not None:
            place = self.frame.position + self.frame.rotation @ np.array([*place])
        return self.add(f"CARTESIAN_POINT('',{_list(map(real, place))})")

    def vertex(self, place: Iterable[float]) -> str:
        """Add a vertex."""
        return self.add(f"VERTEX_POINT('',{self.point(place)})")

    def direction(self, direction: Iterable[float]) -> str:
        """Add a direction."""
        if self.frame is not None:
            direction = self.frame.rotation @ np.array([*direction])
        return self.add(f"DIRECTION('',{_list(map(real, direction))})")

    def plane(self, place: Iterable[float], normal: Sequence[float], along: Sequence[float]) -> str:
        """Add a plane."""
        return self.add(f"PLANE('',{self.placement(place, normal, along)})")

    def placement(
        self, place: Iterable[float], axis: Sequence[float], along: Sequence[float]
    ) -> str:
        """Add an origin with an axis and a direction across it."""
        parts = [self.point(place), self.direction(axis), self.direction(along)]
        return self.add(f"AXIS2_PLACEMENT_3D('',{','.join(parts)})")

    def line(self, place: Iterable[float], direction: Sequence[float]) -> str:
        """Add a line."""
        vector = self.add(f"VECTOR('',{self.direction(direction)},1.)")
        return self.add(f"LINE('',{self.point(place)},{vector})")

    def edge(self, start: str, end: str, curve: str) -> str:
        """Add an edge between two vertices."""
        return self.add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")

    def face(
        self,
        surface: str,
        loop: Sequence[tuple[str, bool]],
        turned: bool = False,
        against: bool = False,
    ) -> str:
        """Add a face with a counterclockwise loop about its normal.

        The normal is that of its surface, or ``against`` it. Where the face or the model is turned,
        normal and loop are reversed.
        """
        turned = turned != self.turned
        if turned:
            loop = [(edge, not forward) for edge, forward in reversed(loop)]
        edges = [
            self.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if forward else '.F.'})")
            for edge, forward in loop
        ]
        closed = self.add(f"EDGE_LOOP('',{_list(edges)})")
        bound = self.add(f"FACE_OUTER_BOUND('',{closed},.T.)")
        same = ".T." if turned == against else ".F."
        return self.add(f"ADVANCED_FACE('',({bound}),{surface},{same})")


class Side(NamedTuple):
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


class Skin(NamedTuple):
    """A surface; its normal is along +z, or ``against`` it."""

    surface: str
    against: bool = False


def closed_solid(model: Model, sides: Sequence[Side], top: Skin, foot: Skin, name: str) -> str:
    """Add the solid between two surfaces, with walls at its sides."""
    over, under = (
        [model.vertex(place) for place in corners]
        for corners in ([side.upper for side in sides], [side.lower for side in sides])
    )
    rising = [side.rising for side in sides]
    tops = around(model, over, [side.top for side in sides], rising)
    bottoms = around(model, under, [side.foot for side in sides], rising)
    rise = (0, 0, -1 if model.turned else 1)
    uprights = [model.edge(under[k], over[k], model.line(sides[k].lower, rise)) for k in range(4)]

    shell = [model.face(top.surface, tops, against=top.against)]
    for number, side in enumerate(sides):
        upper, forward = tops[number]
        begun = [bottoms[number], (uprights[(number + 1) % 4], True)]
        loop = [*begun, (upper, not forward), (uprights[number], False)]
        shell.append(model.face(side.wall, loop))
    shell.append(model.face(foot.surface, bottoms, turned=True, against=foot.against))
    closed = model.add(f"CLOSED_SHELL('',{_list(shell)})")
    return model.add(f"MANIFOLD_SOLID_BREP('{name}',{closed})")


def around(
    model: Model, vertices: Sequence[str], curves: Sequence[str], rising: Sequence[bool]
) -> list[tuple[str, bool]]:
    """Add edges along curves, counterclockwise from vertex to vertex; ``rising`` if they run so."""
    loop = []
    for number, (curve, forward) in enumerate(zip(curves, rising, strict=True)):
        ends = number, (number + 1) % 4
        first, last = ends if forward else ends[::-1]
        loop.append((model.edge(vertices[first], vertices[last], curve), forward))
    return loop


def spline_surface(model: Model, space: ControlNet, net: list[list[str]], name: str) -> str:
    """Add a B-spline surface with these control points, entities (n_u, n_v)."""
    (p, q), (along_u, along_v) = space.degree, map(_knots, space.knots)
    points = _list("\n" + _list(row) for row in net)  # a line would be megabytes long
    return model.add(
        f"B_SPLINE_SURFACE_WITH_KNOTS('{name}',{p},{q},{points},.UNSPECIFIED.,.F.,.F.,.F.,"
        f"{along_u[0]},{along_v[0]},{along_u[1]},{along_v[1]},.UNSPECIFIED.)"
    )


def spline_curve(model: Model, degree: int, points: list[str], along: Array) -> str:
    """Add a B-spline curve with these knots."""
    multiplicities, knots = _knots(along)
    return model.add(
        f"B_SPLINE_CURVE_WITH_KNOTS('',{degree},{_list(points)},.UNSPECIFIED.,"
        f".F.,.F.,{multiplicities},{knots},.UNSPECIFIED.)"
    )


def _knots(knots: Array) -> tuple[str, str]:
    values, counts = np.unique(knots, return_counts=True)
    return _list(map(str, counts.tolist())), _list(map(real, values.tolist()))


def ellipse(model: Model, half_width: tuple[float, float], z: float) -> str:
    """Add a circle or an ellipse about the axis."""
    r_x, r_y = half_width
    wide = r_x >= r_y  # readers require the longer semi-axis first
    placement = model.placement((0.0, 0.0, z), (0, 0, 1), (1, 0, 0) if wide else (0, 1, 0))
    if r_x == r_y:
        return model.add(f"CIRCLE('',{placement},{real(r_x)})")
    axes = ",".join(map(real, (max(r_x, r_y), min(r_x, r_y))))
    return model.add(f"ELLIPSE('',{placement},{axes})")


def elliptic_wall(model: Model, half_width: tuple[float, float], z: float, rim: str) -> str:
    """Add the wall of an elliptic element through its `ellipse`; the seam is on an axis."""
    if half_width[0] == half_width[1]:
        placement = model.placement((0.0, 0.0, z), (0, 0, 1), (1, 0, 0))
        return model.add(f"CYLINDRICAL_SURFACE('',{placement},{real(half_width[0])})")
    upwards = model.add(f"VECTOR('',{model.direction((0, 0, 1))},1.)")
    return model.add(f"SURFACE_OF_LINEAR_EXTRUSION('',{rim},{upwards})")


def write_shapes(
    kind: str,
    model: "Model",
    items: Sequence[str],
    design: Design,
    tolerance: float,
    file: BinaryIO,
) -> None:
    """Write shapes as one product in the unit of a design."""
    context = _context(model, design, tolerance)
    _product(model, f"{kind}_SHAPE_REPRESENTATION", items, context)
    file.write(_HEADER.encode())
    file.writelines(f"#{i}={entity};\n".encode() for i, entity in enumerate(model.entities, 1))
    file.write(_FOOTER.encode())


def _context(model: Model, design: Design, tolerance: float) -> str:
    if design.unit == "inch":
        millimetre = model.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
        factor = real(METRES["inch"] / METRES["mm"])
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
        f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({real(tolerance)}),{length},"
        "'distance_accuracy_value','')"
    )
    return model.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
        f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty}))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid_angle}))"
        "REPRESENTATION_CONTEXT('',''))"
    )


def _product(model: Model, representation: str, items: Sequence[str], context: str) -> None:
    add = model.add
    origin = model.placement((0, 0, 0), (0, 0, 1), (1, 0, 0))
    shape = add(f"{representation}('',({','.join([origin, *items])}),{context})")
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


def real(value: float) -> str:
    """Write a number so that it is read as the same."""
    mantissa, _, exponent = repr(float(value)).partition("e")
    if "." not in mantissa:
        mantissa += "."
    return f"{mantissa}E{exponent}" if exponent else mantissa
