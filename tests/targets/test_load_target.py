import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from workbench.errors import Refused
from workbench.scene import Scene
from workbench.targets import load_target
from workbench.targets.colour import SRGB

F = np.array([[1, 1, 1, 1], [1, 0, 0, 0], [1, 1, 1, 0], [1, 0, 0, 0], [1, 0, 0, 0]])


def scene(target, pixels=(64, 64), half_width=(1.0, 1.0)):
    return Scene.from_data(
        {
            "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [8, 8]},
            "source": {"kind": "collimated"},
            "screen": {"z": 5, "half_width": half_width, "pixels": pixels},
            "target": target,
        }
    )


@pytest.fixture
def load(tmp_path):
    def load(picture, pixels=(64, 64), half_width=(1.0, 1.0), **finish):
        np.save(tmp_path / "picture.npy", np.asarray(picture, dtype=float))
        target = {"image": "picture.npy", **finish}
        return load_target(scene(target, pixels, half_width), tmp_path)

    return load


def test_orientation_row_0_stays_on_top_and_column_0_on_the_left(load):
    light = load(F, pixels=(8, 10), half_width=(4.0, 5.0))
    np.testing.assert_allclose(light, np.kron(F, np.ones((2, 2))), atol=1e-13)
    screen = scene({"builtin": "tophat"}, (8, 10), (4.0, 5.0)).receiver
    column, row = screen.to_pixels(3.5, 4.5)  # right end of the letter's top bar
    assert light[int(row), int(column)] == 1
    column, row = screen.to_pixels(3.5, -4.5)  # nothing at the letter's lower right
    assert light[int(row), int(column)] == 0


def test_a_picture_of_the_pixels_is_taken_as_it_is(load, rng):
    picture = rng.random((20, 16))
    light = load(picture, (16, 20), (4.0, 5.0))
    np.testing.assert_array_equal(light, picture / picture.max())
    padded = load(picture, (16, 20), (4.0, 5.0), padding=0.1)
    assert padded.sum() < light.sum() and not padded[0].any()


@pytest.mark.parametrize(
    ("shape", "pixels", "half_width", "bright"),
    [
        ((10, 20), (64, 64), (1.0, 1.0), np.s_[16:48, :]),  # wide picture, square screen
        ((20, 10), (64, 64), (1.0, 1.0), np.s_[:, 16:48]),
        ((10, 10), (64, 64), (2.0, 1.0), np.s_[:, 16:48]),  # wide pixels
        ((10, 10), (40, 80), (1.0, 1.0), np.s_[:, :]),  # tall pixels, square screen
        ((3, 4), (100, 80), (4.0, 4.0), np.s_[10:70, :]),
    ],
)
def test_aspect_is_kept_and_the_rest_is_black(load, shape, pixels, half_width, bright):
    light = load(np.ones(shape), pixels, half_width)
    expected = np.zeros(pixels[::-1])
    expected[bright] = 1
    np.testing.assert_allclose(light, expected, atol=1e-12)


@given(
    shape=st.tuples(st.integers(1, 30), st.integers(1, 30)),
    pixels=st.tuples(st.integers(1, 40), st.integers(1, 40)),
    half_width=st.tuples(st.floats(0.1, 10), st.floats(0.1, 10)),
    padding=st.floats(0, 0.45),
    seed=st.integers(0, 2**32 - 1),
)
def test_light_is_conserved(tmp_path_factory, shape, pixels, half_width, padding, seed):
    picture = np.random.default_rng(seed).random(shape)
    path = tmp_path_factory.getbasetemp() / "any.npy"
    np.save(path, picture)
    task = scene({"image": str(path), "padding": padding}, pixels, half_width)
    light = load_target(task, path.parent)
    inside = 1 - 2 * padding
    side = 2 * inside * min(half_width[0] / shape[1], half_width[1] / shape[0])
    flux = (picture / picture.max()).sum() * side**2
    assert light.shape == pixels[::-1]
    assert light.min() >= 0
    assert light.max() <= 1 + 1e-12
    assert light.sum() * task.receiver.pixel_measure == pytest.approx(flux, rel=1e-9)


def test_padding_leaves_a_black_border_on_every_side(load):
    light = load(np.ones((5, 5)), pixels=(40, 40), padding=0.1)
    expected = np.zeros((40, 40))
    expected[4:36, 4:36] = 1
    np.testing.assert_allclose(light, expected, atol=1e-12)


def test_blur_spreads_light_and_loses_what_leaves_the_screen(load):
    point = np.zeros((41, 41))
    point[20, 20] = 1
    light = load(point, pixels=(41, 41), blur=2.0)
    offset = np.arange(41) - 20
    variance = np.average(offset**2, weights=light.sum(axis=0))
    assert light.sum() == pytest.approx(1)
    assert variance == pytest.approx(4, rel=2e-3)
    np.testing.assert_allclose(light, light.T, atol=1e-15)
    corner = np.zeros((41, 41))
    corner[0, 0] = 1
    sampled = np.exp(-(np.arange(-8, 9) ** 2) / 8)
    kept = sampled[8:].sum() / sampled.sum()
    assert load(corner, pixels=(41, 41), blur=2.0).sum() == pytest.approx(kept**2)


def test_turns_and_cuts_come_in_this_order(load):
    np.testing.assert_allclose(load(F, (5, 4), (5, 4), turn="left"), np.rot90(F), atol=1e-12)
    np.testing.assert_allclose(load(F, (5, 4), (5, 4), turn="right"), np.rot90(F, 3), atol=1e-12)
    np.testing.assert_allclose(load(F, (4, 5), (4, 5), turn="around"), F[::-1, ::-1], atol=1e-12)
    cut = load(F, (3, 2), (3, 2), crop=[0, 0.2, 0.25, 0.4])
    np.testing.assert_allclose(cut, F[1:3, :3], atol=1e-12)
    cut = load(F, (2, 3), (2, 3), crop=[0, 0.2, 0.25, 0.4], turn="left")
    np.testing.assert_allclose(cut, np.rot90(F[1:3, :3]), atol=1e-12)


def test_levels_change_pixel_values_before_they_become_light(load):
    steps = np.array([[0.1, 0.2, 0.4, 0.6, 0.8, 1.0]])
    size = (6, 1), (6.0, 1.0)
    cut = load(steps, *size, black=0.2, white=0.8)
    np.testing.assert_allclose(cut, [[0, 0, 1 / 3, 2 / 3, 1, 1]], atol=1e-12)
    brighter = load(steps, *size, black=0.2, white=0.8, gamma=2.0)
    np.testing.assert_allclose(brighter, np.sqrt(cut), atol=1e-12)
    np.testing.assert_allclose(load(steps, *size, gamma=0.5), steps**2, atol=1e-12)
    # Inversion comes first: what was bright is below the black level.
    inverted = load(steps, *size, black=0.5, invert=True)
    np.testing.assert_allclose(inverted, [[0.8, 0.6, 0.2, 0, 0, 0]], atol=1e-12)


def test_levels_are_of_values_as_stored_and_of_the_crop(tmp_path):
    values = np.array([[51, 102, 204, 255]], dtype=np.uint8)
    Image.fromarray(values).save(tmp_path / "picture.png")
    target = {"image": "picture.png", "tone": "srgb", "black": 0.2}
    light = load_target(scene(target, (4, 1), (4.0, 1.0)), tmp_path)
    np.testing.assert_allclose(light, SRGB.light((values / 255 - 0.2) / 0.8), atol=1e-12)
    cut = {**target, "crop": [0, 0, 0.5, 0], "tone": "linear"}  # 102 is the brightest there
    light = load_target(scene(cut, (2, 1), (2.0, 1.0)), tmp_path)
    np.testing.assert_allclose(light, [[(0.5 - 0.2) / 0.8, 1]], atol=1e-12)


def test_levels_that_leave_no_light_are_refused(load):
    with pytest.raises(Refused, match="black all over") as refused:
        load([[0.5, 1.0]], (2, 1), (2.0, 1.0), invert=True, black=0.5)
    assert refused.value.path == "target.black"
    with pytest.raises(Refused, match=r"at least 0\.51") as refused:
        scene({"image": "picture.npy", "black": 0.5, "white": 0.5})
    assert refused.value.path == "target.white"


def test_files_name_levels_only_where_they_differ():
    plain = scene({"image": "picture.npy", "black": 0.0})
    assert not {"black", "white", "gamma"} & plain.to_data()["images"][0]["target"].keys()
    levelled = scene({"image": "picture.npy", "black": 0.1, "gamma": 1.5})
    written = levelled.to_data()["images"][0]["target"]
    assert (written["black"], written["gamma"]) == (0.1, 1.5) and "white" not in written
    assert Scene.from_json(levelled.to_json()) == levelled


@pytest.mark.parametrize("builtin", ["rectangle", "ring", "beam", "text"])
def test_shapes_are_written_and_read_back(builtin):
    task = scene({"builtin": builtin})
    assert Scene.from_json(task.to_json()) == task
