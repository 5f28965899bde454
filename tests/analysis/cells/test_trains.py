"""The deterministic check of trains of several elements, against closed forms and random rays."""

import math

import numpy as np
import pytest

from resources import path
from tests.analysis.tracing.test_trains import (
    COLLIMATED,
    PLANE,
    R_0,
    N,
    designed,
    flat,
    lens,
    plate,
    scene_of,
)
from workbench.analysis.cells.image import imaging
from workbench.analysis.validation import validate
from workbench.files.session import open_design
from workbench.geometry.surface import freeform_nets
from workbench.progress import finished
from workbench.scene import Scene

CLEAR = {"reflection": "none"}


def rectangle(receiver, x, y):
    """Part of each pixel (n_y, n_x) of a plane that is within intervals of x and y."""
    parts = []
    for r, n, (low, high) in zip(receiver.half_width, receiver.pixels, (x, y), strict=True):
        edges = np.linspace(-r, r, n + 1)
        covered = np.minimum(edges[1:], high) - np.maximum(edges[:-1], low)
        parts.append(covered.clip(min=0) / np.diff(edges))
    return np.outer(parts[1][::-1], parts[0])


def image_of(scene, **named):
    found = finished(imaging(scene, flat(scene), **named))
    return found.irradiance, found.bound


def test_a_tilted_plate_shifts_the_image_aside():
    thickness, angle = 1.0, math.radians(20.0)
    cover = plate("cover", 5.0, half_width=3.0, thickness=thickness, tilt=[0.0, 20.0, 0.0], **CLEAR)
    scene = scene_of(COLLIMATED, [designed(**CLEAR), cover], half_width=2.0, pixels=32)
    inside = math.asin(math.sin(angle) / N)
    aside = thickness * math.sin(angle - inside) / math.cos(inside)
    exact = rectangle(scene.receiver, (aside - 1, aside + 1), (-1, 1)) / 4
    assert image_of(scene)[0] == pytest.approx(exact, abs=1e-9)


def test_an_afocal_pair_turns_the_image_over():
    """Two hyperbolas with one focus: light leaves as it came, on the other side of the axis."""
    focal, y, x = 6.0, 0.2, 0.3
    first, second = (
        {"shape": "conic", "radius": sign * focal * (N - 1), "conic": -(N**2)} for sign in (-1, 1)
    )
    elements = [
        lens("stop", (x, y, -3.0), 0.5, [PLANE, PLANE], **CLEAR),
        lens("first", (0.0, 0.0, 0.0), 1.5, [PLANE, first], thickness=1.0, **CLEAR),
        lens("second", (0.0, 0.0, 1.0 + 2 * focal), 1.5, [second, PLANE], thickness=1.0, **CLEAR),
        designed(z=16.0, half_width=2.0, **CLEAR),
    ]
    scene = scene_of(COLLIMATED, elements, z=20.0, half_width=1.0, pixels=16)
    exact = rectangle(scene.receiver, (-x - 0.5, -x + 0.5), (-y - 0.5, -y + 0.5))
    assert image_of(scene)[0] == pytest.approx(exact, abs=1e-9)


def test_a_fold_mirror_sends_its_light_aside():
    mirror = {"kind": "mirror", "name": "fold", "half_width": [1.0, 2.0], "tilt": [45.0, 0.0, 0.0]}
    mirror |= {"face": PLANE, "reflectance": 0.8}
    upright = designed(half_width=3.0, **CLEAR) | {"position": [0, 4, 0], "tilt": [-90, 0, 0]}
    data = scene_of(COLLIMATED, [designed()]).to_data() | {"elements": [mirror, upright]}
    data["images"][0]["receiver"] |= {"position": [0, 9, 0], "tilt": [-90, 0, 0]}
    scene = Scene.from_data(data)
    irradiance, _ = image_of(scene)
    # Of the mirror 2 by 4 / √2 is seen; a source of flux 1 lights the square around it.
    height = 2 * math.cos(math.radians(45))
    lit = rectangle(scene.receiver, (-1, 1), (-height, height))
    assert irradiance / irradiance.max() == pytest.approx(lit / lit.max(), abs=1e-9)
    assert scene.receiver.total(irradiance) == pytest.approx(0.8, rel=1e-9)


def test_light_beside_a_later_element_is_lost():
    cover = plate("cover", 3.0, half_width=0.5, aside=(0.53, 0.07))
    scene = scene_of(COLLIMATED, [designed(), cover], half_width=1.0, pixels=16)
    found = finished(imaging(scene, flat(scene), accuracy=1e-2))
    irradiance, bound = found.irradiance, found.bound
    lit = rectangle(scene.receiver, (0.03, 1.0), (-0.43, 0.57))
    exact = lit * (1 - R_0) ** 4 / 4
    off = np.linalg.norm(irradiance - exact) / np.linalg.norm(exact)
    assert off < bound <= 1e-2
    part = 0.97 / 4
    behind = part * (1 - R_0) ** 2
    expected = {"missed_lens@cover": (1 - part) * (1 - R_0) ** 2, "fresnel_entrance@designed": R_0}
    expected |= {"fresnel_exit@designed": R_0 * (1 - R_0), "fresnel_entrance@cover": R_0 * behind}
    for key, lost in expected.items():
        assert found.lost[key] == pytest.approx(lost, rel=1e-3)
    assert sum(found.lost.values()) + scene.receiver.total(irradiance) == pytest.approx(1)


def bent(scene, part):
    """Heights of each designed face with a smooth bump, as parts of the half-width."""
    heights = {}
    for optic in scene.optics:
        for face, net in freeform_nets(optic).items():
            x, y = (p / r for p, r in zip(net.positions, net.half_width, strict=True))
            bump = 0.6 * x[:, None] ** 2 + 0.5 * y**2 + 0.1 * np.sin(3 * x[:, None] + y)
            level = optic.base.height if face == optic.designed_face else optic.front_z
            heights[face] = level + part * net.half_width[0] * bump
    return heights


@pytest.mark.parametrize(
    ("name", "part", "accuracy"),
    [
        ("tilted-lens", -0.05, 0.02),
        ("mirror-and-lens", 0.02, 0.05),
        ("fold-mirror", -0.02, 0.1),
        ("led-collimator", -0.03, 0.3),
        ("dome-cover", 0.05, 0.3),
    ],
)
def test_cells_and_random_rays_agree_on_trains_of_the_gallery(monkeypatch, name, part, accuracy):
    monkeypatch.setattr("workbench.analysis.cells.image._BEGIN", 1 << 19)  # made sooner
    task = open_design(path("examples", f"{name}.json"))
    heights = bent(task.scene, part)
    found = validate(task.scene, task.target, heights, rays=100_000, accuracy=accuracy)
    cells = found.by_cells
    assert found.left_out is None
    assert cells.bound <= accuracy
    assert found.contradiction is None
    assert cells.difference_over_noise == pytest.approx(1, abs=0.15)
    off = 5 * found.share.noise + cells.agreement.bound + 1e-3
    assert cells.efficiency == pytest.approx(found.efficiency, abs=off)
    low, high = cells.relative_l2_corrected_interval
    other_low, other_high = found.relative_l2_corrected_interval
    assert low < other_high
    assert other_low < high
    for account in (found.account, cells.account):
        assert sum(account.lost.values()) + account.on_screen == pytest.approx(1, abs=1e-12)
    assert cells.account.lost == pytest.approx(found.account.lost, abs=off + 2e-3)
