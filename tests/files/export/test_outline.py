"""Files of lenses with an elliptic outline: bodies that end at the ellipse."""

import numpy as np
import pytest
from PIL import Image

from workbench.files.export import maps
from workbench.files.export.gltf import write_glb
from workbench.files.export.grid_sag import write_grid_sag
from workbench.files.export.iges import write_iges
from workbench.files.export.obj import write_obj
from workbench.files.export.ply import write_ply
from workbench.files.export.point_cloud import write_points
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
    thickness = design.net.at(x, y, design.heights)[0] - design.scene.optic.entrance_z
    return float((weights / 2) @ (radius * thickness).mean(axis=1)) * 2 * np.pi * r_x * r_y


@pytest.mark.parametrize("ending", MESHES)
def test_meshes_are_closed_bodies_that_end_at_the_ellipse(make_design, closed_mesh, ending):
    design = make_design(ROUND | {"unit": "m"}, chord_error=1e-3)
    mesh = closed_mesh(MESHES[ending], design, ending)
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


def test_maps_are_blank_beside_the_lens(make_design, write, small_grids):
    design = make_design(ROUND)
    shown = maps.height(design)
    inside = shown.x**2 + (shown.y[:, None] / 0.7) ** 2 <= 1
    np.testing.assert_array_equal(np.isfinite(shown.values), inside)
    for writer, name in ((maps.write_npy, "a.npy"), (maps.write_tiff, "a.tiff")):
        path, deviation = write(writer, shown, name)
        assert deviation.size < 1e-6
        found = np.load(path) if name == "a.npy" else np.asarray(Image.open(path))
        np.testing.assert_array_equal(np.isfinite(found), inside)
    path, _ = write(maps.write_png, shown, "a.png")
    with Image.open(path) as image:
        assert image.info["Beside the lens"] == "black"
        assert np.asarray(image)[~inside].max() == 0
    path, _ = write(maps.write_csv, shown, "a.csv")
    assert len(path.read_text().splitlines()) == 1 + inside.sum()


def test_points_end_a_few_steps_beside_the_lens(make_design, write, small_grids):
    path, deviation = write(write_points, make_design(ROUND), "a.xyz")
    x, y, *_ = np.loadtxt(path).T
    assert np.hypot(x / 1.2, y / (1.2 * 0.7)).max() < 1
    assert len(x) < 0.85 * len(np.unique(x)) * len(np.unique(y))
    assert deviation.size < 1e-3


def test_grid_sag_flags_points_without_data(make_design, write, small_grids):
    design = make_design(ROUND)
    path, _ = write(write_grid_sag, design, "a.dat")
    columns, rows = map(int, path.read_text().split()[:2])
    flags = np.loadtxt(path, skiprows=1)[:, 4].reshape(rows, columns)
    assert set(flags.ravel()) == {0.0, 1.0}
    x, y = np.linspace(-1, 1, columns), np.linspace(1, -1, rows)[:, None]
    assert (flags[np.hypot(x, y) <= 1] == 0).all()
    assert (flags[np.hypot(x, y) > 1.1] == 1).all()
