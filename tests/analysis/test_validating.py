"""A check step by step: it tells how far it is, can be left, and finds what `validate` finds."""

import threading

import numpy as np
import pytest

from workbench.analysis.cells import BATCHES
from workbench.analysis.validation import validate, validating

RAYS = 20_000


@pytest.fixture
def lens(make_scene):
    scene = make_scene()
    n_x, n_y = scene.screen.pixels
    return scene, np.ones((n_y, n_x)), np.full(scene.lens.control_points, 0.5)


def driven(steps):
    """What was yielded, and what was returned."""
    done = []
    while True:
        try:
            done.append(next(steps))
        except StopIteration as end:
            return done, end.value


@pytest.mark.parametrize("threads", [None, 1])
def test_the_steps_lead_to_what_validate_finds(lens, threads):
    done, found = driven(validating(*lens, RAYS, threads=threads))
    assert len(done) == 2 * BATCHES
    assert np.all(np.diff(done) > 0) and done[0] > 0
    assert done[-1] == 1
    assert found.to_data() == validate(*lens, RAYS).to_data()


def test_a_check_that_is_left_traces_no_further(lens, monkeypatch):
    from workbench.analysis.tracing import Trace

    traced, trace = [], Trace._batch
    monkeypatch.setattr(
        Trace, "_batch", lambda self, number: (traced.append(number), trace(self, number))[1]
    )
    before = threading.active_count()
    steps = validating(*lens, RAYS, threads=1)
    next(steps)
    next(steps)
    steps.close()
    assert traced == [0, 1]
    assert threading.active_count() == before
