"""Where light is totally reflected."""

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.plan import Plan
from workbench.optics.total_reflection import total_reflection

ENTRANCE = {"shape": "freeform", "height_range": [-0.1, 0.1]}


def steep(scene):
    """An exit face that is flat but for a slope of 1.2 in the quarter where x and y are large."""
    x, y = ControlNet.of(scene.optic).positions
    rise = 1.2 * np.clip(x - 0.3, 0, None)[:, None] * (y > 0.1)
    heights = {face: np.zeros(net.shape) for face, net in freeform_nets(scene.optic).items()}
    return heights | {"exit": 0.5 + rise}


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
    exact, *_ = ControlNet.of(scene.optic).at(x, y, heights["exit"])
    np.testing.assert_allclose(z, exact, atol=1e-9)
    x, y = found.middle
    assert x > 0.3 and y > (0.0 if source else 0.1)  # near light is brightest about the axis
    assert found.sentence(scene) == (
        f"{100 * found.share:.2g} % of the light is totally reflected at the exit face, "
        f"most of it around x = {x:.3g} cm, y = {y:.3g} cm"
    )
