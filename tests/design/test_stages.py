"""A run in stages: each is a scene of its own, and the lens is handed on from one to the next."""

import numpy as np
import pytest

from workbench.design.run import run
from workbench.errors import Refused

POINT = {"kind": "point", "position": [0, 0, -5], "rays": 5000}
GRID = {"kind": "grid", "center": [0, 0, -5], "half_width": [0.2, 0.2], "points": [3, 3]}


@pytest.fixture
def disc():
    across = np.linspace(-1, 1, 32)
    return (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)


@pytest.mark.parametrize(
    ("stages", "sentence"),
    [
        ([{"iterations": 10}], "run.stages: they leave none of the 10 iterations"),
        ([{"iterations": 1}] * 101, "run.stages: 101 are given; at most 100"),
        ([{"iterations": 0}], "run.stages[0].iterations: 0 is too small; at least 1"),
        ([{"iterations": 1, "sauce": 1}], "run.stages[0].sauce: unknown field"),
        (
            [{"iterations": 1}, {"iterations": 1, "control_points": [3, 9]}],
            "run.stages[1].control_points[0]: 3 is too few for degree 3",
        ),
        (
            [{"iterations": 1, "source": POINT | {"position": [0, 0, 0.2]}}],
            "run.stages[0].source.position[2]: 0.2 is not before the entrance face",
        ),
        (
            [{"iterations": 1, "learning_rate": 0.1}],
            "run.stages[0].learning_rate: unknown field",
        ),
        (
            [{"iterations": 1}, {"iterations": 1, "filter": {"size": [3, 4]}}],
            "run.stages[1].filter.size[1]: 4 is even; an odd number is needed",
        ),
        (
            [{"iterations": 1, "source": GRID | {"points": [300, 300]}}],
            "run.stages[0].source.rays: 1000 from each of 90000 points are too many",
        ),
    ],
)
def test_stages_that_are_not_possible_are_refused(make_scene, stages, sentence):
    with pytest.raises(Refused) as refused:
        make_scene({"run": {"iterations": 10, "stages": stages}})
    assert str(refused.value).startswith(sentence)


def test_each_stage_begins_with_the_best_lens_before(make_scene, disc):
    stages = [{"iterations": 8, "control_points": [6, 6]}, {"iterations": 6, "source": POINT}]
    scene = make_scene({"run": {"iterations": 20, "stages": stages}, "lens.control_points": [9, 9]})
    snapshots = list(run(scene, disc))
    assert [s.iteration for s in snapshots] == list(range(21))
    assert [s.stage for s in snapshots] == [0] * 9 + [1] * 6 + [2] * 6
    for before in (0, 1):
        handed = [s for s in snapshots if s.stage == before and s.best][-1]
        taken = next(s for s in snapshots if s.stage == before + 1)
        assert taken.best
        assert taken.state.heights["lens.back"] == pytest.approx(
            handed.state.heights["lens.back"], abs=1e-9
        )
    assert all(s.state.heights["lens.back"].shape == (9, 9) for s in snapshots)
