"""What balls leave, compared with every ball one by one."""

import numpy as np
import pytest

from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.ball_sweep import BallSweep
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import ControlNet
from workbench.watch import finished

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


@pytest.mark.parametrize("scallop", [0.002, 0.0002])
@pytest.mark.parametrize("radius", [0.05, 0.4, 3.0])
@pytest.mark.parametrize("name", FACES)
def test_the_cut_is_that_of_the_lowest_of_all_balls(name, radius, scallop, rng):
    """Balls of 3 are much larger than the hollows of waves."""
    raster = finished(face_of(FACES[name]).plan_raster(radius, max(scallop, 0.01 * radius), 10**6))
    x, y = places(rng, 30)
    found, expected = raster.cut_at(x, y), each_ball(raster, x, y)
    assert (found <= expected + 1e-12).all()
    assert found == pytest.approx(expected, abs=1e-5)


@pytest.mark.parametrize("radius", [0.05, 0.4, 3.0])
@pytest.mark.parametrize("name", FACES)
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


def test_a_single_ball(rng):
    """Centres far above the other ones leave nothing that counts."""
    centre = np.full((7, 5), 9.0)
    centre[3, 2] = 1.0
    sweep = BallSweep(np.arange(7.0), np.arange(5.0), centre, 0.5)
    offset = rng.uniform(-0.3, 0.3, (2, 50))
    height, normal = sweep.lowest(3 + 0 * offset[0], 2 + offset[1])
    assert height == pytest.approx(1 - np.sqrt(0.25 - offset[1] ** 2), abs=0.07)
    assert np.linalg.norm(normal, axis=1) == pytest.approx(1)
    assert (height <= 1 - np.sqrt(0.25 - offset[1] ** 2) + 1e-12).all()


def test_rounded_places_do_not_drift(rng):
    """Steps of 0.0034 are rounded to 0.003 and 0.004: the mean counts, up to the last one."""
    x, y = np.round(np.arange(500) * 0.0034, 3), np.arange(4) * 0.01
    centre = 1 + 0.2 * x[:, None] + 0 * y
    height, _ = BallSweep(x, y, centre, 0.5).lowest(x[400:450], np.full(50, 0.01))
    assert height == pytest.approx(1 + 0.2 * x[400:450] - 0.5 * np.sqrt(1.04), abs=3e-4)


def test_nothing_is_cut_where_no_ball_is_above():
    sweep = BallSweep(np.arange(3.0), np.arange(2.0), np.zeros((3, 2)), 0.4)
    height, normal = sweep.lowest(np.array([0.5, 0.5, 5.0]), np.array([0.0, 0.5, 0.0]))
    assert height == pytest.approx([-0.4, np.inf, np.inf])
    assert normal == pytest.approx(np.array([[0, 0, 1], [0, 0, 0], [0, 0, 0]]))
