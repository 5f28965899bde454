"""Locked control points keep their heights in every kind of run."""

import numpy as np
import pytest

from workbench.design.run import run
from workbench.errors import Refused

METHODS = [
    {"method": "auto"},
    {"method": "paper"},
    {"method": "paper", "parametrisation": "sparse", "start": "uniform"},
    {"method": "paper", "parametrisation": "dense", "start": "random"},
]
POINT = {"kind": "point", "position": [0.0, 0.0, -4.0], "rays": 4000}


@pytest.fixture
def small(make_scene):
    """Builds a scene whose image is quickly traced."""
    return lambda changes=None: make_scene({"screen.pixels": [16, 16]} | (changes or {}))


@pytest.fixture
def disc():
    across = np.linspace(-1, 1, 16)
    return (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)


@pytest.fixture
def locked():
    locked = np.zeros((12, 10), bool)
    locked[:5] = True
    locked[8, 3] = True
    return locked


@pytest.fixture
def lens(rng):
    """Heights of some lens, one of them beyond the range of ±0.3."""
    lens = 0.5 + 0.01 * rng.normal(size=(12, 10))
    lens[1, 1] = 0.9
    return lens


@pytest.mark.parametrize("method", METHODS, ids=str)
@pytest.mark.parametrize("source", [{}, {"source": POINT}], ids=["collimated", "point"])
def test_heights_of_a_given_lens_stay_exactly(small, disc, locked, lens, method, source):
    scene = small({"run": method | {"iterations": 4}, **source})
    snapshots = list(run(scene, disc, {"lens.back": lens}, {"lens.back": locked}))
    assert len(snapshots) == 5
    for snapshot in snapshots:
        np.testing.assert_array_equal(snapshot.state.heights["lens.back"][locked], lens[locked])
    moved = snapshots[-1].state.heights["lens.back"] - snapshots[0].state.heights["lens.back"]
    assert (moved[~locked] != 0).mean() > 0.5  # light of a point leaves out some corners


@pytest.mark.parametrize("method", METHODS, ids=str)
@pytest.mark.parametrize("stages", [(), ({"iterations": 2, "control_points": [6, 6]},)])
def test_all_locked_ends_at_once_with_the_lens_as_it_is(small, disc, lens, method, stages):
    scene = small({"run": method | {"iterations": 9, "stages": list(stages)}})
    for start in (None, {"lens.back": lens}):
        (only,) = run(scene, disc, start, {"lens.back": np.ones((12, 10), bool)})
        assert (only.iteration, only.best, only.stage) == (0, True, len(stages))
        np.testing.assert_allclose(
            only.state.heights["lens.back"], 0.5 if start is None else lens, atol=1e-15
        )


class TestStages:
    STAGES = ({"iterations": 2, "filter": {"kind": "gaussian", "alpha": 0.5}},)

    def test_on_the_same_net_keep_them(self, small, disc, locked):
        scene = small({"run": {"iterations": 5, "stages": list(self.STAGES)}})
        snapshots = list(run(scene, disc, None, {"lens.back": locked}))
        assert [snapshot.stage for snapshot in snapshots] == [0, 0, 0, 1, 1, 1]
        for snapshot in snapshots:
            np.testing.assert_allclose(snapshot.state.heights["lens.back"][locked], 0.5, atol=1e-15)

    def test_on_another_net_are_refused(self, small, disc, locked, lens):
        stages = [*self.STAGES, {"iterations": 1, "control_points": [6, 6]}]
        scene = small({"run": {"iterations": 5, "stages": stages}})
        with pytest.raises(Refused) as caught:
            next(run(scene, disc, None, {"lens.back": locked}))
        assert str(caught.value) == (
            "run.stages[1].control_points: [6, 6] are not the control points of the finished lens "
            "that are locked; leave the stage's net out or unlock them"
        )
        # A lens that is there already goes through the last stage alone.
        assert len(list(run(scene, disc, {"lens.back": lens}, {"lens.back": locked}))) == 3
