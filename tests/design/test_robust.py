"""Designs for set-ups that are not known exactly."""

import math

import numpy as np
import pytest

from workbench.analysis.making.robust import expected_error
from workbench.design.run import run
from workbench.errors import Refused
from workbench.geometry.as_made import AsMade
from workbench.scene import Scene


def scene_of(make_scene, uncertainty, **changes):
    small = {"lens.control_points": [40, 40], "screen.pixels": [40, 40], **changes}
    return Scene.from_data(make_scene(small).to_data() | {"uncertainty": uncertainty})


def letter():
    target = np.full((40, 40), 0.2)
    target[8:32, 10:16] = target[26:32, 16:30] = 1.0
    return target


class TestCases:
    def test_they_have_the_deviations_that_are_stated(self, make_scene):
        scene = scene_of(make_scene, {"distance": 0.3, "source_tilt": 0.2})
        cases = scene.uncertainty.cases(scene)
        assert sum(case.probability for case in cases) == pytest.approx(1)
        z = np.array([case.scene.receiver.z for case in cases])
        tilt = np.array([case.scene.source.direction for case in cases])
        weights = np.array([case.probability for case in cases])
        assert z @ weights == pytest.approx(5.0)
        assert math.sqrt((z - 5) ** 2 @ weights) == pytest.approx(0.3)
        assert np.sqrt(weights @ tilt**2) == pytest.approx((0.2, 0.2), rel=1e-3)

    def test_a_source_at_a_place_is_shifted(self, make_scene):
        point = {"kind": "point", "position": [0.1, 0, -4]}
        scene = scene_of(make_scene, {"source_shift": 0.1, "source_tilt": 1}, source=point)
        cases = scene.uncertainty.cases(scene)
        assert len(cases) == 5
        places = np.array([case.scene.source.position for case in cases])
        spread = np.sqrt(
            np.array([case.probability for case in cases]) @ (places - [0.1, 0, -4]) ** 2
        )
        assert spread == pytest.approx((0.1, 0.1, 0.0))

    @pytest.mark.parametrize(
        ("uncertainty", "value", "expected"),
        [
            ({"source_size": 10.0}, lambda case: case.source.angular_diameter, (2.0, 0.2)),
            ({"index": 0.01}, lambda case: case.optic.index, (1.5, 0.01)),
            (
                {"thickness": 0.02},
                lambda case: (
                    AsMade.of(case).heights({"lens.back": np.zeros((40, 40))})["lens.back"].mean()
                ),
                (0.0, 0.02),
            ),
        ],
    )
    def test_size_index_and_thickness(self, make_scene, uncertainty, value, expected):
        sun = {"source": {"kind": "collimated", "angular_diameter": 2.0}}
        scene = scene_of(make_scene, uncertainty, version=2, **sun)
        cases = scene.uncertainty.cases(scene)
        found = np.array([value(case.scene) for case in cases])
        weights = np.array([case.probability for case in cases])
        mean = weights @ found
        assert len(cases) == 3
        assert (mean, math.sqrt(weights @ (found - mean) ** 2)) == pytest.approx(expected)

    def test_one_without_deviations(self, make_scene):
        scene = scene_of(make_scene, {})
        assert scene.uncertainty.cases(scene) == ((scene, 1.0),)


@pytest.mark.parametrize("uncertainty", [{"distance": 0.5}, {"source_tilt": 1.0}, {"index": 0.03}])
def test_the_mean_error_falls(make_scene, uncertainty):
    scene, target = scene_of(make_scene, uncertainty), letter()
    exact = scene.altered(uncertainty=type(scene.uncertainty)())
    lenses = []
    for each in (exact, scene):
        *_, last = run(each, target)
        lenses.append(last.state.heights)
    nominal, robust = (expected_error(scene, target, heights) for heights in lenses)
    assert robust.mean**2 < 0.8 * nominal.mean**2
    assert robust.exact > nominal.exact


def test_where_nothing_is_uncertain_nothing_is_lost(make_scene):
    scene, target = scene_of(make_scene, {"distance": 1e-4}), letter()
    *_, last = run(scene, target)
    *_, exact = run(scene.altered(uncertainty=type(scene.uncertainty)()), target)
    found, best = (expected_error(scene, target, each.state.heights).mean for each in (last, exact))
    assert found < 1.03 * best
    assert any("mean error over 3 set-ups" in str(note) for note in last.notes)


def test_the_papers_method_refuses_it(make_scene):
    scene = scene_of(make_scene, {"distance": 0.1}, **{"run.method": "paper"})
    with pytest.raises(Refused, match="uncertainty: the paper's method"):
        next(run(scene, letter()))
