"""Samples that the points of a source share."""

import numpy as np
import pytest

from workbench.optics.lattice import make_lattice
from workbench.optics.transmittance import TransmittanceLaw
from workbench.scene import FlatBase

GRID = {"kind": "grid", "center": [0, 0, -5], "half_width": [1, 2]}


def grid(make_scene, points, **changes):
    return make_scene({"source": GRID | {"points": points, "rays": 1} | changes})


@pytest.mark.parametrize("points", [(1, 1), (1, 7), (2, 3), (5, 4), (25, 24), (64, 31)])
def test_points_take_equal_turns_that_are_mirror_symmetric(make_scene, points):
    scene = grid(make_scene, points)
    lattice = make_lattice(scene.source, scene.lens, (130, 100), TransmittanceLaw.of(scene.lens)[0])
    for axis, count, wanted in zip((lattice.x, lattice.y), points, (130, 100), strict=True):
        samples = len(axis.place)
        assert wanted <= samples < wanted + count
        numbers = axis.point.reshape(-1, count)
        assert (np.sort(numbers, axis=1) == np.arange(count)).all()
        assert (axis.point[::-1] == count - 1 - axis.point).all()
        assert axis.place == pytest.approx(-axis.place[::-1])
        assert axis.away == pytest.approx(-axis.away[::-1])
        for number in range(count):
            assert axis.width[axis.point == number].sum() == pytest.approx(2)


@pytest.mark.parametrize("points", [5, 8, 25, 31, 64])
def test_turns_have_no_trend(make_scene, points):
    scene = grid(make_scene, (points, 1))
    turn = make_lattice(
        scene.source, scene.lens, (points, 1), TransmittanceLaw.of(scene.lens)[0]
    ).x.point
    assert abs(np.corrcoef(np.arange(points), turn)[0, 1]) < 0.2


def test_a_constant_light_is_summed_exactly_for_each_point(make_scene):
    """The outer samples of a point stand for what is between them and the rim."""
    scene = grid(make_scene, (3, 4))
    lattice = make_lattice(scene.source, scene.lens, (30, 40), TransmittanceLaw.of(scene.lens)[0])
    weight = lattice.x.width[:, None] * lattice.y.width
    for i in range(3):
        for j in range(4):
            own = weight[lattice.x.point == i][:, lattice.y.point == j]
            assert own.sum() == pytest.approx(4)


def test_samples_of_one_point_are_the_middles_of_cells(make_scene):
    scene = make_scene({"source": {"kind": "point", "position": [0.5, 3, -2]}})
    lattice = make_lattice(scene.source, scene.lens, (4, 5), TransmittanceLaw.of(scene.lens)[0])
    assert lattice.x.place.tolist() == [-0.75, -0.25, 0.25, 0.75]
    assert lattice.x.width.tolist() == [0.5] * 4
    assert lattice.x.away == pytest.approx(lattice.x.place - 0.5)
    assert not lattice.x.rim_from_point.any()
    # Above the aperture by 2: its rays cross the entrance face 2 or more below the point.
    assert lattice.y.rim_from_point.tolist() == [-2.0] * 5
    assert lattice.y.rim_from_place == pytest.approx(1 - lattice.y.place)


@pytest.mark.parametrize("points", [(1, 1), (3, 4)])
@pytest.mark.parametrize("x", [0.0, 0.4])
def test_samples_are_dense_where_a_near_source_lights_the_face(make_scene, points, x):
    scene = grid(make_scene, points, center=[x, 0, -0.01], half_width=[0.02, 0.03])
    scene = scene.model_copy(
        update={"lens": scene.lens.model_copy(update={"base": FlatBase(height=0.05)})}
    )
    lattice = make_lattice(scene.source, scene.lens, (120, 120), TransmittanceLaw.of(scene.lens)[0])
    axis = lattice.x
    assert (np.diff(axis.place) > 0).all()
    assert abs(axis.place).max() < 1
    assert axis.t == pytest.approx((axis.place + 1) / 2)
    assert np.diff(axis.place).argmin() == pytest.approx(abs(axis.place - x).argmin(), abs=2)
    assert np.diff(axis.place).min() < 0.3 * 2 / 120
    for number in range(points[0]):
        assert axis.width[axis.point == number].sum() == pytest.approx(2)
    if x == 0:
        assert axis.place == pytest.approx(-axis.place[::-1])
        assert axis.width == pytest.approx(axis.width[::-1])
