"""Lenses shaped by hand are judged as those of a run."""

import numpy as np
import pytest

from workbench.design.evaluation import Evaluator
from workbench.design.limits import undesigned
from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.errors import RunFailed
from workbench.geometry.faces import FaceArrays
from workbench.scene import Scene

PAPER = {"method": "paper", "iterations": 3}
POINT = {"kind": "point", "position": [0.0, 0.0, -5.0], "rays": 4096}


@pytest.fixture
def target():
    image = np.zeros((32, 32))
    image[8:20, 10:26] = 1.0
    return image


@pytest.mark.parametrize(
    "changes", [{}, {"run": PAPER}, {"source": POINT}, {"source": POINT, "run": PAPER}]
)
def test_a_lens_is_judged_as_by_its_run(make_scene, target, changes):
    scene = make_scene(changes)
    *_, last = run(scene, target)
    found = Evaluator(scene, target, last.state.heights).snapshot(last.state.heights)
    continued = next(run(scene, target, last.state.heights))
    assert found.state.loss == pytest.approx(continued.state.loss, rel=2e-2)
    lit = continued.state.irradiance.max()
    np.testing.assert_allclose(found.state.irradiance, continued.state.irradiance, atol=1e-2 * lit)
    parts = found.state.account.to_data()
    assert sum(parts.values()) == pytest.approx(2 * parts["emitted"], rel=1e-5)
    assert found.state.heights is not last.state.heights
    assert not found.state.heights["exit"].flags.writeable


def test_one_plan_serves_many_lenses(make_scene, target):
    scene = make_scene()
    heights = np.full((12, 10), 0.5)
    flat = FaceArrays({"exit": heights})
    heights[5, 5] += 0.02
    curved = FaceArrays({"exit": heights})
    evaluator = Evaluator(scene, target, flat)
    first, moved, again = (evaluator.snapshot(h) for h in (flat, curved, flat))
    np.testing.assert_array_equal(first.state.irradiance, again.state.irradiance)
    assert np.abs(first.state.irradiance - moved.state.irradiance).max() > 1e-3
    fresh = Evaluator(scene, target, curved).snapshot(curved)
    assert moved.state.loss == pytest.approx(fresh.state.loss, rel=1e-3)


def test_an_evaluator_suits_lenses_of_its_own_scene_and_target(make_scene, target):
    scene, flat = make_scene(), FaceArrays({"exit": np.full((12, 10), 0.5)})
    evaluator = Evaluator(scene, target, flat)
    assert evaluator.suits(scene, target)
    assert not evaluator.suits(make_scene({"screen.z": 6.0}), target)
    assert not evaluator.suits(scene, target.copy())


def test_a_snapshot_counts_on_from_an_earlier_result(make_scene, scene_data, target):
    scene = make_scene({"run.iterations": 2})
    history = History()
    for snapshot in run(scene, target):
        history.add(snapshot)
    earlier = history.result()
    found = Evaluator(scene, target, earlier.state.heights).snapshot(earlier.state.heights, earlier)
    assert (found.iteration, found.seconds) == (2, earlier.seconds)
    scene_data["run"]["stages"] = [{"iterations": 2, "control_points": [8, 8]}]
    staged = Scene.from_data(scene_data)
    found = Evaluator(staged, target, earlier.state.heights).snapshot(earlier.state.heights)
    assert (found.stage, found.stages) == (1, 2)


def test_a_lens_that_lights_nothing_is_refused(make_scene, target):
    scene = make_scene({"screen.z": 500.0})
    steep = FaceArrays({"exit": np.linspace(0.2, 0.8, 12)[:, None] * np.ones(10)})
    with pytest.raises(RunFailed, match="no light reaches the screen"):
        Evaluator(scene, target, steep).snapshot(steep)


def test_the_undesigned_lens_is_where_a_run_begins(make_scene, target):
    scene = make_scene({"lens.height_range": [-0.1, 0.3]})
    assert undesigned(scene.optic) == next(run(scene, target)).state.heights
