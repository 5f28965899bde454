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
from workbench.scene.viewing import as_viewed, pixel_side, viewed_from
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
    """An image as it looks on the picture of a camera beside the optic, or beyond the receiver."""
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


@pytest.mark.parametrize("place", ["lens", "lens, tilted about y", "mirror, tilted"])
@pytest.mark.parametrize("side", ["front", "back"])
def test_light_of_a_designed_face_reads_right_from_the_named_side(place, side, tmp_path):
    scene = scene_of(place, tmp_path, viewed_from=side)
    target = load_target(scene, tmp_path)
    heights = {scene.optic.face: transport_start(scene, target)}
    light = seen(scene, validate(scene, target, heights, 50_000).irradiance, side)
    picture = np.kron(F, np.ones((8, 8)))
    right, wrong = (
        np.corrcoef(light.ravel(), p.ravel())[0, 1] for p in (picture, picture[:, ::-1])
    )
    assert right > 0.7
    assert right > wrong + 0.4


def test_targets_are_drawn_anew_for_other_viewers_and_for_light_that_goes_back(tmp_path):
    wall = begin(scene_of("lens", tmp_path, viewed_from="front"), tmp_path)
    behind = with_task(wall, scene_of("lens", tmp_path, viewed_from="back"), tmp_path)
    np.testing.assert_array_equal(behind.target, wall.target[:, ::-1])
    mirror = with_task(wall, scene_of("mirror", tmp_path, viewed_from="front"), tmp_path)
    np.testing.assert_array_equal(mirror.target, wall.target[:, ::-1])


def test_the_side_needs_version_2_and_comes_back_from_the_file(tmp_path):
    plain = Scene.from_data(changed({}))
    assert plain.to_data()["version"] == 1
    for side in ("front", "back"):
        data = plain.to_data()
        data["target"]["viewed_from"] = side
        scene = Scene.from_data(data)
        assert scene.to_data()["version"] == 2
        assert scene.to_data()["target"]["viewed_from"] == side
        assert Scene.from_json(scene.to_json()) == scene
