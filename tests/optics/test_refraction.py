"""Refraction, transmittance and total reflection."""

import math

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.interfaces import TransmittanceLaw, refract, root_where_positive
from workbench.optics.paths import total_reflection
from workbench.optics.plan import Plan
from workbench.scene import Scene

DTYPES = [torch.float32, torch.float64]


def incoming(angles, dtype):
    """Rays in the x-z plane at the given angles to the normal +z."""
    angles = torch.as_tensor(angles, dtype=dtype)
    return (angles.sin(), torch.zeros_like(angles), angles.cos()), angles


UP = tuple(torch.tensor(c, dtype=torch.float64) for c in (0.0, 0.0, 1.0))


@pytest.mark.parametrize("ratio", [1.5, 1 / 1.5, 1.0003, 1 / 4])
def test_angles_obey_snell(ratio):
    limit = math.asin(min(1.0, 1 / ratio)) - 1e-6
    direction, angles = incoming(torch.linspace(-limit, limit, 101), torch.float64)
    out = refract(direction, UP, ratio)
    assert out.passes.all()
    assert torch.allclose(out.direction[0], ratio * angles.sin(), atol=1e-14)
    length = sum(c.square() for c in out.direction)
    assert torch.allclose(length, torch.ones_like(length), atol=1e-13)
    assert torch.allclose(out.cos_out, out.direction[2], atol=1e-13)


@pytest.mark.parametrize("law", [TransmittanceLaw.schlick(1.5), TransmittanceLaw.fresnel(1.5)])
@pytest.mark.parametrize("dtype", DTYPES)
def test_beyond_the_critical_angle_nothing_passes_and_nothing_is_nan(dtype, law):
    critical = math.asin(1 / 1.5)
    angles = torch.linspace(0, math.pi / 2, 1001, dtype=dtype).requires_grad_()
    direction = (angles.sin(), torch.zeros_like(angles), angles.cos())
    out = refract(direction, tuple(c.to(dtype) for c in UP), 1.5)
    expected = angles.detach() < critical
    near = (angles.detach() - critical).abs() < 1e-3
    assert torch.equal(out.passes[~near], expected[~near])
    weight = torch.where(out.passes, law.at(out.cos_in, out.cos_out), 0.0)
    (sum(out.direction).sum() + weight.sum()).backward()
    assert torch.isfinite(angles.grad).all()
    assert (weight[~out.passes] == 0).all()


@pytest.mark.parametrize("dtype", DTYPES)
def test_masked_roots_have_no_gradient(dtype):
    square = torch.tensor([-1.0, 0.0, 0.25], dtype=dtype, requires_grad=True)
    root, positive = root_where_positive(square)
    root.sum().backward()
    assert positive.tolist() == [False, False, True]
    assert square.grad.tolist() == [0, 0, 1]


INDEX, RADIUS, NET = 1.5, 1.5, 60


@pytest.fixture(scope="module")
def dome():
    """A scene with a dome that reflects all light beyond R / n from the axis, and its heights."""
    scene = Scene.from_data(
        {
            "format": "freeform-scene",
            "version": 2,
            "unit": "mm",
            "lens": {
                "half_width": [1.0, 1.0],
                "refractive_index": INDEX,
                "control_points": [NET, NET],
                "base": {"shape": "flat", "height": 3.0},
                "reflection": "none",
            },
            "source": {"kind": "collimated"},
            "far_field": {"half_angle": [90, 90], "pixels": [16, 16]},
            "target": {"builtin": "tophat"},
        }
    )
    x, y = ControlNet.of(scene.optic).positions
    heights = 1.5 + np.sqrt(RADIUS**2 - x[:, None] ** 2 - y**2)
    return scene, {"lens.back": torch.as_tensor(heights)}


@pytest.mark.parametrize("mirrored", [(False, False), (True, False), (True, True)])
@pytest.mark.parametrize("cells", [48, 64])
def test_total_reflection_begins_at_its_angle(dome, cells, mirrored):
    scene, heights = dome
    plan = BeamPlan(scene, (cells, cells), dtype=torch.float64, fused=False, mirrored=mirrored)
    light = plan.trace(heights)
    refracted = math.pi * (RADIUS / INDEX) ** 2 / 4
    # The circle within which rays are refracted holds that many of them, more or less.
    assert light.account.on_screen == pytest.approx(refracted, abs=6e-3)
    assert light.account.lost["total_reflection"] == pytest.approx(1 - refracted, abs=6e-3)
    assert light.flux.sum().item() == pytest.approx(light.account.on_screen, abs=1e-9)
    assert light.flux.min() >= 0


ENTRANCE = {"shape": "freeform", "height_range": [-0.1, 0.1]}


def steep(scene):
    """An exit face that is flat but for a slope of 1.2 in the quarter where x and y are large."""
    x, y = ControlNet.of(scene.optic).positions
    rise = 1.2 * np.clip(x - 0.3, 0, None)[:, None] * (y > 0.1)
    heights = {face: np.zeros(net.shape) for face, net in freeform_nets(scene.optic).items()}
    return heights | {"lens.back": 0.5 + rise}


POINT = {"source": {"kind": "point", "position": [0, 0, -2.0], "rays": 60_000}}


LED = {"source": {"kind": "area", "center": [0, 0, -2.0], "half_width": [0.1, 0.1], "rays": 60_000}}


@pytest.mark.parametrize("source", [{}, POINT, LED], ids=["parallel", "near point", "LED"])
@pytest.mark.parametrize("changes", [{}, {"lens.entrance": ENTRANCE}], ids=["one", "two faces"])
def test_totally_reflected_rays_lie_on_the_steep_part_and_carry_the_flux_of_the_account(
    make_scene, changes, source
):
    scene = make_scene({"lens.control_points": [24, 24]} | changes | source)
    heights = steep(scene)
    found = total_reflection(scene, heights)
    tensors = {face: torch.tensor(each) for face, each in heights.items()}
    account = Plan(scene, dtype=torch.float64).trace(tensors).account
    assert found.share == pytest.approx(account.lost["total_reflection"], rel=0.05)
    x, y, z = found.places.T
    assert x.min() > 0.2 and y.min() > -0.1
    exact, *_ = ControlNet.of(scene.optic).at(x, y, heights["lens.back"])
    np.testing.assert_allclose(z, exact, atol=1e-9)
    x, y = found.middle
    assert x > 0.3 and y > (0.0 if source else 0.1)  # near light is brightest about the axis
    assert found.sentence(scene) == (
        f"{100 * found.share:.2g} % of the light is totally reflected at the exit face, "
        f"most of it around x = {x:.3g} cm, y = {y:.3g} cm"
    )
