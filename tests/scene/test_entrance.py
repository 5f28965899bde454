"""The entrance face of a lens: flat, or a second B-spline whose range is known beforehand."""

import numpy as np
import pytest

from tests.scene.test_images import SECOND
from workbench.design.limits import HeightLimits, bounded, undesigned
from workbench.errors import Refused
from workbench.geometry.surface import freeform_nets
from workbench.scene import PlaneFace, Scene, SplineFace

FREEFORM = {"shape": "freeform"}


def test_a_lens_has_a_plane_entrance_face(make_scene):
    scene = make_scene()
    assert scene.optic.entrance == PlaneFace()
    assert list(freeform_nets(scene.optic)) == ["lens.back"]
    assert scene.optic.entrance_range == (0.0, 0.0)


def test_a_freeform_entrance_face_comes_back(make_scene):
    given = {"shape": "freeform", "control_points": [7, 9], "degree": [2, 4]}
    scene = make_scene({"lens.entrance": {**given, "height_range": [-0.1, 0.2]}})
    assert Scene.from_json(scene.to_json()) == scene
    net = freeform_nets(scene.optic)["lens.front"]
    assert (net.shape, net.degree, net.half_width) == ((7, 9), (2, 4), (1.0, 1.0))


def test_an_entrance_net_follows_the_exit_net_unless_it_is_given(make_scene):
    lens = make_scene({"lens.entrance": FREEFORM}).optic
    assert lens.entrance == SplineFace()
    nets = freeform_nets(lens)
    assert nets["lens.front"] == nets["lens.back"]
    assert list(nets) == ["lens.front", "lens.back"]  # as light meets them


def test_sources_are_judged_at_the_lowest_place_of_the_entrance_face(make_scene):
    entrance = {**FREEFORM, "height_range": [-0.5, 0.1]}
    near = {"kind": "point", "position": [0, 0, -0.4]}
    assert make_scene({"lens.entrance": entrance}).optic.front_z == -0.5
    make_scene({"lens.entrance": FREEFORM, "source": near})
    with pytest.raises(Refused, match=r"source.position\[2\]: -0.4 is not before"):
        make_scene({"lens.entrance": entrance, "source": near})


@pytest.mark.parametrize(
    ("changes", "rise"),
    [
        ({}, 0.25),
        ({"lens.height_range": None}, 0.25),
        ({"lens.height_range": [-0.3, -0.1]}, (0.5 - 0.1 - 0.05) / 2),
        ({"lens.height_range": None, "lens.max_thickness": 0.3}, (0.3 - 0.05) / 2),
    ],
)
def test_an_automatic_entrance_face_shares_the_glass_with_the_exit_face(make_scene, changes, rise):
    lens = make_scene({"lens.entrance": FREEFORM, **changes}).optic
    assert lens.front_z == 0.0
    assert lens.entrance_range == pytest.approx((0.0, rise))
    assert lens.z_min == pytest.approx(rise + 0.05)


def test_an_automatic_entrance_face_rises_by_no_more_than_half_the_way_from_the_source(make_scene):
    near = {"source": {"kind": "point", "position": [0, 0, -0.2]}}
    automatic = bounded(make_scene({"lens.entrance": FREEFORM, **near}))
    assert automatic.entrance_range == pytest.approx((0.0, 0.1))
    assert automatic.z_min == pytest.approx(0.1 + 0.05)
    own = {**FREEFORM, "height_range": [-0.1, 0.3]}
    assert bounded(make_scene({"lens.entrance": own, **near})).entrance_range == (-0.1, 0.3)


def test_an_automatic_entrance_face_has_half_of_thick_glass_for_several_images(make_scene):
    thick = {"lens.entrance": FREEFORM, "lens.height_range": None, "lens.base.height": 1.05}
    assert bounded(make_scene(thick)).entrance_range == pytest.approx((0.0, 0.25))
    several = bounded(make_scene({**thick, "further_images": [SECOND]}))
    assert several.entrance_range == pytest.approx((0.0, 0.5))
    assert several.z_min == pytest.approx(0.5 + 0.05)
    near = {"source": {"kind": "point", "position": [0, 0, -0.8]}}
    near_range = bounded(make_scene({**thick, **near, "further_images": [SECOND]})).entrance_range
    assert near_range == pytest.approx((0.0, 0.4))


@pytest.mark.parametrize("entrance", [FREEFORM, {**FREEFORM, "height_range": [-0.2, 0.3]}])
def test_limits_keep_both_faces_apart_by_the_minimal_thickness(make_scene, entrance):
    lens = make_scene({"lens.entrance": entrance}).optic
    limits = HeightLimits.of_faces(lens)
    assert limits["lens.back"].lower.min() - limits["lens.front"].upper.max() >= 0.05 - 1e-15
    heights = undesigned(lens)
    assert all(limits[face].hold(each) for face, each in heights.items())


def test_an_undesigned_entrance_face_is_in_the_middle_of_its_own_range(make_scene):
    lens = make_scene({"lens.entrance": {**FREEFORM, "height_range": [-0.2, 0.1]}}).optic
    np.testing.assert_allclose(undesigned(lens)["lens.front"], -0.05)


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
            r"lens.height_range\[1\]: 0.3 is below the minimal thickness",
        ),
        (
            {"height_range": [-0.1, 0.3]},
            {"lens.max_thickness": 0.3},
            r"lens.max_thickness: 0.3 is below the minimal thickness",
        ),
        ({"shape": "round"}, {}, r"lens.entrance.shape: 'round' is not available"),
        ({"radius": 1}, {}, r"lens.entrance.radius: unknown field"),
    ],
)
def test_impossible_entrance_faces_are_refused(make_scene, entrance, changes, reason):
    with pytest.raises(Refused, match=reason):
        make_scene({"lens.entrance": {**FREEFORM, **entrance}, **changes})


def test_lengths_of_an_entrance_face_are_converted(make_scene):
    entrance = {**FREEFORM, "height_range": [-0.2, 0.1]}
    lens = make_scene({"lens.entrance": entrance}).in_unit("mm").optic
    assert lens.entrance.height_range == (-2.0, 1.0)
    assert lens.entrance_range == (-2.0, 1.0)
