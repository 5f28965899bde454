"""Control nets, handles and picked parts in the 3D scene."""

import numpy as np
import pytest

from resources import path
from workbench.pictures.control_net import ControlNetPicture
from workbench.pictures.handles import Handles, handles_of, part_at
from workbench.pictures.lens import LensPicture
from workbench.pictures.projection import Projection
from workbench.scene import Scene


@pytest.fixture
def net(make_scene, plotter):
    """The net of 12 × 10 control points, seen as the default view has it; one of them marked."""
    scene = make_scene()
    LensPicture(plotter, scene, np.ones((32, 32))).fit()
    net = ControlNetPicture(plotter, scene.optic, "lens.back")
    net.update(np.full((12, 10), 0.5))
    net.mark((0, 0))
    plotter.render()
    return net


def in_window(plotter, point):
    """Pixels of a point of the scene, from the lower left."""
    plotter.renderer.SetWorldPoint(*point, 1.0)
    plotter.renderer.WorldToDisplay()
    return plotter.renderer.GetDisplayPoint()[:2]


def test_nothing_is_picked_beside_the_lens(net, plotter):
    assert net.pick(1, 1) is None


def test_points_of_the_entrance_face_lie_outside_the_glass(make_scene, plotter):
    scene = make_scene({"lens.entrance": {"shape": "freeform", "control_points": [6, 7]}})
    LensPicture(plotter, scene, np.ones((32, 32))).fit("entrance")
    net = ControlNetPicture(plotter, scene.optic, "lens.front")
    net.update(np.zeros((6, 7)))
    net.show(True)
    assert shown(net._points) == 42 and (net._points._mesh.points[:, 2] < 0).all()
    plotter.render()
    for index in [(0, 0), (5, 0), (2, 4)]:
        assert net.pick(*in_window(plotter, net.places(index))) == index


def shown(dots):
    return dots._mesh.n_points if dots._actor.visibility else 0


@pytest.mark.parametrize("view", ["", "side", "top", "axis"])
def test_points_of_a_fine_net_are_picked_where_they_are_seen(make_scene, plotter, view, rng):
    scene = make_scene({"lens.control_points": [64, 50]})
    LensPicture(plotter, scene, np.ones((32, 32))).fit(view)
    net = ControlNetPicture(plotter, scene.optic, "lens.back")
    # Tilted, so that none hides another when seen from the side or from above.
    tilt = np.linspace(-0.2, 0.2, 64)[:, None] + np.linspace(-0.1, 0.1, 50)
    net.update(0.5 + tilt)
    net.show(True)
    plotter.camera.zoom(4)
    plotter.render()
    for index in rng.integers(0, (64, 50), (20, 2)):
        place = net.places(tuple(index))
        i, j = net.pick(*in_window(plotter, place))
        seen = np.array([in_window(plotter, place), in_window(plotter, net.places((i, j)))])
        assert np.abs(seen[0] - seen[1]).max() < 1.5  # itself, or another on the same pixel


POINT = {"kind": "point", "position": [0.1, 0.2, -3.0]}


GRID = {
    "kind": "grid",
    "center": [0.1, 0.0, -3.0],
    "half_width": [0.8, 0.5],
    "points": [5, 5],
    "rays": 10,
}


@pytest.fixture
def handles(make_scene, plotter):
    def make(source):
        scene = make_scene({"source": source})
        LensPicture(plotter, scene, np.ones((32, 32))).fit()
        made = Handles(plotter)
        made.show(scene)
        plotter.ren_win.Render()
        return made, scene.source

    return make


def test_a_point_is_its_own_handle(handles, plotter):
    made, source = handles(POINT)
    ((x, y),) = Projection(plotter).pixels(np.array([source.position]))
    assert made.pick(x + 5, y - 5).path == "source.position"
    assert made.pick(x + 30, y) is None
    made.show(None)
    assert made.pick(x, y) is None


def test_a_grid_has_corners_and_a_middle(handles, plotter):
    made, _ = handles(GRID)
    corners = [[-0.7, -0.5, -3.0], [-0.7, 0.5, -3.0], [0.9, -0.5, -3.0], [0.9, 0.5, -3.0]]
    seen = Projection(plotter).pixels(np.array([*corners, [0.1, 0.0, -3.0], [0.5, 0.25, -3.0]]))
    picked = [made.pick(x, y) for x, y in seen]
    assert picked[:4] == made.shown[:4] and picked[4] == picked[5] == made.shown[4]
    assert [handle.path for handle in picked[3:5]] == ["source.half_width", "source.position"]


def dragged(scene, path, by):
    """The scene after a drag of the last handle of a field, to three decimals."""
    handle = [each for each in handles_of(scene) if each.path == path][-1]
    return handle.change(scene, np.array(by), 3)


def test_moving_rounds_to_what_a_person_would_type(make_scene):
    scene = make_scene({"source": POINT})
    by = [0.01234567, -0.1, 0.00001]
    assert dragged(scene, "source.position", by).source.position == (0.112, 0.1, -3.0)
    back = dragged(scene, "source.position", -np.array(scene.source.position) - 1e-9)
    assert str(back.source.position) == "(0.0, 0.0, 0.0)"  # not -0
    grid = make_scene({"source": GRID})
    assert dragged(grid, "source.position", by).source.position == (0.112, -0.1, -3.0)
    wider = dragged(grid, "source.half_width", [0.1, -0.2, 0.0]).source
    assert wider.half_width == (0.9, 0.3) and wider.position == grid.source.position


def test_a_single_lens_is_moved_and_thickened(make_scene):
    scene = make_scene()
    lens = scene.elements[0]
    moved = dragged(scene, "elements[0].position", [0.0, 0.1, -0.2]).elements[0]
    assert moved.position == pytest.approx(np.add(lens.position, (0, 0.1, -0.2)))
    thicker = dragged(scene, "elements[0].thickness", [0.5, 0.0, 0.12]).elements[0]
    assert thicker.thickness == pytest.approx(lens.thickness + 0.12)
    assert thicker.position == lens.position


def test_a_tilted_lens_is_thickened_along_its_own_axis():
    scene = Scene.from_json(path("examples", "tilted-lens.json").read_text())
    number = next(k for k, element in enumerate(scene.elements) if any(element.tilt))
    lens, name = scene.elements[number], f"elements[{number}].thickness"
    (handle,) = (each for each in handles_of(scene) if each.path == name)
    (axis,) = handle.directions[0]
    assert abs(axis[2]) < 1 and np.linalg.norm(axis) == pytest.approx(1)
    thicker = handle.change(scene, 0.1 * axis, 6)
    assert thicker.elements[number].thickness == pytest.approx(lens.thickness + 0.1)
    (after,) = (each for each in handles_of(thicker) if each.path == name)
    np.testing.assert_allclose(after.place - handle.place, 0.1 * axis, atol=1e-9)


def test_the_part_at_a_pixel_is_the_one_in_front(make_scene, plotter):
    scene = make_scene({"source": POINT})
    LensPicture(plotter, scene, np.ones((32, 32))).fit("top")
    plotter.render()
    sight = Projection(plotter)

    def at(*place):
        ((x, y),) = sight.pixels(np.array([place]))
        seen = part_at(scene, sight, x, y)
        return seen and (seen.path, seen.called)

    assert at(*POINT["position"]) == ("source", "source")
    assert at(0.0, 0.0, 0.25) == ("elements[0]", "lens")
    assert at(0.0, 0.0, -1.5) is None  # between them
    LensPicture(plotter, scene, np.ones((32, 32))).fit("screen")
    plotter.render()
    assert at(0.5, 0.5, 5.0) == ("images[0].receiver", "screen")


def test_nets_of_tilted_elements_stand_where_the_elements_do(plotter, rng):
    scene = Scene.from_json(path("examples", "tilted-lens.json").read_text()).with_net((9, 8))
    picture = LensPicture(plotter, scene, np.ones((128, 128)))
    picture.fit("lens")
    net = ControlNetPicture(plotter, scene.optic, "lens.back")
    net.update(3 + 0.1 * rng.normal(size=(9, 8)))
    plotter.render()
    # The face, which is drawn in its place, is as far along the line of sight as its net.
    ((x, y),) = Projection(plotter).pixels(net.places((4, 4))[None])
    assert net.pick(x, y) == (4, 4)
    assert Projection(plotter).point(x, y) == pytest.approx(net.places((4, 4)), abs=0.5)
