"""The 3D scene, drawn off screen."""

import numpy as np
import pytest

from resources import path
from workbench.geometry.surface import sample_faces
from workbench.optics.paths import ray_paths
from workbench.pictures.compressed import compress_distances
from workbench.pictures.images import target_irradiance
from workbench.pictures.lens import LensPicture
from workbench.pictures.projection import Projection
from workbench.scene import DrawnTarget, Scene


@pytest.fixture
def state():
    def make(scene, offset=0.0, rays=(5, 5)):
        heights = np.full(scene.optic.net_shape, 0.5 + offset)
        return (
            sample_faces(scene.optic, {"lens.back": heights}, (17, 17)),
            ray_paths(scene, {"lens.back": heights}, rays),
            np.zeros(scene.receiver.pixels[::-1]),
        )

    return make


def drawn(plotter):
    plotter.render()
    return plotter.screenshot(return_img=True)


def screen_pixel(plotter, point):
    """Where a point of the scene is in the picture, (row, column)."""
    renderer = plotter.renderer
    renderer.SetWorldPoint(*point, 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    return plotter.window_size[1] - 1 - round(y), round(x)


@pytest.mark.parametrize("dark", [False, True])
def test_screen_reads_as_its_image(make_scene, plotter, state, dark):
    scene = make_scene({"screen.pixels": [8, 8]})
    letter = np.zeros((8, 8))
    letter[:, :3] = 1  # an L: bright at -x and at -y
    letter[5:] = 1
    picture = LensPicture(plotter, scene, letter, dark=dark)
    picture.fit()
    surface, paths, _ = state(scene, rays=(1, 1))
    picture.update(surface, paths, target_irradiance(scene, letter))
    pixels = drawn(plotter).astype(int).sum(axis=-1)

    def brightness(x, y):
        return pixels[screen_pixel(plotter, (x, y, scene.receiver.z))]

    assert brightness(-0.8, 0.8) > 300  # row 0, column 0: top left
    assert brightness(-0.8, -0.8) > 300
    assert brightness(0.8, -0.8) > 300
    assert brightness(0.8, 0.8) < 60
    left = screen_pixel(plotter, (-0.8, 0, scene.receiver.z))[1]
    right = screen_pixel(plotter, (0.8, 0, scene.receiver.z))[1]
    assert left < right  # the default view reads it unmirrored


@pytest.mark.parametrize(
    ("z", "lens", "screen"),
    [(5, 1.0, 1.0), (32, 0.64, 0.64), (32, 0.64, 6.0), (1.2, 1.0, 1.0), (500, 1.0, 100.0)],
)
def test_default_view_holds_lens_and_screen(make_scene, plotter, z, lens, screen):
    scene = make_scene(
        {"screen.z": z, "screen.half_width": [screen, screen], "lens.half_width": [lens, lens]}
    )
    LensPicture(plotter, scene, np.ones((32, 32))).fit()
    width, height = plotter.window_size
    spots = {}
    for name, r, at in (("lens", lens, 0.0), ("screen", screen, float(z))):
        corners = [screen_pixel(plotter, (i * r, j * r, at)) for i in (-1, 1) for j in (-1, 1)]
        rows, columns = np.array(corners).T
        assert rows.min() >= 0 and rows.max() < height
        assert columns.min() >= 0 and columns.max() < width
        spots[name] = rows.max() - rows.min()
    larger = "screen" if screen >= lens else "lens"
    assert spots[larger] > height / 4


def test_update_keeps_camera_and_actors(make_scene, plotter, state):
    scene = make_scene()
    picture = LensPicture(plotter, scene, np.ones((32, 32)))
    picture.fit()
    picture.update(*state(scene))
    assert picture.fitted
    plotter.camera.azimuth = 20
    assert not picture.fitted
    camera, actors = plotter.camera_position, list(plotter.actors)
    before = drawn(plotter)
    picture.update(*state(scene, offset=0.3, rays=(3, 3)))
    assert plotter.camera_position == camera
    assert list(plotter.actors) == actors
    assert (drawn(plotter) != before).any()
    picture.fit()
    assert picture.fitted


@pytest.mark.parametrize("explode", [False, True])
def test_each_receiver_shows_its_own_light(make_scene, plotter, state, explode):
    far = {"screen": {"z": 40.0, "half_width": [1, 1], "pixels": [8, 8]}, "target": {"image": "a"}}
    scene = make_scene({"screen.pixels": [8, 8], "further_images": [far]})
    even = np.ones((8, 8))
    image = scene.images[1].drawn_as(DrawnTarget(even))
    scene = scene.with_images((scene.images[0], image))
    picture = LensPicture(plotter, scene, even, explode=explode)
    picture.fit("axis")
    surface, paths, _ = state(scene, rays=(1, 1))
    picture.update(surface, paths, 0 * even, further=[target_irradiance(scene, even)])
    shown = compress_distances(scene) if explode else scene
    place = (0.5, 0.5, shown.images[1].receiver.z)
    assert shown.receiver.z < place[2] <= 40.0  # seen from beyond, the far one is in front
    row, column = screen_pixel(plotter, place)
    assert drawn(plotter).astype(int).sum(axis=-1)[row, column] > 300


def test_both_faces_are_drawn_where_they_are(make_scene, plotter):
    scene = make_scene({"version": 2, "lens.entrance": {"shape": "freeform"}})
    entrance, exit_face = np.full((12, 10), 0.1), np.full((12, 10), 0.5)
    entrance[5:7, 4:6] = -0.4
    heights = {"lens.front": entrance, "lens.back": exit_face}
    picture = LensPicture(plotter, scene, np.ones((32, 32)))
    faces = sample_faces(scene.optic, heights, (33, 33))
    picture.update(faces, ray_paths(scene, heights, (3, 3)), np.zeros((32, 32)))
    meshes = [
        actor.mapper.dataset
        for actor in plotter.actors.values()
        if actor.GetPickable() and hasattr(actor, "mapper")
    ]
    (dented,) = (mesh for mesh in meshes if mesh.points[:, 2].min() < 0)
    assert dented.points[:, 2].min() == pytest.approx(faces["lens.front"][..., 2].min())
    (walls,) = (mesh for mesh in meshes if mesh.faces.size == 4 * 32 * 5)
    assert np.unique(walls.points[:, 2].round(6)).tolist() == pytest.approx([0.1, 0.5])


def test_all_elements_of_a_train_are_drawn_in_their_places(plotter):
    scene = Scene.from_json(path("examples", "dome-cover.json").read_text()).with_net((8, 8))
    dome, lens, cover = scene.elements
    turned = cover.model_copy(update={"position": (3.0, 0.0, 30.0), "tilt": (0.0, 90.0, 0.0)})
    scene = scene.model_copy(update={"elements": (dome, lens, turned)})
    picture = LensPicture(plotter, scene, np.ones((70, 145)))
    picture.fit("side")  # from -x
    plotter.render()
    sight = Projection(plotter)
    # The wall of the dome, its spherical face beside an edge of the mesh, and the front face of
    # the plate on its edge.
    for place in ((-2.4, 0, -9.6), (-np.sqrt(2.5**2 - 1.5**2 - 0.1**2), 0.1, -8.4), (3.0, 20, 12)):
        ((x, y),) = sight.pixels(np.array([place]))
        assert sight.point(x, y) == pytest.approx(np.array(place), abs=0.3)


def test_rays_of_a_train_end_where_they_are_lost():
    scene = Scene.from_json(path("examples", "dome-cover.json").read_text()).with_net((8, 8))
    heights = {"lens.back": np.full((8, 8), 5.0)}
    points = ray_paths(scene, heights, (15, 15)).points
    beside = np.hypot(points[:, 2, 0], points[:, 2, 1]) > 2.4 + 1e-9  # the back of the dome
    assert 0 < beside.sum() < len(points)
    assert (points[beside, 3:] == points[beside, 2:3]).all()
    assert (points[~beside, 3, 2] > points[~beside, 2, 2]).all()


def test_glass_hides_more_at_grazing_angles(make_scene, plotter):
    scene = make_scene()
    picture = LensPicture(plotter, scene, np.ones((32, 32)), dark=True)
    for actor in plotter.actors.values():
        actor.SetVisibility(bool(actor.GetPickable()))  # without nets, axes and edges
    sums = []
    for degrees in (10, 80):
        picture.fit("axis")
        picture.camera.turn(degrees, 0)
        plotter.set_background("black")
        row, column = screen_pixel(plotter, (0.1, 0.2, 0.5))
        sums.append(drawn(plotter)[row, column].astype(int).sum())
    assert sums[1] > 1.5 * sums[0] > 0


@pytest.mark.parametrize("lit", [False, True])
def test_light_at_the_edge_of_a_screen_glows_beyond_it(make_scene, plotter, state, lit):
    scene = make_scene({"screen.pixels": [8, 8]})
    picture = LensPicture(plotter, scene, np.ones((8, 8)), dark=True)
    picture.fit("axis")
    plotter.set_background("black")
    surface, paths, dark = state(scene, rays=(1, 1))
    picture.update(surface, paths, target_irradiance(scene, np.ones((8, 8))) if lit else dark)
    r_x, r_y = scene.receiver.half_width
    row, column = screen_pixel(plotter, (1.04 * r_x, 0.5 * r_y, scene.receiver.z))
    assert (drawn(plotter)[row, column].sum() > 20) == lit
