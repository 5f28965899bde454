"""An achromat of two fixed lenses before a plate that the design leaves flat."""

import numpy as np
import pytest
import torch
from scipy.optimize import brentq

from workbench.geometry.surface import ControlNet
from workbench.materials import CATALOGUE
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle
from workbench.scene import Scene

FRAUNHOFER_F, FRAUNHOFER_C = 0.4861, 0.6563
CROWN, FLINT, THICK = "PMMA", "PC", (0.3, 0.15)
RADIUS = 10.0  # of both faces of the converging lens
HEIGHT = 1e-4  # paraxial


def refracted(curvature, before, behind):
    return np.array([[1.0, 0.0], [-(behind - before) * curvature, 1.0]])


def moved(thickness, index):
    return np.array([[1.0, thickness / index], [0.0, 1.0]])


def power(flint_curvature, um):
    """Power of both lenses by their system matrix (Hecht, Optics, section 6.2)."""
    n, m = CATALOGUE[CROWN].index(um), CATALOGUE[FLINT].index(um)
    crown = refracted(-1 / RADIUS, n, 1) @ moved(THICK[0], n) @ refracted(1 / RADIUS, 1, n)
    flint = refracted(0.0, m, 1) @ moved(THICK[1], m) @ refracted(flint_curvature, 1, m)
    return -(flint @ moved(0.2, 1.0) @ crown)[1, 0]


def focal_shift(curvature):
    return power(curvature, FRAUNHOFER_F) - power(curvature, FRAUNHOFER_C)


def train(um, flint_curvature):
    flint = {"shape": "plane"}
    if flint_curvature:
        flint = {"shape": "conic", "radius": 1 / flint_curvature}
    curved = [{"shape": "conic", "radius": RADIUS}, {"shape": "conic", "radius": -RADIUS}]
    lens = {"kind": "lens", "half_width": [1, 1]}
    flat = [{"shape": "plane"}, {"shape": "bspline", "control_points": [4, 4]}]
    own = [
        {"name": "crown", "material": CROWN, "thickness": THICK[0], "faces": curved},
        {
            "name": "flint",
            "material": FLINT,
            "thickness": THICK[1],
            "faces": [flint, {"shape": "plane"}],
            "position": [0, 0, THICK[0] + 0.2],
        },
        {
            "name": "plate",
            "material": {"index": 1.5},
            "thickness": 0.5,
            "faces": flat,
            "position": [0, 0, 2],
        },
    ]
    receiver = {"kind": "plane", "position": [0, 0, 8], "half_width": [1, 1], "pixels": [4, 4]}
    return Scene.from_data(
        {
            "version": 3,
            "source": {"kind": "collimated", "wavelength_um": um},
            "elements": [lens | each for each in own],
            "images": [{"receiver": receiver, "target": {"builtin": "tophat"}}],
        }
    )


def traced_power(um, flint_curvature):
    """Slope behind all lenses of a paraxial ray parallel to the axis, over its height."""
    scene = train(um, flint_curvature)
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    one = torch.ones(1, dtype=torch.float64)
    ray = RayBundle((HEIGHT * one, 0 * one, -one), (0 * one, 0 * one, one), one, one > 0)
    heights = {"plate.back": torch.full((4, 4), 2.5, dtype=torch.float64)}
    d_x, _, d_z = path.follow(ray, heights)[1].rays.direction
    return -float(d_x / d_z) / HEIGHT


def test_two_lines_have_one_focus_behind_an_achromat_and_two_behind_a_singlet():
    curvature = brentq(focal_shift, -0.5, -0.001)
    powers = [traced_power(um, curvature) for um in (FRAUNHOFER_F, FRAUNHOFER_C)]
    assert powers == pytest.approx([power(curvature, FRAUNHOFER_F)] * 2, rel=1e-7)
    blue, red = (traced_power(um, 0.0) for um in (FRAUNHOFER_F, FRAUNHOFER_C))
    assert (blue, red) == pytest.approx((power(0.0, FRAUNHOFER_F), power(0.0, FRAUNHOFER_C)))
    assert blue / red > 1.01
