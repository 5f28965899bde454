"""The account of light is of rays: a reconstruction filter moves none of it over the rim."""

import pytest
import torch

from tests.accounts import account_of
from workbench.optics.account import LOSSES, Account, UnbalancedAccount
from workbench.optics.plan import Plan

COLLIMATED = {"kind": "collimated", "rays": [64, 48]}
POINT = {"kind": "point", "position": [0.1, 0, -40], "rays": 3000}
WAYS = pytest.mark.parametrize(
    ("source", "samples"),
    [(COLLIMATED, None), (POINT, None), (POINT, (64, 48))],
    ids=["collimated", "rays", "samples"],
)
TWINS = pytest.mark.parametrize("fused", [False, True], ids=["reference", "kernel"])
WIDE = {"kind": "gaussian", "size": [5, 5], "alpha": 0.2}


@WAYS
@TWINS
@pytest.mark.parametrize("dtype", [torch.float32, torch.float64])
def test_a_plate_has_all_its_light_on_a_screen_that_just_holds_it(
    make_scene, source, samples, fused, dtype
):
    changes = {"source": source, "screen.half_width": [1.14, 1.14], "screen.pixels": [1, 8]}
    scene = make_scene(changes | {"filter": WIDE})
    heights = torch.full((12, 10), 0.5, dtype=torch.float64)
    traced = Plan(scene, dtype=dtype, fused=fused, samples=samples).trace({"lens.back": heights})
    account = traced.account
    assert account.lost["off_screen"] == 0
    met = (1 - account.lost["missed_lens"]) * 0.96 - account.lost["left_side"]
    assert account.on_screen == pytest.approx(met * 0.96, rel=1e-3)
    assert traced.flux.sum().item() < 0.9 * account.on_screen
    emitted, *parts = account.to_data().values()
    assert sum(parts) == pytest.approx(emitted, abs=1e-5 if dtype == torch.float32 else 1e-12)


@WAYS
@TWINS
def test_the_account_does_not_depend_on_the_filter(make_scene, rng, source, samples, fused):
    heights = torch.tensor(0.5 + 0.1 * rng.random((12, 10)))
    accounts = []
    for filter in ({"kind": "box"}, WIDE):
        scene = make_scene({"source": source, "filter": filter})
        plan = Plan(scene, dtype=torch.float64, fused=fused, samples=samples)
        accounts.append(plan.trace({"lens.back": heights}).account.to_data())
    assert accounts[0]["off_screen"] > 0.01
    assert accounts[1] == pytest.approx(accounts[0], abs=1e-12)


def test_losses_are_listed_in_one_order_and_none_of_version_1_is_left_out():
    account = Account(0.5, {"fresnel_exit": 0.1, "off_screen": 0.4})
    assert list(account.lost) == [name for name, loss in LOSSES.items() if loss.always]
    assert list(Account(0.5, dict.fromkeys(reversed(LOSSES), 0.1)).lost) == list(LOSSES)
    assert {name: flux for name, flux in account.lost.items() if flux} == {
        "off_screen": 0.4,
        "fresnel_exit": 0.1,
    }


def test_advice_names_the_largest_loss_before_the_screen_and_its_cure(make_scene):
    scene = make_scene()
    account = account_of(2.0, 0.2, 0.1, 0.1, 1.2, 0.2, 0.1, 0.1)
    assert account.advice(scene) == (
        "Only 10.0 % of the light lands on the screen; 60 % leaves by the side: a thinner lens, or "
        "a source farther away or nearer to the axis, keeps it."
    )
    assert not account_of(2.0, 0.2, 0.9, 0.0, 0.7, 0.0, 0.1, 0.1).advice(scene)


def test_the_error_of_samples_is_no_loss():
    """Where samples have 0.1 % more light than there is, no share is negative."""
    settled = Account(0.801, {"off_screen": 0.2, "left_side": -0.001}).settled()
    assert min(settled.lost.values()) == 0
    assert settled.on_screen == pytest.approx(0.801 / 1.001)
    emitted, *parts = settled.to_data().values()
    assert sum(parts) == pytest.approx(emitted, abs=1e-12)


@pytest.mark.parametrize(
    ("on_screen", "lost"),
    [
        (1.1326, {"off_screen": 0.0038, "missed_mirror": -0.1364}),
        (3.326, {"off_screen": 0.179, "left_side": -2.505}),
        (0.5, {"off_screen": 0.2}),
        (float("nan"), {"off_screen": 0.2}),
    ],
)
def test_light_that_does_not_add_up_is_a_defect(on_screen, lost):
    with pytest.raises(UnbalancedAccount, match="does not add up: emitted 1, on_screen"):
        Account(on_screen, lost).settled()
