"""A mirror is exported as a plate with its face below and a flat back."""

import numpy as np
import pytest

from tests.accounts import account_of
from workbench.design.lens_state import LensState
from workbench.design.snapshot import Result
from workbench.files.export.design import Design
from workbench.files.export.iges import write_iges
from workbench.files.export.step import write_step
from workbench.files.export.tessellation import Tessellation
from workbench.geometry.faces import FaceArrays
from workbench.scene import Scene


def plate(rng, outline="rectangle"):
    scene = Scene.from_data(
        {
            "unit": "cm",
            "mirror": {
                "half_width": [1.0, 0.7],
                "control_points": [7, 6],
                "outline": outline,
                "thickness": 0.3,
            },
            "source": {"kind": "collimated"},
            "screen": {"z": -5.0, "half_width": [1.0, 1.0], "pixels": [4, 4]},
            "target": {"builtin": "tophat"},
        }
    )
    state = LensState(
        heights=FaceArrays({"mirror": 0.05 * rng.normal(size=(7, 6))}),
        irradiance=rng.random((4, 4)),
        loss=0.1,
        account=account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1),
    )
    return Design(scene, Result(state, losses=np.zeros(1), seconds=1.0), 1e-4)


def volume(design):
    """Exact: a basis function's integral is its support over degree + 1."""
    weights = [
        (knots[p + 1 :] - knots[: -p - 1]) / (p + 1) * (2 * r)
        for knots, p, r in zip(
            design.net.knots, design.net.degree, design.net.half_width, strict=True
        )
    ]
    return float(weights[0] @ (design.heights.max() + 0.3 - design.heights) @ weights[1])


def test_a_mesh_is_closed_and_its_triangles_face_outwards(rng):
    design = plate(rng)
    vertices, triangles = Tessellation.of(design).body()
    sides = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    # Each side belongs to two triangles, which go along it in opposite directions.
    there = set(map(tuple, sides.tolist()))
    assert len(there) == len(sides)
    assert there == {(b, a) for a, b in there}
    a, b, c = np.moveaxis(vertices[triangles], 1, 0)
    assert np.einsum("ij,ij", a, np.cross(b, c)) / 6 == pytest.approx(volume(design), rel=1e-3)


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_step_is_a_valid_solid(rng, tmp_path, read_solid, outline):
    design = plate(rng, outline)
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


def test_the_face_in_iges_is_the_mirror(rng, tmp_path):
    design = plate(rng)
    with (tmp_path / "mirror.iges").open("wb") as file:
        deviation = write_iges(design, file)
    assert deviation.size < 1e-9
