"""Plans of a shop: step-over and polishing for a wanted error as made."""

import numpy as np
import pytest

from tests.scenes import changed
from workbench.analysis.making.as_made import checking
from workbench.analysis.making.plan import fitting_ball, planning
from workbench.analysis.making.plan_options import PlanOptions
from workbench.cutters import cutter_name, cutter_radii
from workbench.design.run import run
from workbench.errors import Refused
from workbench.progress import finished
from workbench.scene import Scene


@pytest.fixture(scope="module")
def plate():
    small = {"lens.control_points": [40, 40], "screen.pixels": [40, 40]}
    scene = Scene.from_data(changed(small))
    target = np.full((40, 40), 0.2)
    target[8:32, 10:16] = target[26:32, 16:30] = 1.0
    *_, last = run(scene, target)
    return scene, target, last.state.heights


@pytest.mark.full
def test_the_check_finds_what_the_cheapest_plan_promises(plate):
    scene, target, heights = plate
    options = PlanOptions(error=5, ball=0.1)
    found = finished(planning(scene, target, heights, options, rays=200_000))
    minutes = [plan.minutes for plan in found.plans]
    assert minutes == sorted(minutes)
    plan = found.plans[0]
    made = scene.altered(processes=plan.processes)
    error = finished(checking(made, target, heights)).steps[-1].error
    assert error == pytest.approx(plan.error, rel=0.03)
    assert error < 1.03 * found.wanted


@pytest.mark.full
def test_polishing_pays_where_it_is_cheap(plate):
    scene, target, heights = plate
    cheap, dear = (
        finished(planning(scene, target, heights, options, rays=200_000)).plans[0]
        for options in (PlanOptions(error=5, ball=0.1, polish_time=t) for t in (1e-6, 1e6))
    )
    assert cheap.polishing is not None
    assert dear.polishing is None or dear.polishing.width < cheap.polishing.width
    assert cheap.milling.step_over > dear.milling.step_over


def test_what_cannot_be_reached_is_refused_with_what_can_be(plate, few_plans):
    scene, target, heights = plate
    with pytest.raises(
        Refused, match=r"error: 0\.01 % as made is not reached .* more than [\d.]+ % may be"
    ):
        finished(planning(scene, target, heights, PlanOptions(error=0.01, ball=0.1)))


def test_the_ball_fits_and_can_be_bought(plate):
    scene, *_ = plate
    waves = np.cos(np.arange(40))[:, None] * np.ones(40)
    largest, smaller, special = (
        fitting_ball(scene, {"lens.back": 0.5 + depth * waves}) for depth in (0, 0.01, 0.1)
    )
    assert cutter_name(largest, scene.unit) == "1/4 inch"
    assert smaller < largest and cutter_name(smaller, scene.unit) is not None
    assert cutter_radii(scene.unit, special) == []  # no standard cutter fits
