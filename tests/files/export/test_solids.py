"""Exports read by OpenCASCADE: STEP, IGES, mirrors and elliptic lenses."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.files.export.iges import write_iges, write_iges_face
from workbench.files.export.step import write_step, write_step_face
from workbench.files.export.step_model import real
from workbench.files.export.tessellation import Tessellation

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}


PLACES = np.linspace(0, 1, 41)


def is_spline(surface):
    return type(surface).__name__ == "Geom_BSplineSurface"


def points_of(surface):
    """Points of a surface at equal steps of its parameters, shape (m, m, 3)."""
    return np.array(
        [[(p.X(), p.Y(), p.Z()) for p in map(surface.Value, [u] * 41, PLACES)] for u in PLACES]
    )


def expected(design):
    r_x, r_y = design.net.half_width
    x, y = (2 * PLACES - 1) * r_x, (2 * PLACES - 1) * r_y
    z = design.surface(x, y)[0]
    return np.stack(np.broadcast_arrays(x[:, None], y, z), axis=-1)


class TestReadByOpenCascade:
    def check(self, design, write, read_solid, volume):
        path, deviation = write(write_step, design, "lens.step")
        assert deviation[:3] == ("rounding", 0.0, design.unit)
        found = read_solid(path)
        assert found.is_solid
        assert found.is_valid
        assert found.is_closed
        unit = MILLIMETRES[design.unit]
        # OpenCASCADE integrates by Gauss's formula, to which edges are foreign.
        exact = 1e-6 if min(design.net.degree) > 1 else 1e-4
        assert found.volume == pytest.approx(volume(design) * unit**3, rel=exact)
        assert len(found.surfaces) == 6
        splines = [surface for surface in found.surfaces if is_spline(surface)]
        others = [type(s).__name__ for s in found.surfaces if not is_spline(s)]
        assert others == ["Geom_Plane"] * 5
        (surface,) = splines
        size = unit * max(design.net.half_width)
        apart = np.abs(points_of(surface) - unit * expected(design)).max()
        assert apart < 1e-9 * size
        return surface

    @pytest.mark.parametrize("unit", MILLIMETRES)
    def test_units(self, make_design, write, read_solid, volume, unit):
        self.check(make_design({"unit": unit}), write, read_solid, volume)

    @pytest.mark.parametrize("degree", [(1, 1), (1, 3), (2, 5), (7, 7)])
    def test_degrees(self, make_design, write, read_solid, volume, degree):
        surface = self.check(make_design({"lens.degree": list(degree)}), write, read_solid, volume)
        assert (surface.UDegree(), surface.VDegree()) == degree
        assert (surface.NbUPoles(), surface.NbVPoles()) == (12, 10)

    @pytest.mark.parametrize("shape", [(4, 4), (4, 9), (64, 48)])
    def test_nets(self, make_design, write, read_solid, volume, shape):
        design = make_design({"lens.control_points": list(shape)})
        self.check(design, write, read_solid, volume)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_reals_are_read_as_the_same_number(value):
    text = real(value)
    assert re.fullmatch(r"-?\d+\.\d*(E[+-]\d+)?", text)
    assert float(text) == value


@pytest.mark.parametrize("unit", MILLIMETRES)
def test_read_by_opencascade(make_design, write, read_solid, volume, unit, capfd):
    design = make_design({"unit": unit})
    path, deviation = write(write_iges, design, "lens.iges")
    assert capfd.readouterr() == ("", "")
    assert deviation.kind == "error of the exit face"
    assert deviation.unit == unit
    assert deviation.size < 1e-8
    found = read_solid(path)
    assert found.is_solid
    assert found.is_valid
    assert found.is_closed
    assert found.volume == pytest.approx(volume(design) * MILLIMETRES[unit] ** 3, rel=1e-6)


def volume(design):
    """Exact: a basis function's integral is its support over degree + 1."""
    weights = [
        (knots[p + 1 :] - knots[: -p - 1]) / (p + 1) * (2 * r)
        for knots, p, r in zip(
            design.net.knots, design.net.degree, design.net.half_width, strict=True
        )
    ]
    return float(weights[0] @ (design.heights.max() + 0.3 - design.heights) @ weights[1])


def test_a_mesh_is_closed_and_its_triangles_face_outwards(make_mirror):
    design = make_mirror()
    vertices, triangles = Tessellation.of(design).body()
    sides = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    # Each side belongs to two triangles, which go along it in opposite directions.
    there = set(map(tuple, sides.tolist()))
    assert len(there) == len(sides)
    assert there == {(b, a) for a, b in there}
    a, b, c = np.moveaxis(vertices[triangles], 1, 0)
    assert np.einsum("ij,ij", a, np.cross(b, c)) / 6 == pytest.approx(volume(design), rel=1e-3)


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_step_is_a_valid_solid(make_mirror, tmp_path, read_solid, outline):
    design = make_mirror({"mirror.outline": outline})
    path = tmp_path / "mirror.step"
    with path.open("wb") as file:
        write_step(design, file)
    solid = read_solid(path)
    assert solid.is_solid
    assert solid.is_valid
    assert solid.is_closed
    assert solid.volume > 0  # its faces look outwards
    if outline == "rectangle":
        assert solid.volume == pytest.approx(1000 * volume(design), rel=1e-6)


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
@pytest.mark.parametrize(
    "name, writer", [("mirror.step", write_step_face), ("mirror.iges", write_iges_face)]
)
def test_the_sheet_of_a_mirror_is_its_face_alone(
    make_mirror, write, read_solid, name, writer, outline
):
    from OCP.Geom import Geom_Line  # late: OpenCASCADE takes a second to import
    from OCP.GeomAPI import GeomAPI_IntCS
    from OCP.gp import gp_Dir, gp_Lin, gp_Pnt

    design = make_mirror({"mirror.outline": outline})
    path, _ = write(writer, design, name)
    sheet = read_solid(path)
    assert sheet.is_valid and not sheet.is_solid and not sheet.is_closed
    (surface,) = sheet.surfaces
    for at_x, at_y in np.random.default_rng(3).uniform(-0.7, 0.7, (50, 2)):  # within the ellipse
        line = gp_Lin(gp_Pnt(10 * at_x, 7 * at_y, 0), gp_Dir(0, 0, 1))  # mm
        hits = GeomAPI_IntCS(Geom_Line(line), surface)
        z, _, _ = design.net.at(np.array([at_x]), np.array([0.7 * at_y]), design.heights)
        assert hits.NbPoints() == 1
        assert hits.Point(1).Z() == pytest.approx(10 * z[0], abs=1e-8)  # 1e-9 of the width
