"""What balls leave, compared with every ball one by one."""

import numpy as np
import pytest

from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import ControlNet
from workbench.progress import finished

NET = ControlNet((24, 20), (3, 3), (1.0, 0.8))  # in cm: 1e-4 is a micrometre
FACES = {
    "bowl": lambda x, y: 0.3 * (x**2 + y**2),
    "dome": lambda x, y: -0.3 * (x**2 + y**2),
    "waves": lambda x, y: 0.02 * np.cos(5 * x) * np.cos(4 * y),
    "steep waves": lambda x, y: 0.15 * np.cos(9 * x) * np.cos(7 * y),
    "step": lambda x, y: 0.2 * np.tanh(8 * (x + 0.4 * y)),
    "wedge": lambda x, y: 1.2 * x - 0.7 * y,
}


def face_of(height):
    x, y = NET.positions
    return CutFace(NET, height(x[:, None], y), Rectangle(NET.half_width))


def each_ball(raster, x, y, between=100):
    """Lowest side of all balls of a raster, and of more along its moves, place by place."""
    along = np.linspace(raster.x[0], raster.x[-1], between * (len(raster.x) - 1) + 1)
    tip = np.stack([np.interp(along, raster.x, line) for line in raster.tip.T])
    lowest = np.full(len(x), np.inf)
    for k, (x_k, y_k) in enumerate(zip(x, y, strict=True)):
        column = np.flatnonzero(np.abs(along - x_k) < raster.radius)
        under = raster.radius**2 - (along[column] - x_k) ** 2 - (raster.y[:, None] - y_k) ** 2
        side = tip[:, column] + raster.radius - np.sqrt(under.clip(0))
        lowest[k] = side[under > 0].min()
    return lowest


def places(rng, count):
    """Random places of the face, and its corners and sides."""
    x, y = rng.uniform(-1, 1, (2, count))
    x[:8], y[4:12] = np.sign(x[:8]), np.sign(y[4:12])
    return x, 0.8 * y


@pytest.mark.parametrize(
    ("name", "radius", "scallop"),
    [
        ("bowl", 0.05, 0.0005),
        ("bowl", 3.0, 0.03),
        ("dome", 0.4, 0.004),
        ("waves", 3.0, 0.03),
        ("steep waves", 0.05, 0.002),
        ("steep waves", 3.0, 0.03),
        ("step", 0.05, 0.0005),
        ("step", 0.4, 0.004),
        ("wedge", 0.05, 0.002),
    ],
)
def test_the_cut_is_that_of_the_lowest_of_all_balls(name, radius, scallop, rng):
    """Balls of 3 are much larger than the hollows of waves."""
    raster = finished(face_of(FACES[name]).plan_raster(radius, scallop, 10**6))
    x, y = places(rng, 30)
    found, expected = raster.cut_at(x, y), each_ball(raster, x, y)
    assert (found <= expected + 1e-12).all()
    assert found == pytest.approx(expected, abs=1e-5)


@pytest.mark.parametrize(
    ("name", "radius"),
    [
        ("bowl", 3.0),
        ("dome", 0.05),
        ("waves", 0.4),
        ("steep waves", 0.05),
        ("steep waves", 3.0),
        ("step", 0.05),
        ("step", 3.0),
        ("wedge", 0.4),
    ],
)
def test_no_ball_cuts_into_the_face(name, radius, rng):
    face = face_of(FACES[name])
    raster = finished(face.plan_raster(radius, 0.1 * radius, 10**6))
    t = np.linspace(-1, 1, 401)
    x, y = np.meshgrid(t, 0.8 * t, indexing="ij")
    z = face.net.at(x, y, face.heights)[0]
    for i, j in rng.integers(0, raster.tip.shape, (20, 2)):
        under = radius**2 - (x - raster.x[i]) ** 2 - (y - raster.y[j]) ** 2
        held_up = np.where(under > 0, z + np.sqrt(under.clip(0)), -np.inf).max() - radius
        assert raster.tip[i, j] > held_up - 1e-9
