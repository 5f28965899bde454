"""Runs of the paper's method that shape a mirror."""

import numpy as np
import pytest

from workbench.design.run import run
from workbench.scene import Scene

SOURCES = {
    "collimated": {"kind": "collimated", "rays": [48, 48]},
    "point": {"kind": "point", "position": [0.0, 0.0, -3.0], "rays": 3000},
}


@pytest.fixture
def bar():
    """A rectangle, brighter at one end."""
    image = np.zeros((32, 32))
    image[6:26, 10:22] = 1.0
    image[6:12, 10:22] = 3.0
    return image


@pytest.mark.parametrize(
    ("source", "parametrisation", "start"),
    [
        ("collimated", "none", "zeros"),
        ("collimated", "sparse", "uniform"),
        ("collimated", "dense", "random"),
        ("point", "none", "random"),
        ("point", "sparse", "random"),
    ],
)
def test_the_paper_method_shapes_a_mirror(bar, source, parametrisation, start):
    settings = {"method": "paper", "parametrisation": parametrisation, "start": start}
    scene = Scene.from_data(
        {
            "mirror": {
                "half_width": [1.0, 1.0],
                "control_points": [12, 10],
                "height_range": [-0.3, 0.3],
            },
            "source": SOURCES[source],
            "screen": {"z": -5.0, "half_width": [1.0, 1.0], "pixels": [32, 32]},
            "filter": {"kind": "gaussian", "size": [3, 3], "alpha": 1.0},
            "target": {"builtin": "tophat"},
            "run": settings | {"iterations": 25},
        }
    )
    shots = list(run(scene, bar))
    assert shots[-1].state.loss < 0.9 * shots[0].state.loss
    assert np.abs(shots[-1].state.heights["mirror"]).max() < 0.3
