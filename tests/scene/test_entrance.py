"""The entrance face of a lens: flat, or a second B-spline whose room is known beforehand."""

import pytest

from workbench.design.limits import HeightLimits, undesigned
from workbench.errors import Refused

FREEFORM = {"shape": "freeform"}


@pytest.mark.parametrize(
    ("changes", "room"),
    [
        ({}, 0.25),
        ({"lens.height_range": None}, 0.25),
        ({"lens.height_range": [-0.3, -0.1]}, (0.5 - 0.1 - 0.05) / 2),
        ({"lens.height_range": None, "lens.max_thickness": 0.3}, (0.3 - 0.05) / 2),
    ],
)
def test_an_automatic_entrance_face_shares_the_glass_with_the_exit_face(make_scene, changes, room):
    lens = make_scene({"lens.entrance": FREEFORM, **changes}).optic
    assert lens.front_z == 0.0
    assert lens.entrance_range == pytest.approx((0.0, room))
    assert lens.floor == pytest.approx(room + 0.05)


@pytest.mark.parametrize("entrance", [FREEFORM, {**FREEFORM, "height_range": [-0.2, 0.3]}])
def test_limits_keep_both_faces_apart_by_the_minimal_thickness(make_scene, entrance):
    lens = make_scene({"lens.entrance": entrance}).optic
    limits = HeightLimits.of_faces(lens)
    assert limits["exit"].lower.min() - limits["entrance"].upper.max() >= 0.05 - 1e-15
    heights = undesigned(lens)
    assert all(limits[face].hold(each) for face, each in heights.items())


@pytest.mark.parametrize(
    ("entrance", "changes", "reason"),
    [
        (
            {"control_points": [3, 8]},
            {},
            r"lens.entrance.control_points\[0\]: 3 is too few for degree 3; at least 4",
        ),
        ({"degree": [3, 11]}, {}, r"lens.entrance.degree\[1\]: 11"),
        (
            {"degree": [3, 7]},
            {"lens.control_points": [8, 7]},
            r"lens.entrance.control_points\[1\]: 7 is too few for degree 7; at least 8",
        ),
        (
            {"height_range": [0.2, 0.2]},
            {},
            r"lens.entrance.height_range: \[0.2, 0.2\] is empty; low before high",
        ),
        (
            {"height_range": [0, 1e9]},
            {},
            r"lens.entrance.height_range\[1\]: 1e\+09 is too long",
        ),
        (
            {"height_range": [-0.1, 0.8]},
            {},
            r"lens.height_range\[1\]: 0.3 leaves no room above the minimal thickness",
        ),
        (
            {"height_range": [-0.1, 0.3]},
            {"lens.max_thickness": 0.3},
            r"lens.max_thickness: 0.3 leaves no room above the minimal thickness",
        ),
        ({"shape": "round"}, {}, r"lens.entrance.shape: 'round' is not available"),
        ({"radius": 1}, {}, r"lens.entrance.radius: unknown field"),
    ],
)
def test_impossible_entrance_faces_are_refused(make_scene, entrance, changes, reason):
    with pytest.raises(Refused, match=reason):
        make_scene({"lens.entrance": {**FREEFORM, **entrance}, **changes})
