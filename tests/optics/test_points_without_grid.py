"""Points that are no grid share no samples of the exit face: their rays search for it."""

from typing import Literal

import numpy as np
import pytest
import torch

from workbench.geometry.surface import ControlNet
from workbench.optics import sources
from workbench.optics.face_samples import SampledFace
from workbench.optics.path import Path
from workbench.optics.plan import Plan
from workbench.optics.sources import PointEmitter
from workbench.scene import LightOfPoints


class Pair(LightOfPoints):
    """Two points on a diagonal."""

    middle = "center"

    kind: Literal["pair"] = "pair"
    center: tuple[float, float, float]
    rays: int = 4000

    @property
    def positions(self):
        return np.add(self.center, [[-0.2, -0.2, 0.0], [0.2, 0.2, 0.0]])


@pytest.fixture
def lit(make_scene, monkeypatch):
    monkeypatch.setitem(sources._EMITTERS, Pair, PointEmitter)
    scene = make_scene({"filter": {"kind": "box"}})  # which spreads no light over the rim
    return scene.model_copy(update={"source": Pair(center=(0.0, 0.0, -5.0))})


def test_a_grid_alone_is_sampled(lit, make_scene):
    grid = {"kind": "grid", "center": [0, 0, -5], "half_width": [0.2, 0.2], "points": [2, 2]}
    scene = make_scene({"source": grid})
    samples = (16, 16)
    assert SampledFace.of(Path.of(scene, ControlNet.of(scene.lens), samples=samples)) is not None
    assert SampledFace.of(Path.of(lit, ControlNet.of(lit.lens), samples=samples)) is None


@pytest.mark.parametrize("fused", [False, True])
def test_all_of_their_light_is_accounted_for(lit, fused):
    heights = torch.full(lit.lens.control_points, 0.5, dtype=torch.float64)
    light = Plan(lit, fused=fused, samples=(16, 16)).trace({"exit": heights})
    on_screen = float(light.flux.sum())
    assert 0.1 < on_screen < 1
    lost = sum(light.account.lost.values())
    assert on_screen + lost == pytest.approx(light.account.emitted, abs=1e-5)
