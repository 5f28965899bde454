"""A mirror is exported as a plate with its face below and a flat back."""

import numpy as np
import pytest

from workbench.files.export.iges import write_iges
from workbench.files.export.step import write_step
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


def test_the_face_in_iges_is_the_mirror(make_mirror, tmp_path):
    design = make_mirror()
    with (tmp_path / "mirror.iges").open("wb") as file:
        deviation = write_iges(design, file)
    assert deviation.size < 1e-9
