"""The compiled train against the walk in torch, for elements of all kinds in all places."""

import numpy as np
import pytest
import torch

from tests.optics.train.trains import NAMES, cotangent_of, heights_of, landed, path_of
from workbench.optics.reference import Reference
from workbench.optics.train.compiled import CompiledTrain

CASES = [(name, light) for name in NAMES for light in ("directions", "points")]
EACH = pytest.mark.parametrize(
    ("name", "light"),
    [*CASES, ("lens", "beam"), ("two faces", "beam")],
)


@EACH
def test_nodes_accounts_and_gradients_are_those_of_the_walk(name, light):
    path = path_of(name, light, (30, 24), outline="ellipse" if light == "points" else "rectangle")
    heights, cotangent = heights_of(path), cotangent_of(path)
    assert CompiledTrain.matches(path)
    (nodes, account, gradients), (fused, fused_account, fused_gradients) = (
        landed(tracer, heights, cotangent) for tracer in (Reference(path), CompiledTrain(path))
    )
    assert ((nodes[2] > 0) == (fused[2] > 0)).all()
    assert (nodes[2] > 0).double().mean() > 0.15
    assert (fused - nodes).abs().max() < 1e-10 * (1 + nodes.abs().max())
    assert fused_account == pytest.approx(account, abs=1e-11)
    assert sum(fused_account.values()) == pytest.approx(2, abs=1e-11)  # and once as emitted
    for one, other in zip(fused_gradients, gradients, strict=True):
        assert (one - other).norm() <= 1e-10 * other.norm()


@EACH
def test_gradients_are_those_of_central_differences(name, light):
    path = path_of(name, light, (20, 16))
    tracer, heights, cotangent = CompiledTrain(path), heights_of(path, 3), cotangent_of(path)
    _, _, gradients = landed(tracer, heights, cotangent)
    generator, step = np.random.default_rng(0), 1e-6
    for (face, each), gradient in zip(heights.items(), gradients, strict=True):
        way = torch.tensor(generator.normal(size=each.shape))
        ahead, behind = (
            landed(tracer, heights | {face: each + sign * step * way}, cotangent)[0] * cotangent
            for sign in (1, -1)
        )
        assert ((ahead[2] != 0) == (behind[2] != 0)).all()
        expected = ((ahead - behind).sum() / (2 * step)).item()
        assert (gradient * way).sum().item() == pytest.approx(expected, rel=5e-6, abs=1e-9)


@EACH
def test_single_precision_is_enough(name, light):
    """To 3e-5 of a pixel; accounts to 1e-6 of all light, gradients to 5e-6."""
    path = path_of(name, light, (30, 24))
    heights, cotangent = heights_of(path), cotangent_of(path)
    flux = landed(CompiledTrain(path), heights, cotangent)[0][2]
    # Near total reflection rounding grows as 1/cos of the refracted angle; flux falls as this cos.
    weight = flux / flux.max()
    (nodes, account, gradients), (single, rounded, single_gradients) = (
        landed(CompiledTrain(path_of(name, light, (30, 24), dtype)), heights, cotangent * weight)
        for dtype in (torch.float64, torch.float32)
    )
    same = (nodes[2] > 0) == (single[2] > 0)
    assert same.double().mean() > 0.999
    assert ((single - nodes).abs() * same * weight).max() < 3e-5
    assert rounded == pytest.approx(account, abs=1e-6)
    if same.all():
        for one, other in zip(single_gradients, gradients, strict=True):
            assert (one - other).norm() <= 5e-6 * other.norm()
