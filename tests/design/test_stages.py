"""A run in stages: each is a scene of its own, and the lens is handed on from one to the next."""

import numpy as np
import pytest

from workbench.design import parametrisation
from workbench.design.run import run
from workbench.design.snapshot import History
from workbench.errors import Refused
from workbench.scene import GaussianFilter, PointSource

POINT = {"kind": "point", "position": [0, 0, -5], "rays": 5000}
GRID = {"kind": "grid", "center": [0, 0, -5], "half_width": [0.2, 0.2], "points": [3, 3]}


@pytest.fixture
def disc():
    across = np.linspace(-1, 1, 32)
    return (np.hypot(*np.meshgrid(across, across)) < 0.6).astype(float)


def test_a_scene_without_stages_is_one_part(make_scene):
    scene = make_scene()
    assert scene.stage_scenes() == (scene,)


def test_the_last_part_is_the_scene_itself(make_scene):
    stages = [
        {"iterations": 4, "source": POINT},
        {"iterations": 3, "source": POINT, "filter": {"size": [5, 5]}, "control_points": [6, 6]},
    ]
    scene = make_scene({"source": GRID, "run": {"iterations": 10, "stages": stages}})
    first, second, last = scene.stage_scenes()
    assert isinstance(first.source, PointSource)
    assert [p.run.iterations for p in (first, second, last)] == [4, 3, 3]
    assert second.filter == GaussianFilter(size=(5, 5))
    assert second.optic.control_points == (6, 6)
    assert last.source == scene.source and last.optic == scene.optic
    assert not last.run.stages
    assert type(scene).from_json(scene.to_json()) == scene


def test_a_stage_can_change_method_and_learning_rate(make_scene):
    stages = [{"iterations": 2, "method": "paper", "learning_rate": 0.01}]
    first, last = make_scene({"run": {"iterations": 5, "stages": stages}}).stage_scenes()
    assert (first.run.method, first.run.learning_rate) == ("paper", 0.01)
    assert last.run.method == "auto"


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


@pytest.mark.parametrize(
    ("stages", "changes", "path"),
    [
        ([{}, {"filter": {"kind": "box"}}], {"run.method": "paper"}, "run.stages[1].filter.kind"),
        ([{}, {"method": "paper"}], {"filter": {"kind": "box"}}, "run.stages[1].filter.kind"),
        (
            [{"filter": {"kind": "gaussian"}}],
            {"run.method": "paper", "filter": {"kind": "box"}},
            "filter.kind",
        ),
        (
            [{}, {"control_points": [90, 90]}],
            {"run.method": "paper", "run.parametrisation": "dense"},
            "run.stages[1].parametrisation",
        ),
    ],
)
def test_impossible_later_stage_is_refused_before_the_first(
    make_scene, disc, monkeypatch, stages, changes, path
):
    monkeypatch.setattr(parametrisation, "available_memory", lambda _: 100_000_000)
    monkeypatch.setattr("workbench.design.run.Room", lambda *_: pytest.fail("a stage began"))
    scene = make_scene({"run.stages": [{"iterations": 1} | stage for stage in stages]} | changes)
    with pytest.raises(Refused) as refused:
        next(run(scene, disc))
    assert refused.value.path == path


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
        assert taken.state.heights["exit"] == pytest.approx(handed.state.heights["exit"], abs=1e-9)
    assert all(s.state.heights["exit"].shape == (9, 9) for s in snapshots)


def test_history_records_where_stages_began(make_scene, disc):
    stages = [{"iterations": 3, "filter": {"size": [7, 7]}}]
    scene = make_scene({"run": {"iterations": 6, "stages": stages}})
    history = History()
    for snapshot in run(scene, disc):
        history.add(snapshot)
    result = history.result()
    assert result.stage_starts == (3,)
    assert result.stages_left == 0
    continued = History(result)
    assert continued.stage_starts() == (3,)
    for snapshot in run(scene, disc, start=result.state.heights):
        assert snapshot.stage == 1  # given heights stand behind all stages
        continued.add(snapshot)
    assert continued.result().stage_starts == (3, 6)


def test_a_result_counts_the_stages_that_are_left(make_scene, disc):
    stages = [{"iterations": 2}, {"iterations": 2}]
    scene = make_scene({"run": {"iterations": 6, "stages": stages}})
    history, left = History(), []
    for snapshot in run(scene, disc):
        history.add(snapshot)
        left.append(history.result().stages_left)
    assert left == [2, 2, 2, 1, 1, 0, 0]


def test_the_papers_extended_source_is_a_scene(make_scene, disc):
    stages = [{"iterations": 15, "source": POINT}]
    scene = make_scene(
        {
            "source": GRID | {"rays": 500},
            "run": {"method": "paper", "learning_rate": 3e-3, "iterations": 30, "stages": stages},
        }
    )
    snapshots = list(run(scene, disc))
    for stage in (0, 1):
        losses = [s.state.loss for s in snapshots if s.stage == stage]
        assert min(losses) < losses[0]
