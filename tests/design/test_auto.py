"""What the best method promises."""

import numpy as np
import pytest
import torch

from workbench.design import auto
from workbench.design.loss import share
from workbench.design.run import run
from workbench.interruption import Interrupted, given_up_when
from workbench.optics.beam_plan import BeamPlan


def best(scene, target):
    return [s for s in run(scene, target) if s.best][-1]


@pytest.fixture
def letter():
    image = np.zeros((32, 32))
    image[6:26, 8:12] = 1.0
    image[22:26, 8:24] = 1.0
    return image


def test_the_first_iteration_reduces_the_loss_to_a_third(make_scene, letter):
    first, second, *_ = run(make_scene({"lens.control_points": [24, 24]}), letter)
    assert second.state.loss < 0.3 * first.state.loss


def test_a_run_that_nobody_wants_is_left_before_its_first_gradient(make_scene, letter):
    steps = run(make_scene({"lens.control_points": [24, 24]}), letter)
    next(steps)
    with given_up_when(lambda: True), pytest.raises(Interrupted):
        next(steps)


@pytest.mark.parametrize("iterations", [1, 2, 5, 15])
def test_a_run_takes_exactly_its_iterations(make_scene, letter, iterations):
    snapshots = list(run(make_scene({"run.iterations": iterations}), letter))
    assert [s.iteration for s in snapshots] == list(range(iterations + 1))


def test_symmetric_tasks_have_symmetric_lenses(make_scene):
    scene = make_scene({"run.iterations": 20})
    across = np.linspace(-1, 1, 32)
    disc = (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)
    heights = best(scene, disc).state.heights["exit"]
    for axis in (0, 1):
        assert heights == pytest.approx(np.flip(heights, axis), abs=1e-12)


def test_tasks_with_a_point_off_the_axis_are_not_mirrored(make_scene):
    point = {"kind": "point", "position": [0.2, 0.0, -5.0], "rays": 1000}
    scene = make_scene({"source": point})
    assert auto._mirrored(scene, np.ones((32, 32)), None) == (False, True)
    lopsided = np.ones((12, 10))
    lopsided[0, 0] = 2
    assert auto._mirrored(make_scene({}), np.ones((32, 32)), {"exit": lopsided}) == (False, False)


@pytest.mark.parametrize("kind", ["point", "grid"])
def test_light_of_points_reaches_the_screen(make_scene, letter, kind):
    source = {"kind": "point", "position": [0.1, 0.0, -5.0], "rays": 4096}
    if kind == "grid":
        source = {
            "kind": "grid",
            "center": [0.1, 0.0, -5.0],
            "half_width": [0.02, 0.02],
            "points": [3, 3],
            "rays": 500,
        }
    scene = make_scene({"source": source, "lens.control_points": [24, 24]})
    found = best(scene, letter)
    lost = found.state.account.lost["off_screen"] + found.state.account.lost["total_reflection"]
    assert lost < 0.03 * found.state.account.on_screen


def test_losses_are_those_of_the_finest_image(make_scene, letter):
    scene = make_scene({"lens.control_points": [24, 24], "run.iterations": 60})
    wanted = share(letter)
    plan = BeamPlan(scene, (500, 500), dtype=torch.float64)
    for snapshot in list(run(scene, letter))[::12]:
        image = plan.trace(
            {"exit": torch.as_tensor(snapshot.state.heights["exit"].copy())}
        ).flux.numpy()
        error = np.linalg.norm(image / image.sum() - wanted) / 32
        assert snapshot.state.loss == pytest.approx(error, rel=0.02)


def test_the_widened_image_may_exceed_the_largest_screen(make_scene):
    scene = make_scene({"screen.pixels": [4096, 1], "run.iterations": 1})
    steps = [step for step in run(scene, np.ones((1, 4096))) if not step.judged]
    assert [step.iteration for step in steps] == [0, 1]
