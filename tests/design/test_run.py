"""A design run as its consumers see it."""

import re

import numpy as np
import pytest
import torch

from workbench.design.loss import relative_error
from workbench.design.run import run
from workbench.design.snapshot import MET, History
from workbench.errors import Refused, RunFailed

METHODS = [{"method": "auto"}, {"method": "paper", "learning_rate": 3e-3}]


@pytest.fixture
def disc():
    across = np.linspace(-1, 1, 32)
    return (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)


@pytest.fixture(params=METHODS, ids=["auto", "paper"])
def scene(request, make_scene):
    return make_scene({"run": request.param | {"iterations": 30, "seed": 3}})


def test_the_first_snapshot_is_the_lens_before_any_step(scene, disc):
    first = next(run(scene, disc))
    assert first.iteration == 0 and first.iterations == 30
    assert first.state.heights["lens.back"] == pytest.approx(0.5, abs=1e-14)
    assert first.state.account.efficiency == pytest.approx(0.96**2, rel=0.1)
    assert first.best


def test_a_run_brings_the_image_closer_to_the_target(scene, disc):
    snapshots = list(run(scene, disc))
    assert [s.iteration for s in snapshots] == list(range(len(snapshots)))
    assert min(s.state.loss for s in snapshots) < 0.6 * snapshots[0].state.loss
    best = [s for s in snapshots if s.best][-1]
    assert best.state.loss == min(s.state.loss for s in snapshots)
    wanted = disc / disc.sum()
    far = [
        np.linalg.norm(s.state.irradiance / s.state.irradiance.sum() - wanted)
        for s in (snapshots[0], best)
    ]
    assert far[1] < 0.7 * far[0]


def test_every_lens_of_a_run_is_possible(make_scene, disc):
    for method in METHODS:
        scene = make_scene(
            {
                "run": method | {"iterations": 25},
                "lens.height_range": [-0.02, 0.01],
                "lens.min_thickness": 0.49,
            }
        )
        for snapshot in run(scene, disc):
            assert snapshot.state.heights["lens.back"].min() >= 0.49
            assert snapshot.state.heights["lens.back"].max() <= 0.51
            assert np.isfinite(snapshot.state.irradiance).all()
            emitted, *parts = snapshot.state.account.to_data().values()
            assert sum(parts) == pytest.approx(emitted, abs=2e-6)


def test_a_run_without_light_fails_with_its_light_account(make_scene, disc):
    # Four rays, none of them through the middle, where the tiny screen is.
    scene = make_scene(
        {"run": {"method": "paper"}, "source.rays": [2, 2], "screen.half_width": [1e-3, 1e-3]}
    )
    with pytest.raises(RunFailed) as failed:
        list(run(scene, disc))
    text = str(failed.value)
    assert text.startswith("stopped at iteration 0: no light reaches the screen: of the emitted")
    assert "92.2% passes beside it" in text
    shares = [float(share) for share in re.findall(r"([\d.]+)%", text)]
    assert sum(shares) == pytest.approx(100, abs=0.2)
    assert text.endswith("a larger screen catches it")


ASIDE = {
    "lens.refractive_index": 2.0,
    "source": {"kind": "point", "position": [4.0, 0.0, -5.0], "rays": 4096},
    "lens.control_points": [20, 20],
}


def test_auto_refuses_a_range_in_which_no_lens_has_light_and_states_what_is_needed(
    make_scene, disc
):
    aside = {"source": ASIDE["source"] | {"position": [20.0, 0.0, -5.0]}}
    scene = make_scene(ASIDE | aside | {"lens.height_range": [-1e-4, 1e-4]})
    with pytest.raises(RunFailed, match=r"no light .*\. The lens needs .* is allowed: widen"):
        list(run(scene, disc))


@pytest.mark.skipif(torch.cuda.is_available(), reason="there is a GPU here")
def test_a_gpu_that_is_not_there_is_refused(make_scene, disc):
    for method in METHODS:
        with pytest.raises(Refused, match=r"run\.device: 'cuda' needs an NVIDIA GPU"):
            next(run(make_scene({"run": method | {"device": "cuda"}}), disc))


def test_history_gathers_the_best_lens_and_all_losses(scene, disc):
    history = History()
    assert history.result() is None
    snapshots = list(run(scene, disc))
    for snapshot in snapshots:
        history.add(snapshot)
    result = history.result()
    assert result.iterations == snapshots[-1].iteration
    assert result.losses.tolist() == [s.state.loss for s in snapshots[1:]]
    assert result.state.loss == min(s.state.loss for s in snapshots)
    assert result.seconds == snapshots[-1].seconds
    assert result.times().tolist() == [s.seconds for s in snapshots[1:]]

    continued = History(earlier=result)
    for snapshot in run(scene, disc, start=result.state.heights):
        continued.add(snapshot)
    both = continued.result()
    assert both.losses[: len(result.losses)].tolist() == result.losses.tolist()
    assert both.iterations > result.iterations
    assert both.seconds > result.seconds
    assert (np.diff(both.times()) > 0).all() and both.times()[-1] == both.seconds


def test_auto_moves_light_beside_the_screen_onto_it(make_scene, disc):
    source = {"kind": "point", "position": [0, 0, -5], "rays": 20_000}
    scene = make_scene({"source": source, "run": {"method": "auto", "iterations": 40}})
    snapshots = list(run(scene, disc))
    first, last = snapshots[0], [s for s in snapshots if s.best][-1]
    assert first.state.account.lost["off_screen"] > 0.3
    assert last.state.account.lost["off_screen"] < 0.3 * first.state.account.lost["off_screen"]
    assert last.state.loss < 0.5 * first.state.loss


def test_a_run_ends_as_soon_as_its_goal_is_met(make_scene, disc):
    scene = make_scene({"run": {"method": "auto", "iterations": 30}})
    history = History()
    errors = [relative_error(s.state, disc) for s in history.follow(run(scene, disc))]
    goal = 1.03 * errors[4]
    asked = scene.model_copy(update={"run": scene.run.model_copy(update={"max_error": goal})})
    shorter = History()
    met = [relative_error(s.state, disc) for s in shorter.follow(run(asked, disc)) if not s.judged]
    assert len(met) < len(errors) and met[-1] <= goal and min(met[:-1]) > 0.98 * goal
    assert shorter.result().ended.words == MET
    assert relative_error(shorter.result().state, disc) <= goal


def test_a_goal_out_of_reach_changes_nothing(make_scene, disc):
    scene = make_scene({"run": {"method": "auto", "iterations": 5}})
    asked = scene.model_copy(update={"run": scene.run.model_copy(update={"max_error": 1e-6})})
    losses = [[s.state.loss for s in run(each, disc)] for each in (scene, asked)]
    assert losses[0] == losses[1]
