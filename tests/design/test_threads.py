"""The lens of a task does not depend on the number of threads that design it."""

from pathlib import Path

import pytest
import torch

from tests.scenes import changed
from workbench.design.run import run
from workbench.design.task import begin
from workbench.scene import Scene

MIRROR = {"half_width": [1.0, 1.0], "control_points": [16, 16]}
TASKS = {
    "collimated": {},
    "sun": {"source": {"kind": "collimated", "angular_diameter": 0.5}},
    "point": {"source": {"kind": "point", "position": [0, 0, -4]}},
    "paper": {"run": {"method": "paper", "iterations": 2, "start": "random", "seed": 3}},
    "mirror": {"lens": None, "mirror": MIRROR, "screen.z": -5, "source": {"kind": "collimated"}},
    "two faces": {"lens.entrance": {"shape": "freeform"}},
}


@pytest.mark.parametrize("changes", TASKS.values(), ids=TASKS.keys())
def test_the_same_bits_on_one_thread_and_on_two(changes):
    large = {"screen.pixels": [48, 48], "lens.control_points": [16, 16]}
    data = {"version": 2, "run": {"iterations": 1}, "source": {"kind": "collimated"}}
    given = {"target": {"builtin": "flame"}, **large, **data, **changes}
    if "mirror" in changes:
        del given["lens.control_points"]
    task = begin(Scene.from_data(changed(given)), Path())
    found = []
    before = torch.get_num_threads()
    try:
        for threads in (1, 2):
            torch.set_num_threads(threads)
            *_, last = run(task.scene, task.target)
            state = last.state
            found.append([*map(bytes, state.heights.values()), state.irradiance.tobytes()])
    finally:
        torch.set_num_threads(before)
    assert found[0] == found[1]
