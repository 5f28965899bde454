"""The 3D scene: nets, handles, the line of sight, distances, looks of a face."""

import numpy as np
import pytest

from workbench.pictures import meshes
from workbench.pictures.lens import LensPicture
from workbench.pictures.projection import Projection
from workbench.pictures.surface import face_colours, scale_top

X, Y = np.meshgrid(np.linspace(-2, 2, 41), np.linspace(-1, 1, 31), indexing="ij")


def surface(z):
    return np.stack([X, Y, z + 0 * X], axis=-1)


def rgb(z, by):
    top = scale_top([surface(z)], by)
    return face_colours(surface(z), by, "#8fc1e8", top).reshape(41, 31, 3).astype(int)


def test_bowls_are_red_and_humps_blue():
    red, _, blue = np.moveaxis(rgb(0.1 * X**3, "curvature"), -1, 0)  # a hump at -x, a bowl at +x
    assert (red[35] > blue[35]).all()
    assert (red[5] < blue[5]).all()


def test_areas_beyond_limits_are_red_and_others_green():
    beyond = X > 0.5
    seen = face_colours(surface(0 * X), "limits", "#8fc1e8", 1.0, beyond).reshape(41, 31, 3)
    red, green, _ = np.moveaxis(seen.astype(int), -1, 0)
    np.testing.assert_array_equal(red > green, beyond)


@pytest.fixture(params=["parallel", "perspective"])
def plotter(request, plotter):
    plotter.camera.position, plotter.camera.focal_point = (4.0, -5.0, 3.0), (0.2, 0.1, 0.5)
    plotter.camera.up = (0.0, 0.0, 1.0)
    plotter.camera.parallel_projection = request.param == "parallel"
    plotter.camera.parallel_scale = 2.0
    plotter.camera.clipping_range = (0.1, 20.0)
    plotter.render()
    return plotter


def test_points_are_where_vtk_draws_them(plotter, rng):
    points = rng.uniform(-1, 1, (20, 3))
    seen = Projection(plotter).pixels(points)
    for point, pixel in zip(points, seen, strict=True):
        plotter.renderer.SetWorldPoint(*point, 1.0)
        plotter.renderer.WorldToDisplay()
        np.testing.assert_allclose(pixel, plotter.renderer.GetDisplayPoint()[:2], atol=0.02)


def test_the_line_of_sight_goes_through_its_point(plotter):
    point = np.array([[0.4, -0.3, 0.7]])
    sight = Projection(plotter)
    start, end = sight.line(*sight.pixels(point)[0])
    along = (end - start) / np.linalg.norm(end - start)
    away = point[0] - start
    assert np.linalg.norm(away - (away @ along) * along) < 2e-3


@pytest.fixture
def scene_sight(make_scene, plotter):
    """Looks at a picture of a scene from its first place."""
    scene = make_scene()
    LensPicture(plotter, scene, np.ones((32, 32))).fit()
    plotter.render()
    return scene, Projection(plotter)


def test_a_look_finds_the_body_under_the_pointer(scene_sight):
    scene, sight = scene_sight
    for place in ([0.2, 0.3, 0.5], [-0.4, 0.1, scene.receiver.z]):  # the exit face, the screen
        (pixel,) = sight.pixels(np.array([place]))
        np.testing.assert_allclose(sight.point(*pixel), place, atol=1e-3)


def plane(m_u, m_v, slope=0.0):
    x, y = np.meshgrid(np.linspace(-1, 1, m_u), np.linspace(-2, 2, m_v), indexing="ij")
    return np.stack([x, y, 0.5 + slope * x], axis=-1)


def test_quads_cover_the_grid_once():
    points = plane(4, 3).reshape(-1, 3)
    faces = meshes.quads(4, 3).reshape(-1, 5)
    assert (faces[:, 0] == 4).all() and len(faces) == 6
    a, b, c, d = (points[faces[:, k]] for k in (1, 2, 3, 4))
    area = np.cross(c - a, d - b)[:, 2] / 2
    assert (area > 0).all()  # seen from +z they turn left
    np.testing.assert_allclose(area.sum(), 2 * 4)


def test_normals_of_a_tilted_plane():
    found = meshes.normals(plane(5, 6, slope=0.75))
    np.testing.assert_allclose(found, np.tile([-0.6, 0.0, 0.8], (30, 1)), atol=1e-12)


def test_walls_and_exit_face_close_the_lens():
    """The flux of a constant field through a closed surface is nothing, that of x is its volume."""
    surface = plane(5, 4, slope=0.1)
    volume, through = 0.0, np.zeros(3)
    for points, cells in (
        (surface.reshape(-1, 3), meshes.quads(5, 4)),
        (meshes.wall_points(surface, -1.0), meshes.wall_faces(5, 4)),
    ):
        for _, *corners in cells.reshape(-1, 5):
            a, b, c, d = points[corners]
            area = np.cross(c - a, d - b) / 2
            through += area
            volume += area @ points[corners].mean(axis=0) / 3
    np.testing.assert_allclose(through, 0, atol=1e-12)
    np.testing.assert_allclose(volume, 2 * 4 * 1.5)


def polygons(cells):
    """Cells one by one."""
    found, first = [], 0
    while first < len(cells):
        found.append(cells[first + 1 : first + 1 + cells[first]])
        first += 1 + cells[first]
    return found


@pytest.mark.parametrize("straight", [True, False])
def test_walls_between_two_faces_close_the_lens(straight):
    """The flux of a constant field through a closed surface is nothing, that of x is its volume."""
    surface = plane(5, 4, slope=0.1)
    other = surface - [0, 0, 1.5]
    other[..., 2] -= 0.3 * surface[..., 0] ** 2
    volume, through = 0.0, np.zeros(3)
    walls = meshes.wall_points(surface, other[..., 2])
    for points, cells, sign in (
        (surface.reshape(-1, 3), meshes.quads(5, 4), 1),
        (other.reshape(-1, 3), meshes.quads(5, 4), -1),
        (walls, meshes.wall_faces(5, 4, straight, flat=False), 1),
    ):
        for _, *corners in cells.reshape(-1, 5):
            a, b, c, d = points[corners]
            area = sign * np.cross(c - a, d - b) / 2
            through += area
            volume += area[2] * points[corners][:, 2].mean()
    np.testing.assert_allclose(through, 0, atol=1e-12)
    sizes = np.ptp(surface[..., 0]) * np.ptp(surface[..., 1])
    x = np.unique(surface[..., 0])
    expected = sizes * (1.5 + 0.3 * np.trapezoid(x**2, x) / np.ptp(x))
    np.testing.assert_allclose(volume, expected)
    lines = polygons(meshes.wall_lines(5, 4, straight, flat=False))
    feet = walls[np.concatenate([line for line in lines if len(line) > 2][1::2])]
    assert {tuple(place) for place in feet} < {tuple(p) for p in other.reshape(-1, 3)}
    assert sum(len(line) == 2 for line in lines) == 4 * straight
