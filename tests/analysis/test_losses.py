"""Reflection, coating and absorption: in closed form, and the same in all tracers."""

import math

import numpy as np
import pytest
import torch

from workbench.analysis.validation import validate
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account, keys_in
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.path import Path
from workbench.optics.paths import total_reflection
from workbench.optics.plan import Plan
from workbench.scene import Scene

PLATE = {"lens.back": np.full((12, 10), 0.5)}
LOSSES = {
    "fresnel": {"lens.reflection": "fresnel"},
    "schlick": {"lens.reflection": "schlick"},
    "none": {"lens.reflection": "none"},
    "coating": {"lens.coating": [0.01, 0.02]},
    "absorption": {"lens.reflection": "fresnel", "lens.absorption": 0.4},
}
SOURCES = {
    "collimated": {"kind": "collimated", "rays": [64, 64]},
    "point": {"kind": "point", "position": [0.3, 0.2, -1.5], "rays": 20000},
    "grid": {
        "kind": "grid",
        "center": [0.2, 0, -2],
        "half_width": [0.4, 0.2],
        "points": [3, 2],
        "rays": 5000,
    },
}


def checked(scene, heights):
    """Account of the independent check."""
    return validate(scene, np.ones((32, 32)), heights, 100_000).account


def walked(scene, heights):
    """Account of the walk in float64."""
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    leaf = {name: torch.as_tensor(z) for name, z in heights.items()}
    arrival = path.walk(leaf)
    lost = {name: flux.item() for name, flux in arrival.lost.items()}
    return arrival.rays.flux.sum().item(), lost


def planned(scene, heights):
    """Account of the trace that a design takes, in float64."""
    plan = Plan(scene, dtype=torch.float64)
    return plan.trace({name: torch.as_tensor(z) for name, z in heights.items()}).account


@pytest.mark.parametrize("reflection", ["fresnel", "schlick", "none"])
def test_a_plate_absorbs_by_its_thickness_and_no_other_law(make_scene, reflection):
    scene = make_scene({"lens.absorption": 0.6, "lens.reflection": reflection})
    bare = 1.0 if reflection == "none" else 0.96
    passing = bare * math.exp(-0.6 * 0.5)
    for account in (checked(scene, PLATE), planned(scene, PLATE)):
        assert account.on_screen == pytest.approx(passing * bare, rel=1e-12)
        assert account.lost["absorbed"] == pytest.approx(bare - passing, rel=1e-12)
        assert account.lost["fresnel_exit"] == pytest.approx(passing * (1 - bare), abs=1e-12)
    arrived, lost = walked(scene, PLATE)
    assert arrived == pytest.approx(passing * bare, rel=1e-12)
    assert lost["absorbed"] == pytest.approx(bare - passing, rel=1e-12)


@pytest.mark.parametrize("losses", LOSSES.values(), ids=LOSSES)
@pytest.mark.parametrize("source", SOURCES.values(), ids=SOURCES)
def test_design_and_check_lose_the_same_light_and_all_adds_up(make_scene, source, losses):
    screen = {"screen.half_width": [4.0, 4.0]}
    scene = make_scene({"source": source, "lens.refractive_index": 1.8} | screen | losses)
    x, y = ControlNet.of(scene.optic).positions
    heights = {"lens.back": 0.5 - 0.1 * x[:, None] ** 2 + 0.06 * x[:, None] * y[None, :]}
    check, design = checked(scene, heights), planned(scene, heights)
    for account in (check, design):
        assert account.on_screen + sum(account.lost.values()) == pytest.approx(1, abs=1e-9)
    assert check.lost.keys() == design.lost.keys()
    assert check.to_data() == pytest.approx(design.to_data(), abs=2e-3)


def test_steep_light_tells_exact_reflection_from_its_approximation(make_scene):
    """At 60° and an index of 3.5 Fresnel's equations reflect less than Schlick's approximation."""
    far = {"kind": "point", "position": [170.0, 0, -100.0], "rays": 4000}
    changes = {"source": far, "lens.refractive_index": 3.5, "screen.half_width": [40.0, 40.0]}
    found = {}
    for reflection in ("fresnel", "schlick"):
        scene = make_scene(changes | {"lens.reflection": reflection})
        account = checked(scene, PLATE)
        met = account.emitted - account.lost["missed_lens"]
        found[reflection] = account.lost["fresnel_entrance"] / met
        design = planned(scene, PLATE)
        assert design.to_data() == pytest.approx(account.to_data(), abs=5e-3)
    cosine = 100 / math.hypot(170, 100)
    inside = math.sqrt(1 - (1 - cosine**2) / 3.5**2)
    across = ((cosine - 3.5 * inside) / (cosine + 3.5 * inside)) ** 2
    within = ((3.5 * cosine - inside) / (3.5 * cosine + inside)) ** 2
    head_on = (2.5 / 4.5) ** 2
    assert found["fresnel"] == pytest.approx((across + within) / 2, abs=2e-3)
    assert found["schlick"] == pytest.approx(head_on + (1 - head_on) * (1 - cosine) ** 5, abs=2e-3)


def lens(name, z, half_width, back, **more):
    faces = [{"shape": "plane"}, back]
    element = {"kind": "lens", "name": name, "position": [0, 0, z], "thickness": 1}
    return element | {"half_width": [half_width] * 2, "material": "PMMA", "faces": faces} | more


@pytest.fixture
def folded():
    """Two lenses and a mirror, each of which loses light in several ways; heights of the second."""
    fold = {"kind": "mirror", "name": "fold", "position": [0, 0, 9], "tilt": [0, 45, 0]}
    data = {
        "version": 3,
        "source": {"kind": "point", "position": [0, 0, -6], "rays": 40_000},
        "elements": [
            lens("first", 0, 2, {"shape": "conic", "radius": -4}, absorption=0.1),
            lens("second_1", 2.5, 1.8, {"shape": "bspline", "control_points": [12, 12]}),
            fold | {"half_width": [1.5, 1.2], "face": {"shape": "plane"}, "reflectance": 0.9},
        ],
        "images": [
            {
                "receiver": {"kind": "plane", "position": [-8, 0, 9], "tilt": [0, -90, 0]}
                | {"half_width": [1.5, 1.5], "pixels": [32, 32]},
                "target": {"builtin": "tophat"},
            }
        ],
    }
    scene = Scene.from_data(data)
    x, y = ControlNet.of(scene.optic).positions
    rise = 1.6 * np.clip(x - 0.9, 0, None)[:, None] - 0.05 * y**2
    return scene, {"second_1.back": scene.optic.base.height + rise}


def test_losses_of_a_train_name_their_element_and_are_those_of_the_check(folded):
    scene, heights = folded
    check = checked(scene, heights)
    tensors = {face: torch.as_tensor(z) for face, z in heights.items()}
    walk = Plan(scene, dtype=torch.float64, fused=False).trace(tensors).account
    beams = [
        BeamPlan(scene, (96, 96), dtype=torch.float64, fused=fused).trace(tensors).account
        for fused in (True, False)
    ]
    for design in (planned(scene, heights), walk, *beams):
        assert set(check.lost) == set(design.lost) == set(keys_in(scene))
        assert design.on_screen + sum(design.lost.values()) == pytest.approx(1, abs=1e-12)
        assert design.to_data() == pytest.approx(check.to_data(), abs=5e-3)
    assert check.on_screen + sum(check.lost.values()) == pytest.approx(1, abs=1e-12)
    assert list(check.lost) == list(design.lost) == list(keys_in(scene))
    for key in ("missed_lens@first", "absorbed@first", "total_reflection@second_1"):
        assert check.lost[key] > 0.02
    for key in ("missed_lens@second_1", "missed_mirror@fold", "absorbed_mirror@fold"):
        assert check.lost[key] > 0.01
    arrived = 1 - sum(flux for key, flux in check.lost.items() if key != "off_screen")
    assert check.lost["absorbed_mirror@fold"] == pytest.approx(arrived / 9, rel=1e-9)


def test_advice_and_total_reflection_name_the_element(folded):
    scene, heights = folded
    account = checked(scene, heights)
    least = Account(0.1, account.lost | {"total_reflection@second_1": 0.7})
    assert least.advice(scene) == (
        "Only 10.0 % of the light lands on the screen; 70 % is totally reflected (second_1): "
        "thicker stock, a lower index or a target that needs less bending lets it out."
    )
    found = total_reflection(scene, heights)
    assert found.share == pytest.approx(account.lost["total_reflection@second_1"], rel=0.05)
    assert "totally reflected at the exit face of second_1, most" in found.sentence(scene)


def test_a_run_that_asks_for_bends_names_the_face_of_degree_1(folded):
    data = folded[0].to_data()
    data["elements"][1]["faces"][1]["degree"] = [1, 1]
    expected = r"run.smoothness: 2 is about curvature.* elements\[1\].faces\[1\].degree"
    with pytest.raises(Refused, match=expected):
        Scene.from_data(data | {"run": {"smoothness": 2.0}})
