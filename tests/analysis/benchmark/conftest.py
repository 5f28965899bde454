import numpy as np
import pytest

from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.targets import load_target


@pytest.fixture
def make_example(make_scene, tmp_path):
    """A small scene as an example: ``make_example({"run.iterations": 3})``."""

    def make(changes=None, name="small"):
        scene = make_scene(changes)
        return BenchmarkTask(name, "Small", scene, load_target(scene, tmp_path))

    return make


@pytest.fixture
def progress():
    """Gathers what a benchmark reports of its progress."""
    lines = []

    def report(case, state):
        lines.append((case, state))

    report.lines = lines
    return report


@pytest.fixture
def impossible(make_example):
    """A scene whose light all passes the screen by."""
    changes = {
        "run.method": "paper",
        "lens.base": {"shape": "sphere", "height": 0.5, "radius": 1.6},
        "screen": {"z": 500.0, "half_width": [0.001, 0.001], "pixels": [4, 4]},
    }
    example = make_example(changes, "impossible")
    assert np.isfinite(example.target).all()
    return example
