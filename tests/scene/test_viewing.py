"""A viewer on the side that a target names sees it the right way round, wherever the receiver is.

What a viewer sees is found by a pinhole camera from where the receiver is in the scene.
"""

import numpy as np
import pytest

from tests.scenes import changed
from workbench.analysis.validation import validate
from workbench.design.task import begin, with_task
from workbench.design.transport import transport_start
from workbench.scene import Lens, Scene
from workbench.scene.image import as_viewed, pixel_side, side_in_words, viewed_from
from workbench.targets import load_target

F = np.array(
    [
        [1, 1, 1, 1],
        [1, 0, 0, 0],
        [1, 1, 1, 0],
        [1, 0, 0, 0],
        [1, 0, 0, 0],
    ]
)
_SCREEN = {"half_width": [0.8, 1.0], "pixels": [32, 40]}
_FAR = {"half_angle": [8.0, 10.0], "pixels": [32, 40]}
_MIRROR = {
    "lens": None,
    "mirror": {"half_width": [1.0, 1.0], "control_points": [24, 24]},
}
PLACES = {
    "lens": {"screen": {"z": 5.0, **_SCREEN}},
    "lens, screen beside the axis": {"screen": {"z": 5.0, "center": [2.0, -1.0], **_SCREEN}},
    "lens, tilted about x": {"screen": {"z": 5.0, "tilt": [50.0, 0.0], **_SCREEN}},
    "lens, tilted about y": {"screen": {"z": 5.0, "tilt": [0.0, -50.0], **_SCREEN}},
    "lens, table below": {
        "screen": {"z": 6.0, "center": [0.0, -4.0], "tilt": [75.0, 0.0], **_SCREEN}
    },
    "lens, far field": {"screen": None, "far_field": _FAR},
    "lens, far field aside": {"screen": None, "far_field": {**_FAR, "center": [30.0, -20.0]}},
    "mirror": _MIRROR | {"screen": {"z": -5.0, "center": [2.0, 0.0], **_SCREEN}},
    "mirror, tilted": _MIRROR
    | {"screen": {"z": -5.0, "center": [5.0, 0.0], "tilt": [0.0, -45.0], **_SCREEN}},
    "mirror, far field": _MIRROR | {"screen": None, "far_field": {**_FAR, "center": [30.0, 0.0]}},
}
every_place = pytest.mark.parametrize("place", PLACES)


def scene_of(place, folder, **target):
    np.save(folder / "f.npy", F.astype(float))
    target = {"image": str(folder / "f.npy"), **target}
    data = changed({"lens.control_points": [24, 24], "version": 2, "target": target})
    data |= PLACES[place]
    return Scene.from_data({name: part for name, part in data.items() if part is not None})


def seen(scene, light, side):
    """An image in the picture of a camera beside the element, or beyond the receiver."""
    receiver, (n_y, n_x) = scene.receiver, light.shape
    left, right, bottom, top = receiver.bounds
    u = left + (right - left) * (np.arange(n_x) + 0.5) / n_x
    v = top - (top - bottom) * (np.arange(n_y) + 0.5) / n_y
    places = receiver.drawn(scene.optic, u, v[:, None])
    middle, eye = places.mean(axis=(0, 1)), np.array([0.0, 0.0, scene.optic.leaving_z])
    if side == "back":
        eye = 2 * middle - eye
    ahead = (middle - eye) / np.linalg.norm(middle - eye)
    upwards = places[0, n_x // 2] - places[-1, n_x // 2]
    to_the_right = np.cross(ahead, upwards)
    x, y, depth = ((places - eye) @ axis for axis in (to_the_right, upwards, ahead))
    x, y = x / depth, y / depth
    return light[np.argsort(-y[:, n_x // 2])][:, np.argsort(x[n_y // 2])]


@every_place
@pytest.mark.parametrize("side", ["front", "back"])
def test_a_viewer_on_the_named_side_sees_the_picture_the_right_way_round(place, side, tmp_path):
    scene = scene_of(place, tmp_path, viewed_from=side)
    light = load_target(scene, tmp_path)
    other = {"front": "back", "back": "front"}[side]
    picture = np.kron(F, np.ones((8, 8)))
    np.testing.assert_allclose(seen(scene, light, side), picture, atol=1e-12)
    np.testing.assert_allclose(seen(scene, light, other), picture[:, ::-1], atol=1e-12)
    np.testing.assert_allclose(as_viewed(scene, light), picture, atol=1e-12)


@every_place
def test_without_a_side_column_0_lies_at_the_left_of_the_receivers_coordinates(place, tmp_path):
    scene = scene_of(place, tmp_path)
    light = load_target(scene, tmp_path)
    np.testing.assert_allclose(light, np.kron(F, np.ones((8, 8))), atol=1e-12)
    side = "back" if isinstance(scene.optic, Lens) else "front"
    assert viewed_from(scene) == pixel_side(scene) == side
    np.testing.assert_allclose(seen(scene, light, viewed_from(scene)), light)


@pytest.mark.parametrize(("turn", "quarters"), [("left", 1), ("around", 2), ("right", 3)])
def test_a_picture_is_turned_as_its_viewer_sees_it(turn, quarters, tmp_path):
    for side in ("front", "back"):
        scene = scene_of("lens", tmp_path, viewed_from=side, turn=turn, crop=[0.25, 0, 0, 0])
        plain = scene_of("lens", tmp_path, viewed_from="back", turn=turn, crop=[0.25, 0, 0, 0])
        light, wanted = load_target(scene, tmp_path), load_target(plain, tmp_path)
        np.testing.assert_allclose(seen(scene, light, side), wanted, atol=1e-12)
        assert np.rot90(F[:, 1:], quarters).shape[0] == (3 if quarters % 2 else 5)
        assert not np.allclose(wanted, wanted[:, ::-1])


@pytest.mark.parametrize("place", ["lens", "lens, tilted about y", "mirror, tilted"])
@pytest.mark.parametrize("side", ["front", "back"])
def test_light_of_a_designed_face_reads_right_from_the_named_side(place, side, tmp_path):
    scene = scene_of(place, tmp_path, viewed_from=side)
    target = load_target(scene, tmp_path)
    heights = {scene.optic.designed_face: transport_start(scene, target)}
    light = seen(scene, validate(scene, target, heights, 50_000).irradiance, side)
    picture = np.kron(F, np.ones((8, 8)))
    right, wrong = (
        np.corrcoef(light.ravel(), p.ravel())[0, 1] for p in (picture, picture[:, ::-1])
    )
    assert right > 0.7
    assert right > wrong + 0.4


def test_each_of_several_images_has_viewers_of_its_own(tmp_path):
    scene = scene_of("lens", tmp_path, viewed_from="front")
    further = {
        "receiver": scene.receiver.moved_to(6.0),
        "target": scene.target.altered(viewed_from="back"),
    }
    image = scene.images[0].altered(**further)
    session = begin(scene.with_images((scene.images[0], image)), tmp_path)
    first, second = (image.target for image in session.scene.wanted(session.target))
    np.testing.assert_array_equal(first, second[:, ::-1])
    assert not np.allclose(first, second)


def test_targets_are_drawn_anew_for_other_viewers_and_for_light_that_goes_back(tmp_path):
    wall = begin(scene_of("lens", tmp_path, viewed_from="front"), tmp_path)
    behind = with_task(wall, scene_of("lens", tmp_path, viewed_from="back"), tmp_path)
    np.testing.assert_array_equal(behind.target, wall.target[:, ::-1])
    mirror = with_task(wall, scene_of("mirror", tmp_path, viewed_from="front"), tmp_path)
    np.testing.assert_array_equal(mirror.target, wall.target[:, ::-1])


def test_a_target_without_a_viewer_stays_as_it_is_for_light_that_goes_back(tmp_path):
    lens = begin(scene_of("lens", tmp_path), tmp_path)
    task = scene_of("mirror", tmp_path)
    (tmp_path / "f.npy").unlink()
    assert with_task(lens, task, tmp_path).target is lens.target


def test_further_images_are_drawn_anew_for_light_that_goes_back(tmp_path):
    def several(place):
        scene = scene_of(place, tmp_path, viewed_from="front")
        return scene.with_images(2 * scene.images)

    lens = begin(several("lens"), tmp_path)
    mirror = with_task(lens, several("mirror"), tmp_path)
    before, after = (each.scene.images[1].wanted for each in (lens, mirror))
    np.testing.assert_array_equal(after, before[:, ::-1])


def test_the_side_comes_back_from_the_file(tmp_path):
    for side in ("front", "back"):
        scene = Scene.from_data(changed({"target.viewed_from": side}))
        assert scene.to_data()["images"][0]["target"]["viewed_from"] == side
        assert Scene.from_json(scene.to_json()) == scene


def test_the_side_is_stated_in_words(tmp_path):
    lens = scene_of("lens", tmp_path, viewed_from="front")
    assert side_in_words(lens, "front") == "viewed from the side of the light"
    assert side_in_words(lens, pixel_side(lens)) == "viewed from behind the screen"
    far = scene_of("lens, far field", tmp_path)
    assert side_in_words(far, viewed_from(far)) == "viewed from behind the far field"
