"""Files of lenses with an elliptic outline: bodies that end at the ellipse."""

import numpy as np
import pytest
from PIL import Image

from workbench.files.export import maps
from workbench.files.export.meshes import write_stl
from workbench.files.export.step import write_step

ROUND = {"lens.outline": "ellipse"}
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


def test_meshes_are_closed_bodies_that_end_at_the_ellipse(make_design, closed_mesh):
    mesh = closed_mesh(write_stl, design := make_design(ROUND, chord_error=1e-3), ".stl")
    assert mesh.volume == pytest.approx(volume(design), rel=3e-3)
    x, y = mesh.vertices[:, 0], mesh.vertices[:, 1] / 0.7
    assert np.hypot(x, y).max() == pytest.approx(1, abs=1e-6)
    low = mesh.vertices[:, 2] == 0
    rim = low & (np.hypot(x, y) > 0.5)
    np.testing.assert_allclose(np.hypot(x, y)[rim], 1, atol=1e-6)


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
