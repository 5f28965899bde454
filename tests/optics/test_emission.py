"""Rays of points and grids, and what the entrance face makes of them."""

import numpy as np
import pytest
import torch

from tests.optics.rays import bundle, with_rays
from workbench.geometry.surface import ControlNet
from workbench.optics.cap import covering_caps
from workbench.optics.emission import emit
from workbench.optics.intersection import Bundle
from workbench.optics.path import Path
from workbench.scene import AutoRun, PointSource, Scene, Screen

POINT = PointSource(kind="point", position=(0.4, -0.2, -3.0), rays=1 << 16)


@pytest.fixture
def lens(make_scene):
    return make_scene({"lens.half_width": [1.0, 0.8]}).optic


@pytest.mark.parametrize("sampling", ["sobol", "random"])
def test_emission_is_uniform_in_solid_angle(lens, sampling):
    source = POINT.model_copy(update={"sampling": sampling})
    rays = emit(source, lens, seed=3)
    caps = covering_caps(source.positions, lens.half_width, lens.entrance_z)
    (axis,), (cos_max,) = caps.axis, caps.cos_max
    assert np.linalg.norm(rays.direction, axis=1) == pytest.approx(1, abs=1e-14)
    way = rays.direction * (3 / rays.direction[:, 2:])
    assert rays.crossing == pytest.approx(source.positions[:, :2] + way[:, :2], abs=1e-14)
    cos = rays.direction @ axis
    assert cos.min() >= cos_max - 1e-14
    # Zones of equal height hold equal solid angles (Archimedes), and so do sectors.
    zones = np.histogram(cos, bins=8, range=(cos_max, 1))[0]
    assert zones == pytest.approx(source.rays / 8, rel=0.04)
    across = np.linalg.svd(axis[None])[2][1:]
    sectors = np.histogram(np.arctan2(*(across @ rays.direction.T)), 8, (-np.pi, np.pi))[0]
    assert sectors == pytest.approx(source.rays / 8, rel=0.04)
    assert rays.direction.mean(axis=0) == pytest.approx(
        axis * (1 + cos_max) / 2, abs=1e-4 if sampling == "sobol" else 3e-3
    )


def path_of(source, lens):
    screen = Screen(z=5.0, half_width=(1.0, 1.0), pixels=(8, 8))
    scene = Scene.model_construct(lens=lens, source=source, screen=screen, run=AutoRun())
    return Path.of(scene, ControlNet.of(lens), torch.float64)


def entered(source, lens):
    """Rays behind the entrance face as lines, and the light that was lost, by name."""
    path = path_of(source, lens)
    lost = {name: part.item() for name, part in path.lost.items()}
    return Bundle(*(part.numpy() for part in Bundle.of(path.rays))), lost


class TestEntrance:
    def test_snells_law_by_angles(self, lens):
        rays = emit(POINT, lens, seed=0)
        inside, lost = entered(POINT, lens)
        path = (lens.entrance_z + 3.0) / rays.direction[:, 2:]
        x, y = (POINT.position + rays.direction * path).T[:2]
        meets = (np.abs(x) <= 1.0) & (np.abs(y) <= 0.8)
        assert inside.x == pytest.approx(x[meets], abs=1e-14)
        assert inside.y == pytest.approx(y[meets], abs=1e-14)
        outer = np.arccos(rays.direction[meets, 2])
        inner = np.arctan(np.hypot(inside.slope_x, inside.slope_y))
        assert 1.5 * np.sin(inner) == pytest.approx(np.sin(outer), abs=1e-12)
        azimuth = np.arctan2(rays.direction[meets, 1], rays.direction[meets, 0])
        assert np.arctan2(inside.slope_y, inside.slope_x) == pytest.approx(azimuth, abs=1e-9)
        reflectance = 0.04 + 0.96 * (1 - np.cos(outer)) ** 5
        assert inside.flux == pytest.approx(rays.flux[meets] * (1 - reflectance), rel=1e-12)
        assert lost["missed_lens"] == pytest.approx((~meets).mean(), abs=1e-12)
        assert inside.flux.sum() + sum(lost.values()) == pytest.approx(1, abs=1e-12)

    def test_rays_that_never_get_there_miss(self, lens):
        directions = np.array([[0, 0, -1.0], [1, 0, 0], [0, 0, 1.0]])
        crossing = np.array([[0, 0, 0], [np.inf, 0, 0], [0, 0, 0]])
        path = with_rays(path_of(POINT, lens), bundle(crossing, directions, np.full(3, 1 / 3)))
        assert len(path.rays.flux) == 1
        assert path.lost["missed_lens"].item() == pytest.approx(2 / 3)
