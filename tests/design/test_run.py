"""A design run as its consumers see it."""

import dataclasses
import re
from itertools import islice

import numpy as np
import pytest
import torch

from workbench.design.methods import method_of
from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.errors import Refused, RunFailed
from workbench.optics import ready

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
    assert first.state.heights["exit"] == pytest.approx(0.5, abs=1e-14)
    assert first.state.account.efficiency == pytest.approx(0.96**2, rel=0.1)
    assert first.best


def test_snapshots_note_how_they_are_traced(scene, disc):
    assert next(run(scene, disc)).notes[0].startswith("fused kernels")


def test_a_run_repeats_whether_or_not_its_kernel_was_compiled_before(scene, disc, monkeypatch):
    monkeypatch.setattr(ready, "_ready", set())
    cold, warm = (list(run(scene, disc)) for _ in range(2))
    assert [shot.state.loss for shot in cold] == [shot.state.loss for shot in warm]
    assert [shot.notes for shot in cold] == [shot.notes for shot in warm]
    np.testing.assert_array_equal(cold[-1].state.heights["exit"], warm[-1].state.heights["exit"])


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
            assert snapshot.state.heights["exit"].min() >= 0.49
            assert snapshot.state.heights["exit"].max() <= 0.51
            assert np.isfinite(snapshot.state.irradiance).all()
            emitted, *parts = snapshot.state.account.to_data().values()
            assert sum(parts) == pytest.approx(emitted, abs=2e-6)


def test_snapshots_cannot_be_changed(scene, disc):
    snapshot = next(run(scene, disc))
    with pytest.raises(ValueError, match="read-only"):
        snapshot.state.heights["exit"][0, 0] = 1
    with pytest.raises(ValueError, match="read-only"):
        snapshot.state.irradiance[0, 0] = 1


@pytest.mark.parametrize("method", METHODS, ids=["auto", "paper"])
def test_irradiance_is_flux_per_area(make_scene, disc, method):
    # A dark rim, beyond which no filter spreads light.
    scene = make_scene({"run": method, "screen.half_width": [2.0, 2.0]})
    snapshot = next(run(scene, disc))
    flux = snapshot.state.irradiance.sum() * scene.receiver.pixel_measure
    assert flux == pytest.approx(snapshot.state.account.on_screen, rel=1e-6)


def test_the_same_seed_repeats(make_scene, disc):
    def heights(seed):
        settings = {"method": "paper", "start": "random", "seed": seed, "iterations": 3}
        return [s.state.heights["exit"] for s in run(make_scene({"run": settings}), disc)]

    assert all((a == b).all() for a, b in zip(heights(1), heights(1), strict=True))
    assert (heights(1)[0] != heights(2)[0]).any()


def test_starts_of_the_paper_differ_as_they_should(make_scene, disc):
    def spread(start):
        settings = {"method": "paper", "start": start}
        return np.ptp(next(run(make_scene({"run": settings}), disc)).state.heights["exit"])

    assert spread("zeros") < 1e-12
    assert 1e-5 < spread("uniform") < 1e-3
    assert spread("random") > 1e-3


def test_a_run_goes_on_from_given_heights(scene, disc):
    earlier = [s for s in run(scene, disc) if s.best][-1]
    again = run(scene, disc, start=earlier.state.heights)
    first = next(again)
    assert first.state.heights["exit"] == pytest.approx(earlier.state.heights["exit"], abs=1e-9)
    assert first.state.loss == pytest.approx(earlier.state.loss, rel=1e-3)
    assert min(s.state.loss for s in again) <= first.state.loss


def test_no_iterations_show_the_undesigned_lens(make_scene, disc):
    assert len(list(run(make_scene({"run.iterations": 0}), disc))) == 1


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


def test_auto_judges_the_first_lens_of_transport_and_not_the_undesigned_one(make_scene, disc):
    # The plate sends no light to the screen.
    dark, *rest = run(make_scene(ASIDE | {"lens.height_range": None}), disc)
    assert dark.state.account.on_screen == 0 and not dark.state.irradiance.any()
    assert dark.best and np.isfinite(dark.state.loss)
    assert rest[0].best and rest[0].state.account.on_screen > 0.3
    assert rest[-1].state.loss < 0.2 * dark.state.loss


def test_auto_restarts_by_transport_from_a_lens_without_light(make_scene, disc):
    scene = make_scene(ASIDE | {"lens.height_range": None})
    dark, then, *_ = run(scene, disc, start={"exit": np.full((20, 20), 0.6)})
    assert dark.state.account.on_screen == 0 and (dark.state.heights["exit"] == 0.6).all()
    assert then.state.account.on_screen > 0.3


def test_auto_refuses_a_range_in_which_no_lens_has_light_and_states_what_is_needed(
    make_scene, disc
):
    aside = {"source": ASIDE["source"] | {"position": [20.0, 0.0, -5.0]}}
    scene = make_scene(ASIDE | aside | {"lens.height_range": [-1e-4, 1e-4]})
    with pytest.raises(RunFailed, match=r"no light .*\. The lens needs .* is allowed: widen"):
        list(run(scene, disc))


def test_a_box_filter_gives_the_papers_method_no_gradient(make_scene, disc):
    scene = make_scene({"run": {"method": "paper"}, "filter": {"kind": "box"}})
    with pytest.raises(Refused, match=r"filter\.kind: 'box' is constant"):
        next(run(scene, disc))


def test_auto_designs_behind_a_box_filter_all_the_same(make_scene, disc):
    losses = [s.state.loss for s in run(make_scene({"filter": {"kind": "box"}}), disc)]
    assert losses[-1] < losses[0]


@pytest.mark.skipif(torch.cuda.is_available(), reason="there is a GPU here")
def test_a_gpu_that_is_not_there_is_refused(make_scene, disc):
    for method in METHODS:
        with pytest.raises(Refused, match=r"run\.device: 'cuda' needs an NVIDIA GPU"):
            next(run(make_scene({"run": method | {"device": "cuda"}}), disc))


def test_a_full_graphics_card_ends_a_run_with_what_to_do(scene, disc, monkeypatch):
    def full(*_):
        raise torch.OutOfMemoryError("CUDA out of memory. Tried to allocate 670.00 MiB.")
        yield

    method = method_of(scene)._replace(steps=full)
    monkeypatch.setattr("workbench.design.run.method_of", lambda scene: method)
    with pytest.raises(RunFailed, match="too little free memory; compute on the processor"):
        next(run(scene, disc))


def test_a_card_that_is_full_in_the_last_look_ends_a_run_with_what_to_do(scene, disc, monkeypatch):
    def full(*_):
        raise torch.OutOfMemoryError("CUDA out of memory. Tried to allocate 670.00 MiB.")

    method = method_of(scene)._replace(judged=full)
    monkeypatch.setattr("workbench.design.run.method_of", lambda scene: method)
    seen = []
    with pytest.raises(RunFailed, match="too little free memory; compute on the processor"):
        seen.extend(run(scene, disc))
    assert seen[-1].iteration > 0  # lenses up to then stay good


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


def test_times_that_were_not_kept_are_spread_evenly(scene, disc):
    history = History()
    for snapshot in islice(run(scene, disc), 5):
        history.add(snapshot)
    result = dataclasses.replace(history.result(), seconds=2.0, seconds_at=None)
    assert result.times().tolist() == [0.5, 1.0, 1.5, 2.0]


def test_auto_moves_light_beside_the_screen_onto_it(make_scene, disc):
    source = {"kind": "point", "position": [0, 0, -5], "rays": 20_000}
    scene = make_scene({"source": source, "run": {"method": "auto", "iterations": 40}})
    snapshots = list(run(scene, disc))
    first, last = snapshots[0], [s for s in snapshots if s.best][-1]
    assert first.state.account.lost["off_screen"] > 0.3
    assert last.state.account.lost["off_screen"] < 0.3 * first.state.account.lost["off_screen"]
    assert last.state.loss < 0.5 * first.state.loss
