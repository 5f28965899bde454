"""STEP (ISO 10303-21, AP214): the lens as one solid whose exit face is *the* B-spline surface.

Four sides and the entrance face are planes, bounded by straight lines and by the B-spline curves
at the rim of the exit face. Nothing is fitted, and no number is rounded. The header tells neither
user nor time, so the same lens gives the same file.
"""

from collections.abc import Iterable, Sequence
from typing import BinaryIO

import numpy as np
import numpy.typing as npt

from workbench.files.export.design import METRES, Design, Deviation

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
    model = _Model()
    solid = _solid(model, design)
    _product(model, solid, _context(model, design))
    file.write(_HEADER.encode())
    file.writelines(f"#{i}={entity};\n".encode() for i, entity in enumerate(model.entities, 1))
    file.write(_FOOTER.encode())
    written = np.array([float(_real(z)) for z in design.heights.flat])
    return Deviation("rounding", float(np.abs(written - design.heights.ravel()).max()), design.unit)


class _Model:
    """Entities, numbered from 1."""

    def __init__(self) -> None:
        self.entities: list[str] = []

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

    def face(self, surface: str, loop: Iterable[tuple[str, bool]]) -> str:
        """A face whose normal is that of its surface, its loop counterclockwise around it."""
        edges = [
            self.add(f"ORIENTED_EDGE('',*,*,{edge},{'.T.' if forward else '.F.'})")
            for edge, forward in loop
        ]
        around = self.add(f"EDGE_LOOP('',{_list(edges)})")
        bound = self.add(f"FACE_OUTER_BOUND('',{around},.T.)")
        return self.add(f"ADVANCED_FACE('',({bound}),{surface},.T.)")


def _solid(model: _Model, design: Design) -> str:
    x, y = design.net.positions
    entrance_z = design.scene.lens.entrance_z
    places = np.stack(np.broadcast_arrays(x[:, None], y, design.heights), axis=-1)
    net = [[model.point(place) for place in row] for row in places.tolist()]
    surface = _surface(model, design, net)

    rims = ([row[0] for row in net], net[-1], [row[-1] for row in net], net[0])
    upper = [places[corner].tolist() for corner in _CORNERS]
    lower = [[*place[:2], entrance_z] for place in upper]
    over, under = ([model.vertex(place) for place in corners] for corners in (upper, lower))
    tops, bottoms = [], []
    for side, rim in enumerate(rims):
        ends = (side, (side + 1) % 4) if _RISING[side] else ((side + 1) % 4, side)
        curve = _curve(model, design, side % 2, rim)
        tops.append((model.edge(over[ends[0]], over[ends[1]], curve), _RISING[side]))
        foot = model.line(lower[ends[0]], _ALONG[side])
        bottoms.append((model.edge(under[ends[0]], under[ends[1]], foot), _RISING[side]))
    uprights = [model.edge(under[k], over[k], model.line(lower[k], (0, 0, 1))) for k in range(4)]

    faces = [model.face(surface, tops)]
    for side in range(4):
        plane = model.plane(lower[side], _OUTWARD[side], _ALONG[side])
        top, forward = tops[side]
        around = [bottoms[side], (uprights[(side + 1) % 4], True)]
        faces.append(model.face(plane, [*around, (top, not forward), (uprights[side], False)]))
    below = [(edge, not forward) for edge, forward in reversed(bottoms)]
    faces.append(model.face(model.plane(lower[0], (0, 0, -1), (1, 0, 0)), below))
    shell = model.add(f"CLOSED_SHELL('',{_list(faces)})")
    return model.add(f"MANIFOLD_SOLID_BREP('freeform lens',{shell})")


def _surface(model: _Model, design: Design, net: list[list[str]]) -> str:
    (p, q), (along_u, along_v) = design.net.degree, map(_knots, design.net.knots)
    points = _list("\n" + _list(row) for row in net)  # a line would be megabytes long
    return model.add(
        f"B_SPLINE_SURFACE_WITH_KNOTS('exit face',{p},{q},{points},.UNSPECIFIED.,.F.,.F.,.F.,"
        f"{along_u[0]},{along_v[0]},{along_u[1]},{along_v[1]},.UNSPECIFIED.)"
    )


def _curve(model: _Model, design: Design, axis: int, points: list[str]) -> str:
    multiplicities, knots = _knots(design.net.knots[axis])
    return model.add(
        f"B_SPLINE_CURVE_WITH_KNOTS('',{design.net.degree[axis]},{_list(points)},.UNSPECIFIED.,"
        f".F.,.F.,{multiplicities},{knots},.UNSPECIFIED.)"
    )


def _knots(knots: Array) -> tuple[str, str]:
    """Multiplicities, and the knots themselves."""
    values, counts = np.unique(knots, return_counts=True)
    return _list(map(str, counts.tolist())), _list(map(_real, values.tolist()))


def _context(model: _Model, design: Design) -> str:
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
    tolerance = _real(_TOLERANCE * max(design.scene.lens.half_width))
    uncertainty = model.add(
        f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({tolerance}),{length},"
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
