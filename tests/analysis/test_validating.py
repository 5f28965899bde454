"""A check step by step: it reports progress, can be cancelled, and finds what `validate` finds."""

import threading

import numpy as np
import pytest

from workbench.analysis.tracing import MOST_RAYS
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.analysis.validation import validate, validating

RAYS = 20_000


@pytest.fixture
def lens(make_scene):
    scene = make_scene()
    n_x, n_y = scene.receiver.pixels
    return scene, np.ones((n_y, n_x)), {"lens.back": np.full(scene.optic.net_shape, 0.5)}


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
    assert len(done) >= 2 * BATCHES  # and more while a batch takes long
    assert np.all(np.diff(done) >= 0) and done[0] >= 0
    assert done[-1] == pytest.approx(1, abs=1e-12)
    assert found.to_data() == validate(*lens, RAYS).to_data()


def test_closing_a_check_stops_within_a_batch(lens):
    before = threading.active_count()
    steps = validating(*lens, MOST_RAYS, threads=1)
    done = [next(steps) for _ in range(3)]
    steps.close()
    assert 0 < done[-1] < 1 / (2 * BATCHES)
    assert threading.active_count() == before
