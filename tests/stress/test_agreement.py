"""Random tasks of all kinds: a run, cells and random rays say the same of each.

``pytest -m slow tests/stress/test_agreement.py -n 2`` traces 400 tasks of one element and
400 trains in 80 parts. With ``--last-failed`` the parts that failed are traced again,
``-k part_7`` takes two parts, and FREEFORM_STRESS_SEED draws other tasks.
"""

import os

import pytest

from tests.stress.agreement import contradictions, disagreements
from tests.stress.lamps import LAMPS
from tests.stress.random_tasks import TaskDraw
from tests.stress.random_trains import TrainDraw
from workbench.scene import Scene

SEED = int(os.environ.get("FREEFORM_STRESS_SEED", "1"))
PARTS, EACH = 40, 10
# Some that are traced fast; together of all kinds of sources, optics and receivers.
FEW = (3, 4, 18, 43, 44, 45, 48, 57)
# Trains: a designed mirror between lenses, and a fixed B-spline face, both in light of two colours;
# and a point close to a small net.
IN_COLOURS, NEAR_POINT = (6, 43), 145


@pytest.mark.parametrize(
    ("draw", "number"),
    [
        *((TaskDraw, each) for each in FEW),
        *(pytest.param(TrainDraw, each, marks=pytest.mark.full) for each in IN_COLOURS),
        (TrainDraw, NEAR_POINT),
    ],
)
def test_some_tasks(draw, number, monkeypatch):
    monkeypatch.setattr("workbench.analysis.cells.image._BEGIN", 1 << 20)  # made sooner
    traced, stated = disagreements(1, number, draw, accuracy=1e-2)
    assert traced
    assert not stated, "\n".join(stated)


def lens(**fields):
    return {
        "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [16, 16]} | fields
    }


def screen(z, half_width=(3, 3), pixels=(16, 16), **fields):
    return {"screen": {"z": z, "half_width": half_width, "pixels": pixels} | fields}


def far(*half_angle):
    return {"far_field": {"half_angle": half_angle, "pixels": [8, 8]}}


def light(kind, **fields):
    return {"source": {"kind": kind} | fields}


def mirror(**fields):
    return {"mirror": {"half_width": [1, 1], "control_points": [16, 16]} | fields}


BEAM = light("collimated", profile={"kind": "gaussian", "radius": 0.02})
FREE = {"shape": "freeform"}
# Tasks of users for which a run, cells and random rays contradicted each other.
REPORTED = {
    "a beam far narrower than the lens": lens() | BEAM | far(20, 10),
    "such a beam on two faces": lens(entrance=FREE) | BEAM | far(20, 10),
    "such a beam on a net of low degree": lens(degree=[1, 2]) | BEAM | screen(5, [1, 1]),
    "a mirror in tilted light": mirror()
    | light("collimated", direction=[20, -10])
    | screen(-1.2, [30, 18]),
    "a lamp beside a mirror": mirror() | light("point", position=[2, 0, -3]) | screen(-5),
    "tilted light on a freeform entrance face": lens(entrance=FREE | {"height_range": [-0.5, 0.1]})
    | light("collimated", direction=[30, 0])
    | screen(5),
    "a lamp of a file right before the lens": lens()
    | light("photometric", file="crooked.ies", position=[0, -0.5, -0.001])
    | screen(100, [30, 18]),
    "a very far screen": lens() | light("collimated") | screen(1e9, [1, 1]),
    "nearly all directions": lens() | light("collimated") | far(89.9, 89.9),
    "a slim mirror beside a lamp of a file": mirror(
        half_width=[0.27, 0.027], degree=[1, 2], outline="ellipse"
    )
    | light("photometric", file="crooked.ies", position=[0.4, 0, -0.5])
    | screen(-0.32, [8, 4.8], [16, 200], tilt=[10, 0]),
}
SLOWEST = "a lamp of a file right before the lens"


@pytest.mark.parametrize(
    "task",
    [
        pytest.param(task, marks=pytest.mark.full if name == SLOWEST else (), id=name)
        for name, task in REPORTED.items()
    ],
)
def test_tasks_that_users_reported(task, monkeypatch):
    monkeypatch.setattr("workbench.analysis.cells.image._BEGIN", 1 << 20)  # made sooner
    data = {"version": 2, "unit": "mm", "target": {"builtin": "tophat"}, "run": {"iterations": 1}}
    scene = Scene.from_data(data | task).carrying(LAMPS)
    assert not contradictions(scene, rays=20_000, accuracy=1e-2, share_of_run=0.004)


@pytest.mark.slow
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("part", range(PARTS), ids=lambda part: f"part_{part}")
@pytest.mark.parametrize("draw", [TaskDraw, TrainDraw], ids=["one_element", "trains"])
def test_many_tasks(part, draw):
    found = [disagreements(SEED, EACH * part + number, draw) for number in range(EACH)]
    assert any(traced for traced, _ in found)  # most tasks are no refusals
    stated = [each for _, some in found for each in some]
    assert not stated, "\n".join(stated)
