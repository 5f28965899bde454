"""Heights and their limits, also beside an elliptic outline."""

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

from tests.scenes import changed
from workbench.design.bounds import HeightRange
from workbench.design.limits import HeightLimits, bounded
from workbench.design.run import run
from workbench.geometry.surface import ControlNet, sample_faces
from workbench.scene import Scene
from workbench.targets import load_target

BASES = [
    {"shape": "flat", "height": 0.5},
    {"shape": "sphere", "height": 0.5, "radius": 4.0, "form": "concave"},
    {"shape": "sphere", "height": 0.6, "radius": 8.0, "form": "convex"},
]


def lens_with(base, thickness=0.05):
    fields = {"base": base, "control_points": [9, 7], "height_range": [-0.2, 0.3]}
    fields |= {"min_thickness": thickness}
    return Scene.from_data(changed({f"lens.{name}": value for name, value in fields.items()})).optic


@pytest.mark.parametrize("base", BASES, ids=str)
def test_the_undesigned_lens_is_the_base_plus_the_middle_of_the_range(base):
    lens = lens_with(base)
    net = ControlNet.of(lens)
    free = HeightRange.within(HeightLimits.of(lens, net))
    x, y = net.positions
    expected = lens.base.height_at(x[:, None], y[None, :]) + 0.05
    assert free.heights(free.rest).numpy() == pytest.approx(expected, abs=1e-14)


@given(
    seed=st.integers(0, 1000),
    size=st.sampled_from([0.1, 10.0, 1e6]),
    base=st.sampled_from(BASES),
    thickness=st.sampled_from([0.0, 0.05, 0.45]),
)
def test_no_parameters_leave_the_range_or_make_the_lens_too_thin(seed, size, base, thickness):
    lens = lens_with(base, thickness)
    net = ControlNet.of(lens)
    free = HeightRange.within(HeightLimits.of(lens, net))
    parameters = torch.as_tensor(np.random.default_rng(seed).normal(0, size, net.shape))
    heights = free.heights(parameters).numpy()
    x, y = net.positions
    offset = heights - lens.base.height_at(x[:, None], y[None, :])
    assert offset.max() <= 0.3 + 1e-12
    assert (offset.min() >= -0.2 - 1e-12) or heights.min() >= thickness
    assert heights.min() >= lens.entrance_z + thickness - 1e-12
    surface = sample_faces(lens, {"lens.back": heights}, (40, 40))["lens.back"][..., 2]
    assert surface.min() >= lens.entrance_z + thickness - 1e-12


@pytest.fixture
def limits_of(make_scene):
    """Limits of the small scene with some fields changed."""

    def make(changes):
        lens = bounded(make_scene(changes))
        return HeightLimits.of(lens, ControlNet.of(lens))

    return make


@pytest.fixture
def bowl():
    """A surface of the small scene's size that is 1 cm higher at its rim, at any height."""
    across, up = (np.linspace(-1, 1, n) for n in (12, 10))
    return 7.0 + np.maximum(np.abs(across[:, None]), np.abs(up[None, :]))


def test_a_range_and_both_thicknesses_hold_together(limits_of):
    limits = limits_of({"lens.max_thickness": 0.7, "lens.min_thickness": 0.3})
    assert (limits.lower == 0.3).all() and (limits.upper == 0.7).all()
    limits = limits_of({"lens.max_thickness": 2.0})
    assert limits.lower == pytest.approx(0.2) and limits.upper == pytest.approx(0.8)


def test_without_a_range_the_stock_alone_limits_the_lens(limits_of):
    limits = limits_of({"lens.height_range": None, "lens.max_thickness": 2.0})
    assert (limits.lower == 0.05).all() and (limits.upper == 2.0).all()
    assert (limits.undesigned == 0.5).all()


def test_a_surface_that_does_not_fit_is_cut_off_at_the_ends(limits_of, bowl):
    limits = limits_of({})
    assert limits.lacks(bowl) == pytest.approx(np.ptp(bowl) - 0.6)
    assert not limits.hold(bowl)
    cut = limits.nearest(bowl)
    assert limits.hold(cut) and limits.nearest(cut) is cut
    assert cut.min() == 0.2 or cut.max() == 0.8


ROUND = {"lens.outline": "ellipse", "lens.control_points": [32, 32]}


def test_heights_beside_the_lens_need_not_fit(make_scene):
    scene = make_scene(ROUND)
    net = ControlNet.of(scene.optic)
    limits = HeightLimits.of(scene.optic, net)
    assert not limits.shaping[0, 0]
    assert limits.shaping[16, 0]
    heights = np.full((32, 32), 0.5)
    heights[0, 0] = 7.0
    assert limits.hold(heights)
    assert limits.lacks(heights) < 0
    assert not limits.ends(heights, 0.01)[1].any()
    heights[16, 0] = 7.0
    assert not limits.hold(heights)
    assert limits.lacks(heights) > 0


def test_a_design_of_an_elliptic_lens_comes_near_the_target(make_scene, tmp_path):
    changes = ROUND | {"target": {"builtin": "ball"}, "run.iterations": 25}
    errors = {}
    for outline in ("rectangle", "ellipse"):
        scene = make_scene(changes | {"lens.outline": outline})
        target = load_target(scene, tmp_path)
        *_, last = run(scene, target)
        image = last.state.irradiance / last.state.irradiance.sum()
        wanted = target / target.sum()
        errors[outline] = np.linalg.norm(image - wanted) / np.linalg.norm(wanted)
        heights = last.state.heights["lens.back"]
    assert errors["ellipse"] < 1.5 * errors["rectangle"] + 0.01
    assert last.state.account.lost["missed_lens"] == pytest.approx(1 - np.pi / 4, abs=1e-6)
    second_differences = np.abs(np.diff(heights, 2, axis=0))
    assert (
        second_differences[:, 0].max() < 3 * second_differences[:, 16].max()
    )  # no wild heights beside the lens
