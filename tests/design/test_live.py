"""Lenses for a task that is edited: from the one that is there, or from transport."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from workbench.design.live import LiveDesign, asks_for_another_lens
from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.design.task import begin
from workbench.geometry.faces import FaceArrays
from workbench.scene import Scene
from workbench.scene.paths import with_values


@pytest.fixture(scope="module")
def designed():
    """A small top hat with a lens."""
    scene = Scene.from_data(
        {
            "unit": "cm",
            "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [16, 16]},
            "source": {"kind": "collimated"},
            "screen": {"z": 5, "half_width": [1, 1], "pixels": [32, 32]},
            "target": {"builtin": "tophat"},
            "run": {"iterations": 20},
        }
    )
    session = begin(scene, Path())
    history = History()
    for _ in history.follow(run(session.scene, session.target)):
        pass
    return replace(session, result=history.result())


class Spy:
    """The engine, and what it was asked."""

    def __init__(self):
        self.asked = []

    def __call__(self, scene, target, start, locked):
        self.asked.append((scene, start, locked))
        return run(scene, target, start, locked)


def moved(session, z):
    screen = session.scene.receiver.moved_to(z)
    scene = session.scene.with_receiver(screen)
    return session.with_scene(scene, session.target)


def lenses(live, session, count, chain=None):
    """The first snapshots for a session."""
    steps = live.snapshots(session, chain)
    found = [next(steps) for _ in range(count)]
    steps.close()
    return found


def test_a_small_edit_goes_on_from_the_lens_that_is_there(designed, monkeypatch):
    spy = Spy()
    # Transport takes seconds, and an automatic range does without it.
    monkeypatch.delattr("workbench.design.bounds.first_design")
    edited = moved(designed, 5.01)
    present, first = lenses(LiveDesign(spy), edited, 2)
    assert len(spy.asked) == 1
    assert present.state.heights == designed.result.state.heights
    assert first.iteration == 1


def test_a_second_designed_lens_begins_anew(designed):
    (lens,) = designed.scene.elements
    second = lens.model_copy(update={"name": "second", "position": (0.0, 0.0, 2.0)})
    scene = designed.scene.model_copy(update={"elements": (lens, second)})
    asked = []

    def generate(scene, target, start, locked):
        asked.append(start)
        yield from ()

    edited = replace(designed, scene=scene, result=None)
    assert not list(LiveDesign(generate).snapshots(edited, before=designed))
    assert asked == [None]


def test_only_an_edit_of_the_same_chain_goes_on_from_the_last_lens(designed):
    live, edited = LiveDesign(refit=lambda *_: None), moved(designed, 5.01)
    *_, made = lenses(live, edited, 3, chain="first")
    for chain, start in (("second", designed.heights), ("first", made.state.heights)):
        (present,) = lenses(live, edited, 1, chain)
        assert present.state.heights == start
        *_, made = lenses(live, edited, 3, "first")


def test_a_large_edit_sends_the_light_anew_by_transport(designed):
    spy = Spy()
    edited = moved(designed, 9)
    present, first = lenses(LiveDesign(spy), edited, 2)
    assert [start is None for _, start, _ in spy.asked] == [False, True]
    assert present.state.heights == designed.result.state.heights
    assert (present.iteration, first.iteration) == (0, 1)
    assert first.state.loss < present.state.loss / 2
    assert present.best and first.best


def test_locked_control_points_stay_however_large_the_edit_is(designed):
    locked = np.zeros((16, 16), dtype=bool)
    locked[:3] = True
    edited = replace(moved(designed, 9), locked=FaceArrays({"lens.back": locked}))
    *_, last = lenses(LiveDesign(), edited, 3)
    before, after = edited.heights["lens.back"], last.state.heights["lens.back"]
    assert np.array_equal(before[locked], after[locked])
    assert not np.array_equal(before, after)


@pytest.mark.parametrize(
    ("changes", "asks"),
    [
        ({"images[0].receiver.position[2]": 6}, True),
        ({"lens.back.control_points": [24, 24]}, True),
        ({"run.smoothness": 1e-3}, True),
        ({"run.min_radius": 0.5}, True),
        ({"run.iterations": 7}, False),
        ({"run.seed": 7}, False),
        ({}, False),
    ],
)
def test_change_of_the_task_needs_another_lens(changes, asks, designed):
    after = designed.with_scene(with_values(designed.scene, changes), designed.target)
    assert asks_for_another_lens(designed, after) is asks
