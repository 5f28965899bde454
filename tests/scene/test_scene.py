"""The scene file: what it may leave out, what is refused and how that is stated."""

import math

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.scene import (
    AutoRun,
    FarField,
    FlatBase,
    GaussianFilter,
    PlacedBase,
    Scene,
    Screen,
    SphereBase,
)


def test_a_scene_survives_its_file(make_scene):
    scene = make_scene({"lens.base": {"shape": "sphere", "height": 0.5, "radius": 8.0}})
    assert Scene.from_json(scene.to_json()) == scene
    assert Scene.from_data(scene.to_data()) == scene


def test_only_the_starred_fields_are_needed():
    scene = Scene.from_data(
        {
            "lens": {"half_width": [1, 2], "refractive_index": 1.5, "control_points": [8, 8]},
            "source": {"kind": "collimated"},
            "screen": {"z": 10, "half_width": [1, 1], "pixels": [16, 16]},
            "target": {"image": "x.png"},
        }
    )
    assert scene.optic.degree == (3, 3)
    assert scene.optic.base == PlacedBase(FlatBase(), 1.0)
    assert scene.filter == GaussianFilter()
    assert scene.run == AutoRun()


@pytest.mark.parametrize(
    ("part", "value", "expected"),
    [
        ("run", {"iterations": 5}, AutoRun(iterations=5)),
        ("filter", {"size": [5, 5]}, GaussianFilter(size=(5, 5))),
    ],
)
def test_kinds_that_are_left_out_are_the_usual_ones(make_scene, part, value, expected):
    assert getattr(make_scene({part: value}), part) == expected


REFUSED = [
    (
        "lens.control_points",
        [3, 9],
        "lens.control_points[0]: 3 is too few for degree 3; at least 4",
    ),
    ("lens.control_points", [9, 9.5], "lens.control_points[1]: 9.5 is not a whole number"),
    ("lens.half_width", [1, -1], "lens.half_width[1]: -1 is too small; must be greater than 0"),
    ("lens.half_width", [1, "1"], "lens.half_width[1]: '1' is not a number"),
    ("lens.half_width", [1], "lens.half_width[1]: missing; it is required"),
    ("lens.half_width", [1, 1, 1], "lens.half_width: 3 values given; exactly 2"),
    ("lens.half_width", 1, "lens.half_width: 1 is not a list"),
    ("lens.degree", [0, 3], "lens.degree[0]: 0 is too small; at least 1"),
    ("lens.degree", [3, 8], "lens.degree[1]: 8 is too large; at most 7"),
    ("lens.sag", 1, "lens.sag: unknown field; known here: absorption, base"),
    ("lens.base", {"shape": "cone"}, "lens.base.shape: 'cone' is not available; allowed: 'flat'"),
    ("lens.base", {"height": 1, "radius": 2}, "lens.base.radius: unknown field"),
    (
        "lens.base",
        {"shape": "sphere", "height": 1, "radius": 1.4},
        "lens.base.radius: 1.4 does not span the lens; more than its half-diagonal 1.41421",
    ),
    ("lens.refractive_index", 1.0, "lens.refractive_index: 1.0; a number greater than 1"),
    ("lens.refractive_index", True, "lens.refractive_index: True is neither a number nor a name"),
    ("lens.refractive_index", "PMMA", "lens.wavelength_um: missing; it goes with 'PMMA'"),
    ("lens.height_range", [0.3, -0.3], "lens.height_range: [0.3, -0.3] is empty"),
    ("lens.height_range", [-0.5, -0.45], "lens.height_range[1]: -0.45 is below the minimal"),
    ("lens.max_thickness", 0.05, "lens.max_thickness: 0.05 is below the minimal"),
    ("lens.max_thickness", 0.2, "lens.height_range[0]: -0.3 is above the maximal"),
    ("lens.max_thickness", 0, "lens.max_thickness: 0"),
    ("source", {"kind": "laser"}, "source.kind: 'laser' is not available; allowed: 'collimated'"),
    ("source", {"kind": "point"}, "source.position: missing; it is required"),
    (
        "source",
        {"kind": "point", "position": [0, 0]},
        "source.position[2]: missing; it is required",
    ),
    (
        "source",
        {"kind": "point", "position": [0, 0, 0.2]},
        "source.position[2]: 0.2 is not before the entrance face; less than 0",
    ),
    (
        "source",
        {"kind": "point", "position": [9, 9, 7]},
        "source.position[2]: 7 is not before the entrance face; less than 0",
    ),
    (
        "source",
        {"kind": "point", "position": [0, 0, -5], "rays": 0},
        "source.rays: 0 is too small; at least 1",
    ),
    (
        "source",
        {"kind": "point", "position": [0, 0, -5], "rays": (1 << 24) + 1},
        "source.rays: 16777217 is too large; at most",
    ),
    (
        "source",
        {"kind": "point", "position": [0, 0, -5], "emission": "dark"},
        "source.emission: 'dark' is not available; allowed: 'uniform' or 'lambertian'",
    ),
    (
        "source",
        {"kind": "grid", "center": [0, 0, 0], "half_width": [1, 1], "points": [25, 25]},
        "source.center[2]: 0 is not before the entrance face; less than 0",
    ),
    (
        "source",
        {"kind": "grid", "center": [0, 0, -5], "half_width": [1, 1]},
        "source.points: missing; it is required",
    ),
    (
        "source",
        {
            "kind": "grid",
            "center": [0, 0, -5],
            "half_width": [1, 1],
            "points": [300, 300],
            "rays": 1000,
        },
        "source.rays: 1000 from each of 90000 points are too many; at most 16777216 rays in all",
    ),
    ("source", {}, "source.kind: missing; it is required"),
    ("screen.z", 0.8, "screen.z: 0.8 may touch the lens; more than 0.8"),
    ("screen.z", math.nan, "screen.z: nan is not finite"),
    ("screen.pixels", [0, 9], "screen.pixels[0]: 0 is too small; at least 1"),
    ("filter", {"size": [3, 4]}, "filter.size[1]: 4 is even; an odd number is needed"),
    (
        "filter",
        {"kind": "sinc"},
        "filter.kind: 'sinc' is not available; allowed: 'gaussian', 'box'",
    ),
    ("target", {"builtin": "cow"}, "target.builtin: 'cow' is not available; allowed: 'tophat'"),
    ("target", {}, "target.image: missing; it is required"),
    ("run", {"method": "best"}, "run.method: 'best' is not available; allowed: 'auto', 'paper'"),
    ("run.seed", -1, "run.seed: -1 is too small; at least 0"),
    ("version", 4, "version: 4 is not available; allowed: 1, 2 or 3"),
    ("unit", "foot", "unit: 'foot' is not available; allowed: 'mm', 'cm', 'm' or 'inch'"),
]


@pytest.mark.parametrize(("path", "value", "sentence"), REFUSED, ids=[s for _, _, s in REFUSED])
def test_refusals_name_the_field_the_value_and_what_is_allowed(make_scene, path, value, sentence):
    with pytest.raises(Refused) as refused:
        make_scene({path: value})
    assert str(refused.value).startswith(sentence)
    assert refused.value.path == sentence.split(":")[0]
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("text", ["", "{", "[]", "null", '{"lens": 5}', "\x00", '{"a": 1} x'])
def test_data_that_are_no_scene_are_refused_in_one_sentence(text):
    with pytest.raises(Refused) as refused:
        Scene.from_json(text)
    assert "\n" not in str(refused.value)


def test_a_material_gives_its_index(make_scene):
    glass = {"lens.refractive_index": "N-BK7", "lens.wavelength_um": 0.5876}
    assert make_scene(glass).optic.index == pytest.approx(1.5168, abs=1e-4)
    with pytest.raises(Refused, match=r"lens\.wavelength_um: 9 is outside the data for N-BK7"):
        make_scene(glass | {"lens.wavelength_um": 9.0})
    with pytest.raises(Refused, match=r"lens\.refractive_index: 'butter' is not in the catalogue"):
        make_scene(glass | {"lens.refractive_index": "butter"})


@pytest.mark.parametrize("value", ["x" * 10**6, [1.5] * 10**6])
def test_a_sentence_quotes_the_beginning_of_what_is_long(make_scene, value):
    with pytest.raises(Refused) as refused:
        make_scene({"lens.refractive_index": value, "lens.wavelength_um": 0.5})
    assert len(str(refused.value)) < 300


@pytest.mark.parametrize(("form", "sign"), [("concave", 1), ("convex", -1)])
def test_spherical_bases_follow_their_formula(form, sign):
    base = PlacedBase(SphereBase(radius=8.0, form=form), 0.5)
    x, y = np.array([0.0, 0.3, -1.0]), np.array([0.0, -0.2, 1.0])
    sphere = 0.5 + sign * (8 - np.sqrt(64 - x**2 - y**2))
    assert base.height_at(x, y) == pytest.approx(sphere, abs=1e-14)
    low, high = base.extent((1.0, 1.0))
    assert (low, high) == pytest.approx((sphere.min(), sphere.max()), abs=1e-14)


def test_image_rows_run_down_from_plus_y():
    screen = Screen(position=(0.0, 0.0, 5.0), half_width=(2.0, 1.0), pixels=(8, 4))
    assert screen.to_pixels(-2.0, 1.0) == (0, 0)
    assert screen.to_pixels(2.0, -1.0) == (8, 4)
    assert screen.to_pixels(0.25, 0.25) == (4.5, 1.5)
    assert screen.pixel_measure == 0.25


def test_a_scene_cannot_be_changed(make_scene):
    scene = make_scene()
    with pytest.raises(ValueError, match="frozen"):
        scene.optic.half_width = (2.0, 2.0)


@pytest.mark.parametrize(
    "receiver",
    [
        Screen(position=(0.0, 0.0, 5), half_width=(1.0, 2.0), pixels=(10, 40)),
        FarField(half_angle=(10.0, 20.0), pixels=(10, 40)),
    ],
)
def test_receiver_that_is_grown_keeps_its_pixels(receiver):
    grown = receiver.grown((3, 2))
    assert grown.pixels == (16, 44)
    (x, y), (half_x, half_y) = receiver.half_extent, grown.half_extent
    assert (half_x / 16, half_y / 44) == pytest.approx((x / 10, y / 40))
