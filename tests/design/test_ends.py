"""How a run ends, and at which pace it goes."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
import torch

from workbench.api import begin
from workbench.design.auto import auto_judged
from workbench.design.live import LiveDesign
from workbench.design.loss import relative_error
from workbench.design.run import run
from workbench.design.session import Session
from workbench.design.snapshot import History, Pace
from workbench.errors import RunFailed
from workbench.jobs.lenses import LedRectangle
from workbench.optics.beam_plan import BeamPlan
from workbench.scene.paths import with_values


@pytest.fixture
def disc():
    across = np.linspace(-1, 1, 32)
    return (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)


def ended(snapshots, most=None):
    """Follow a run to its end, or for so many snapshots."""
    history = History()
    following = history.follow(snapshots)
    for number, _ in enumerate(following, 1):
        assert not history.result().ended  # not yet
        if number == most:
            following.close()
    return history.result().ended


@pytest.mark.parametrize("method", ["auto", "paper"])
def test_all_iterations_are_done(make_scene, disc, method):
    scene = make_scene({"run": {"method": method, "iterations": 3}})
    assert ended(run(scene, disc)) == "all iterations are done"


def test_auto_says_that_it_converged(make_scene, disc):
    scene = make_scene({"lens.control_points": [5, 5], "run.iterations": 1000})
    why = ended(run(scene, disc))
    slow = re.fullmatch("converged: less than [0-9]+ % better in [0-9]+ iterations", why)
    assert slow or why in (
        "converged: no step makes the image better",
        "converged: error below 0.1 %",
    )


def test_a_failure_is_recorded_and_raised(make_scene, disc):
    def failing():
        yield next(run(make_scene({}), disc))
        raise RunFailed("the loss is not finite")

    history = History()
    with pytest.raises(RunFailed, match="the loss is not finite"):
        list(history.follow(failing()))
    assert history.result().ended == "failed: the loss is not finite"


def test_the_pace_is_that_of_the_last_seconds():
    pace = Pace()
    assert pace.rate is None and pace.left(10) is None
    for iteration in range(101):
        pace.note(0.1 * iteration, iteration)
    assert pace.rate == pytest.approx(10)
    for iteration in range(1, 21):  # then four times slower
        pace.note(10 + 0.4 * iteration, 100 + iteration)
    assert pace.rate == pytest.approx(2.5)
    assert pace.left(10) == pytest.approx(4)


def test_the_first_lens_and_the_first_step_tell_no_pace():
    """Compiling and a first design of 15 s each, then steps of 0.1 s."""
    steps, pace = [(0.0, 0), *((30 + 0.1 * i, i) for i in range(1, 5))], Pace()
    for step in steps[:-1]:
        pace.note(*step)
        assert pace.left(300) is None
    pace.note(*steps[-1])
    assert pace.left(300) == pytest.approx(30)


# More control points than pixels: beams run between the places that a descent can make good.
FINE_NET = {"lens.control_points": [64, 64], "run.iterations": 25}


@pytest.fixture
def bars():
    """Two bars of different length."""
    image = np.zeros((32, 32))
    image[6:26, 8:12] = 1.0
    image[22:26, 8:24] = 1.0
    return image


@pytest.fixture
def shown(make_scene, bars):
    """All snapshots of a run, and its history."""
    history = History()
    return list(history.follow(run(make_scene(FINE_NET), bars))), history


def test_a_run_ends_with_its_best_lens_in_other_light(shown):
    *steps, last = shown[0]
    assert last.judged and not any(step.judged for step in steps)
    best = [step for step in steps if step.best][-1]
    assert last.best and last.merit == best.merit
    assert last.iteration == steps[-1].iteration and last.seconds >= steps[-1].seconds
    for face, heights in last.state.heights.items():
        np.testing.assert_array_equal(heights, best.state.heights[face])
    assert last.state.irradiance.sum() == pytest.approx(best.state.irradiance.sum(), rel=1e-3)


def test_that_light_is_nearer_to_what_the_lens_does(shown, make_scene, bars):
    *steps, last = shown[0]
    best = [step for step in steps if step.best][-1]
    lens = {"lens.back": torch.as_tensor(last.state.heights["lens.back"].copy())}
    image = BeamPlan(make_scene(FINE_NET), (901, 901), dtype=torch.float64).trace(lens).flux.numpy()
    loss = np.linalg.norm(image / image.sum() - bars / bars.sum()) / 32
    exact = replace(last.state, loss=float(loss))
    true = relative_error(exact, bars)
    seen, judged = (relative_error(state, bars) for state in (best.state, last.state))
    assert seen < true
    assert abs(judged - true) < 0.6 * abs(seen - true)


def test_a_run_ends_where_its_lens_gets_worse_in_other_light(monkeypatch):
    """Two faces of many control points suit the points that stand for an LED, and no others."""
    monkeypatch.setattr("workbench.design.auto._FIRST_LOOK", 5)
    scene = LedRectangle().scene()
    front = {"shape": "bspline", "control_points": [32, 24], "height_range": [-4.0, 4.0]}
    changes = {
        "elements[0].faces": [front, {"shape": "bspline", "control_points": [32, 24]}],
        "images[0].receiver.pixels": [39, 24],
    }
    session = begin(with_values(scene, changes))
    history = History()
    *_, last, judged = history.follow(run(session.scene, session.target))
    assert "in the light of other points of the source the image gets worse" in str(
        history.result().ended
    )
    assert judged.judged and last.iteration < scene.run.iterations
    at_last = auto_judged(session.scene, session.target, last.state.heights).state.loss
    assert last.state.loss < judged.state.loss < 0.7 * at_last


def test_an_edit_keeps_the_better_lens_that_was_there(make_scene, bars):
    """What is judged at last is the best lens of a run, which is not always the best of all."""
    scene = make_scene(FINE_NET)
    first, second, *_ = run(make_scene({**FINE_NET, "run.iterations": 1}), bars)

    def generate(scene, target, start, locked):
        if start is not None:
            yield replace(first, merit=1e-9)
            return "left"
        yield replace(first, merit=math.inf)
        yield replace(second, merit=2.0)
        yield replace(second, merit=2.0, best=True, judged=True)
        return "done"

    session = Session(scene, bars, start=first.state.heights)
    steps = list(LiveDesign(generate, refit=lambda *task: None).snapshots(session))
    assert not any(step.judged for step in steps)
