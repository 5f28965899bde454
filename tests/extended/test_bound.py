"""The bound of a scene: what is stated of it, and that it holds for lenses that are traced."""

import numpy as np
import pytest

from workbench.analysis.metrics import relative_l2
from workbench.analysis.validation import validate
from workbench.extended.bound import Bound
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import freeform_nets

GRID = {"kind": "grid", "center": [0, 0, -4], "half_width": [0.3, 0.3], "points": [9, 9]}


def square(pixels: int) -> np.ndarray:
    target = np.zeros((pixels, pixels))
    target[pixels // 4 : -pixels // 4, pixels // 4 : -pixels // 4] = 1
    return target


def test_source_without_an_extent_has_no_bound(make_scene):
    found = Bound(make_scene(), np.ones((32, 32)))
    assert found.relative_l2 == found.half_as_wide == 0
    assert found.on_receiver == found.on_target == 1
    (sentence,) = found.sentences
    assert "No size of this source" in sentence


def test_source_with_an_extent_is_told_its_least_error(make_scene):
    found = Bound(make_scene({"source": GRID}), square(32))
    assert 0 < found.relative_l2 <= found.deblurred.error
    assert found.half_as_wide < found.relative_l2
    sentence, *_ = found.sentences
    assert f"below {100 * found.relative_l2:.1f} % with this source" in sentence
    assert f"half as wide would allow {100 * found.half_as_wide:.1f} %" in sentence


def test_image_of_the_source_that_is_larger_than_the_receiver_limits_the_light(make_scene):
    source = GRID | {"half_width": [2.0, 1.0], "points": [100, 100]}
    scene = make_scene({"source": source})
    found = Bound(scene, square(32))
    (b_x, b_y), (n_x, n_y) = found.blur.widths, scene.receiver.pixels
    assert b_x > n_x and b_y > n_y
    assert found.on_receiver == pytest.approx(n_x * n_y / (b_x * b_y), rel=1e-3)
    assert found.on_target == pytest.approx(found.on_receiver / 4, rel=1e-3)
    assert any(
        f"At most {100 * found.on_receiver:.0f} % of the light can land on the receiver" in each
        for each in found.sentences
    )


def test_no_lens_of_some_shapes_is_below_the_bound(make_scene, rng):
    # Flat, curved and rough ones, by the independent check.
    scene = make_scene({"source": GRID})
    target = square(32)
    found = Bound(scene, target)
    n_u, n_v = scene.optic.net_shape
    u, v = np.linspace(-1, 1, n_u)[:, None], np.linspace(-1, 1, n_v)
    for heights in (
        np.full((n_u, n_v), 0.5),
        0.5 - 0.1 * (u**2 + v**2),
        0.5 - 0.2 * u**2 + 0.002 * rng.normal(size=(n_u, n_v)),
    ):
        image = validate(scene, target, FaceArrays({"lens.back": heights}), 200_000).irradiance
        assert relative_l2(image, target) > found.relative_l2


def test_bound_of_a_disc_of_parallel_light_holds_for_a_lens_that_is_traced(make_scene):
    sun = {"kind": "collimated", "angular_diameter": 4.0}
    scene = make_scene({"version": 2, "source": sun})
    target = square(32)
    found = Bound(scene, target)
    assert found.blur.shape == "ellipse"
    # The angle of the disc times the way to the screen, in pixels.
    away = scene.receiver.z - scene.optic.highest
    n_x, r_x = scene.receiver.pixels[0], scene.receiver.half_width[0]
    assert found.blur.widths[0] == pytest.approx(np.radians(4) * away * n_x / (2 * r_x))
    assert found.relative_l2 > 0.05
    plate = FaceArrays({"lens.back": np.full(scene.optic.net_shape, 0.5)})
    image = validate(scene, target, plate, 200_000).irradiance
    assert relative_l2(image, target) > found.relative_l2


def test_no_bound_is_certified_for_a_source_nearer_than_twice_the_width_of_the_lens(make_scene):
    # Its blur is not the same all over the lens.
    near, far = (
        Bound(make_scene({"source": GRID | {"center": [0, 0, z]}}), square(32))
        for z in (-3.99, -4.01)
    )
    assert far.certified and not near.certified
    (sentence,) = near.sentences
    assert "no bound is known" in sentence
    assert f"is {100 * near.deblurred.error:.1f} % off" in sentence
    assert near.to_data()["relative_l2_bound"] is None
    assert far.to_data()["relative_l2_bound"] > 0


def test_two_curved_faces_can_be_below_the_error_of_one_blur(make_scene):
    """A beam expander in the glass that focuses the sun: it narrows angles by 2 / 3."""
    n, thick, away, wider = 1.5, 2.0, 10.0, 1.5
    changes = {
        "version": 2,
        "source": {"kind": "collimated", "angular_diameter": 6.0},
        "lens.entrance": {
            "shape": "freeform",
            "control_points": [24, 24],
            "height_range": [-0.8, 0],
        },
        "lens.control_points": [24, 24],
        "lens.base.height": thick,
        "lens.height_range": [-0.8, 0.001],
        "screen.z": thick + away,
        "screen.half_width": [1.5, 1.5],
    }
    scene = make_scene(changes)
    spreading = n * (wider - 1) / thick  # power of the front face, which spreads the light
    focusing = 1 / away + spreading / wider
    nets = freeform_nets(scene.optic)
    x, y = nets["lens.back"].positions
    sag = (x[:, None] ** 2 + y**2) / (2 * (n - 1))
    faces = FaceArrays({"lens.front": -spreading * sag, "lens.back": thick - focusing * sag})
    row = (np.arange(32) + 0.5) / 32 * 3 - 1.5
    disc = away * np.radians(6.0) / wider / 2
    target = (np.hypot(row[:, None], row) < disc).astype(float)
    found, one = (
        Bound(scene, target),
        Bound(make_scene(changes | {"lens.entrance": {"shape": "flat"}}), target),
    )
    image = validate(scene, target, faces, 200_000).irradiance
    assert relative_l2(image, target) < 0.8 * found.relative_l2
    assert one.certified and not found.certified
    assert found.to_data()["relative_l2_bound"] is None
