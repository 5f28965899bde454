"""Lenses shaped by hand are judged as those of a run."""

import numpy as np
import pytest

from workbench.design.evaluation import Evaluator
from workbench.design.run import run

PAPER = {"method": "paper", "iterations": 3}
POINT = {"kind": "point", "position": [0.0, 0.0, -5.0], "rays": 4096}


@pytest.fixture
def target():
    image = np.zeros((32, 32))
    image[8:20, 10:26] = 1.0
    return image


@pytest.mark.parametrize(
    "changes", [{}, {"run": PAPER}, {"source": POINT}, {"source": POINT, "run": PAPER}]
)
def test_a_lens_is_judged_as_by_its_run(make_scene, target, changes):
    scene = make_scene(changes)
    *_, last = run(scene, target)
    found = Evaluator(scene, target, last.state.heights).snapshot(last.state.heights)
    continued = next(run(scene, target, last.state.heights))
    assert found.state.loss == pytest.approx(continued.state.loss, rel=2e-2)
    lit = continued.state.irradiance.max()
    np.testing.assert_allclose(found.state.irradiance, continued.state.irradiance, atol=1e-2 * lit)
    parts = found.state.account.to_data()
    assert sum(parts.values()) == pytest.approx(2 * parts["emitted"], rel=1e-5)
    assert found.state.heights is not last.state.heights
    assert not found.state.heights["exit"].flags.writeable
