"""What came out of a design: closed cases of each finding, its level and its cure."""

import numpy as np
import pytest

from tests.accounts import account_of
from workbench.design.lens_state import LensState
from workbench.design.limits import Shortfall
from workbench.design.session import Session, VerifiedError
from workbench.design.snapshot import MET, SLOW, STOPPED, Result
from workbench.geometry.faces import FaceArrays
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.report.findings import Attainable, findings

SETTLED = Message(SLOW, gain=5, patience=5)
NARROW = Shortfall("height_range", (-2.2, 2.2), (-0.3, 0.3), 0.4)
THIN = Shortfall("max_thickness", (0.1, 0.9), (0.1, 0.6), 0.4)
LOST = Account(
    0.08,
    {
        "off_screen": 0.07,
        "missed_lens": 0.03,
        "left_side": 0.57,
        "total_reflection": 0.11,
        "fresnel_entrance": 0.12,
        "fresnel_exit": 0.02,
    },
)


@pytest.fixture
def judge(make_scene):
    """Judges a lens of a square target whose image has an error and an evenness."""

    def judge(error=0.02, ended=SETTLED, changes=None, target=None, least=1.0, **given):
        scene = make_scene(changes)
        if target is None:
            target = np.zeros((32, 32))
            target[8:24, 8:24] = 1.0
        image = target.copy()
        image[8, 8] *= least
        share = target / target.sum()
        known = {
            "loss": error * float(np.linalg.norm(share)) / target.size**0.5,
            "account": account_of(1.0, 0.92, 0.0, 0.0, 0.0, 0.0, 0.05, 0.03),
        }
        seen = {"verified", "attainable", "reflection"}
        known |= {name: value for name, value in given.items() if name not in seen}
        heights = FaceArrays({"lens.back": np.full((12, 10), 0.5)})
        result = Result(LensState(heights, image, **known), np.ones(3), 1.0, ended=ended)
        session = Session(scene, target, result)
        passed = {name: value for name, value in given.items() if name in seen}
        return {found.key: found for found in findings(session, result, **passed)}

    return judge


def test_a_task_without_a_lens_is_to_be_started(judge, make_scene):
    session = Session(make_scene(), np.ones((32, 32)))
    state = LensState(
        FaceArrays({}), np.ones((32, 32)), 1.0, account_of(1.0, 0.9, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0)
    )
    (found,) = findings(session, Result(state, np.zeros(0), 0.0))
    assert (found.key, found.level, found.cure.command) == ("lens", "attention", "start")
    assert found.sentence == "There is no lens yet."


def test_a_settled_lens_without_obstacles_is_good_and_its_error_is_computed(judge):
    error = judge()["error"]
    assert (error.level, error.sentence) == ("good", "2.0 % computed error, not verified yet.")
    assert error.cure.command == "check"


def test_the_verified_error_replaces_the_computed_one(judge):
    error = judge(verified=VerifiedError(0.0234, (0.023, 0.024)))["error"]
    assert (error.level, error.sentence) == ("good", "2.34 % verified error.")
    assert error.cure is None


@pytest.mark.parametrize("ended", [Message(STOPPED), ""])
def test_a_lens_that_is_not_settled_goes_on(judge, ended):
    error = judge(ended=ended)["error"]
    assert (error.level, error.cure.command) == ("attention", "continue")


def test_a_high_error_is_good_where_the_lower_bound_explains_it(judge):
    net = {"lens.control_points": [400, 400]}  # fine enough
    explained = judge(0.07, changes=net, attainable=Attainable(0.06))["error"]
    assert explained.sentence == "7.0 % computed error, not verified yet; no lens gets below 6.0 %."
    assert explained.level == "good"
    assert judge(0.07, changes=net, attainable=Attainable(0.01))["error"].level == "attention"
    assert judge(0.07, changes=net)["error"].level == "attention"


@pytest.mark.parametrize(("error", "level"), [(0.019, "good"), (0.021, "bad")])
def test_a_goal_decides_whatever_else_there_is(judge, error, level):
    goal = {"run.max_error": 0.02}
    assert judge(error, changes=goal)["error"].level == level
    assert judge(error, STOPPED, goal)["error"].level == level
    high = VerifiedError(error, (error, error))
    assert judge(0.01, changes=goal, verified=high)["error"].level == level


def test_a_run_that_met_its_goal_is_checked_next(judge):
    met = Message(MET, error="1.9 %", goal="2.0 %")
    assert judge(0.019, met, {"run.max_error": 0.02})["error"].cure.command == "check"


def test_the_light_is_stated_beside_what_is_possible(judge):
    assert judge()["light"].sentence == (
        "92.0 % of the light lands on the screen; 5.0 % is reflected at the entrance."
    )
    light = judge(attainable=Attainable(None, 0.9216))["light"]
    assert light.level == "good" and light.sentence == (
        "92.0 % of the light lands on the screen, of at most 92.2 %; 5.0 % is reflected at the "
        "entrance."
    )


def test_lost_light_names_its_cure_and_hinders_the_error(judge):
    found = judge(account=LOST)
    assert found["light"].level == found["error"].level == "attention"
    assert found["light"].sentence == (
        "Only 8.0 % of the light lands on the screen; 57 % leaves by the side: a thinner lens, or "
        "a source farther away or nearer to the axis, keeps it."
    )


def test_a_low_error_is_good_however_much_light_is_lost(judge):
    found = judge(0.002, account=LOST)
    assert (found["error"].level, found["light"].level) == ("good", "attention")


@pytest.mark.parametrize(("goal", "level"), [(0.92, "good"), (0.93, "bad")])
def test_a_goal_for_the_light(judge, goal, level):
    assert judge(changes={"run.min_light": goal})["light"].level == level


def test_total_reflection_is_named_with_its_cure(judge):
    reflected = judge(account=LOST)["reflection"]
    assert reflected.sentence.startswith("11 % of the light is totally reflected: thicker stock")
    assert reflected.level == "attention" and "reflection" not in judge()


def test_uniformity_of_an_even_square(judge):
    even = judge(least=0.5)["uniformity"]
    mean = (255 + 0.5) / 256
    assert even.sentence == (
        f"{0.5 / mean:.2f} uniformity U₀ (minimum / average) on the lit area of the target; U₁ "
        "(minimum / maximum) is 0.50."
    )
    assert even.level == "good"
    assert judge(least=0.5, changes={"run.min_uniformity": 0.5})["uniformity"].level == "good"
    assert judge(least=0.5, changes={"run.min_uniformity": 0.8})["uniformity"].level == "bad"


def test_targets_that_are_not_one_even_region_have_no_uniformity(judge):
    ring = np.zeros((32, 32))
    ring[8:24, 8:24] = 1.0
    assert "uniformity" in judge(target=ring)
    letter = ring.copy()
    letter[8:20, 12:24] = 0.0
    grey = ring.copy()
    grey[8:16] *= 0.8
    for target in (letter, grey):
        assert "uniformity" not in judge(target=target)


def test_a_coarse_net_is_refined(judge, rng):
    found = judge(0.3, target=0.1 + rng.random((32, 32)))
    net = found["net"]
    assert net.sentence.startswith("12 × 10 control points are too few")
    assert net.cure.command == "start" and found["error"].level == "attention"
    assert net.cure.changes == {"elements[0].faces[1].control_points": "auto"}


def test_a_narrow_range_is_widened(judge):
    found = judge(shortfall=NARROW)
    limits, path = found["limits"], "elements[0].faces[1].height_range"
    assert limits.sentence == "The lens needs ±2.2 cm; ±0.3 cm is allowed."
    assert limits.cure.changes == {path: None} and limits.cure.command == "start"
    assert found["error"].level == "attention"
    automatic = judge(shortfall=NARROW, changes={"lens.height_range": None})["limits"]
    assert automatic.cure.changes == {path: pytest.approx([-2.42, 2.42])}


def test_too_thin_stock_has_no_edit(judge):
    limits = judge(shortfall=THIN)["limits"]
    assert limits.cure is None and limits.sentence == (
        "The lens needs to be 0.9 cm thick; the stock allows 0.6 cm: thicker stock, or a smaller "
        "minimal thickness, lets the lens bend more."
    )


def test_a_narrow_entrance_is_widened(judge):
    narrow = Shortfall("entrance_range", None, (-0.01, 0.01), 0.95)
    front = {"shape": "freeform", "control_points": [8, 8], "height_range": [-0.01, 0.01]}
    limits = judge(shortfall=narrow, changes={"version": 2, "lens.entrance": front})["limits"]
    low, high = limits.cure.changes["elements[0].faces[0].height_range"]
    assert low < -0.01 and high > 0.01
