"""Estimates of 30 jobs drawn at random, against the designs that follow; minutes for each.

Run by hand: ``python -m pytest -m slow -n 0 tests/jobs/test_estimate_of_drawn_jobs.py``.
"""

import math
from pathlib import Path

import pytest

from tests.jobs.drawn_jobs import drawn_jobs
from workbench.analysis.validation import validate
from workbench.design.design_run import DesignRun
from workbench.design.task import begin
from workbench.jobs.estimate import estimating
from workbench.watch import finished

SEED, COUNT = 7, 30
FLOOR = 0.01  # smaller errors count as this one
TIMES, POINTS = 1.5, 0.05
RAYS = 2_000_000


@pytest.mark.slow
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("number", range(COUNT))
def test_the_design_reaches_what_was_estimated(number):
    session = begin(drawn_jobs(COUNT, SEED)[number].scene(), Path("/"))
    estimate = finished(estimating(session))
    expected = max(math.sqrt(estimate.least * estimate.most), FLOOR)
    run = DesignRun(session)
    for _ in run:
        pass
    heights = run.session.heights
    checked = validate(session.scene, session.target, heights, rays=RAYS)
    error = max(checked.relative_l2_corrected, FLOOR)
    light = checked.account.efficiency
    print(f"{number}: {expected:.4f} {error:.4f}; {estimate.light:.3f} {light:.3f}")
    assert error / TIMES <= expected <= TIMES * error
    assert abs(estimate.light - light) <= POINTS
