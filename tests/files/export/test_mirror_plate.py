"""A mirror is exported as a plate with its face below and a flat back."""

import numpy as np
import pytest
from OCP.Geom import Geom_Line
from OCP.GeomAPI import GeomAPI_IntCS
from OCP.gp import gp_Dir, gp_Lin, gp_Pnt

from workbench.files.export.iges import write_iges_face
from workbench.files.export.step import write_step, write_step_face
from workbench.files.export.tessellation import Tessellation


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
