"""Files of lenses with an elliptic outline: bodies that end at the ellipse."""

import numpy as np
import pytest
import trimesh

from workbench.files.export.gltf import write_glb
from workbench.files.export.iges import write_iges
from workbench.files.export.obj import write_obj
from workbench.files.export.ply import write_ply
from workbench.files.export.step import write_step
from workbench.files.export.stl import write_stl
from workbench.files.export.tessellation import Tessellation

ROUND = {"lens.outline": "ellipse"}
MESHES = {".stl": write_stl, ".obj": write_obj, ".ply": write_ply, ".glb": write_glb}
SIZES = pytest.mark.parametrize("half_width", [[1.0, 0.7], [0.7, 1.0], [1.0, 1.0]])


def volume(design):
    """By the trapezoid's rule around the axis, and Gauss's along it."""
    nodes, weights = np.polynomial.legendre.leggauss(200)
    angle = np.linspace(0, 2 * np.pi, 1000, endpoint=False)
    radius = ((nodes + 1) / 2)[:, None]
    r_x, r_y = design.net.half_width
    x, y = r_x * radius * np.cos(angle), r_y * radius * np.sin(angle)
    thickness = design.net.at(x, y, design.heights)[0] - design.scene.lens.entrance_z
    return float((weights / 2) @ (radius * thickness).mean(axis=1)) * 2 * np.pi * r_x * r_y


@pytest.mark.parametrize("ending", MESHES)
def test_meshes_are_closed_bodies_that_end_at_the_ellipse(make_design, write, ending):
    design = make_design(ROUND | {"unit": "m"}, chord_error=1e-3)
    path, deviation = write(MESHES[ending], design, f"lens{ending}")
    assert 0 < deviation.size <= 1e-3
    mesh = trimesh.load_mesh(path)
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.body_count == 1
    assert mesh.volume == pytest.approx(volume(design), rel=3e-3)
    x, y = mesh.vertices[:, 0], mesh.vertices[:, 1] / 0.7
    assert np.hypot(x, y).max() == pytest.approx(1, abs=1e-6)
    low = mesh.vertices[:, 2] == 0
    rim = low & (np.hypot(x, y) > 0.5)
    np.testing.assert_allclose(np.hypot(x, y)[rim], 1, atol=1e-6)


def test_the_chord_error_of_an_ellipse_is_kept(make_design, rng):
    design = make_design(ROUND, chord_error=1e-3)
    face = Tessellation.of(design)
    assert face.chord_error(design) <= 1e-3
    body = face.body()
    triangles = body.vertices[body.triangles[: 2 * (face.z.shape[0] - 1) ** 2]]
    x, y, z = np.einsum("tk,tkc->ct", rng.dirichlet([1, 1, 1], len(triangles)), triangles)
    assert np.abs(z - design.net.at(x, y, design.heights)[0]).max() <= 1e-3


@SIZES
def test_step_is_a_solid_with_an_exact_ellipse(make_design, write, read_solid, half_width):
    design = make_design(ROUND | {"lens.half_width": half_width})
    path, deviation = write(write_step, design, "lens.step")
    assert deviation.kind == "error of the rim"
    assert deviation.size < 1e-6
    found = read_solid(path)
    assert found.is_solid
    assert found.is_valid
    assert found.is_closed
    assert found.volume == pytest.approx(volume(design) * 1e3, rel=1e-4)  # cm to mm
    assert len(found.surfaces) == 6
    text = path.read_text()
    assert text.count("CIRCLE(" if half_width == [1.0, 1.0] else "ELLIPSE(") == 1


def test_iges_is_the_same_solid(make_design, write, read_solid):
    design = make_design(ROUND)
    path, _ = write(write_iges, design, "lens.iges")
    found = read_solid(path)
    assert found.is_valid
    assert found.volume == pytest.approx(volume(design) * 1e3, rel=1e-4)
