"""Table for a slow tool servo, read as text and compared with closed forms and other sweeps."""

from dataclasses import replace

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.files.export.options import Turning
from workbench.files.export.turning import write_turning

SMALL = Turning(nose_radius=0.1, feed_per_turn=0.05, points_per_turn=180)


@pytest.fixture
def table(make_design, write, few_gouges):
    """Writes a face as a table: angle (radians), radius and height, scene units, its deviation."""

    def do(height, turning=SMALL, **changes):
        net = {"lens.control_points": [40, 30], **changes}
        x, y = make_design(net).net.positions
        design = replace(make_design(net, height(x[:, None], y)), options=(turning,))
        name = f"{turning.feed_per_turn}.sts"
        path, deviation = write(write_turning, design, name)
        angle, radius, z = np.loadtxt(path).T
        return np.radians(angle), radius / 10, z / 10, deviation, design, path.read_text()

    return do


def test_a_plane_is_turned_at_one_height(table):
    angle, radius, z, deviation, *_ = table(lambda x, y: 0.5 + 0 * (x + y))
    assert z == pytest.approx(0, abs=1e-12)
    assert np.diff(angle) == pytest.approx(2 * np.pi / 180)
    assert radius[0] == pytest.approx(np.hypot(1, 0.7) + 0.1, abs=1e-9) and radius[-1] == 0
    assert np.diff(radius)[:-1] == pytest.approx(-0.05 / 180)
    assert deviation.size < 1e-9 and deviation.unit == "cm"


def test_the_nose_radius_is_compensated_on_an_inclined_plane(table):
    slope = 0.3
    angle, radius, z, _, design, _ = table(lambda x, y: 0.6 + slope * x + 0 * y)
    along = slope * np.cos(angle)
    exact = 0.6 + along * radius + 0.1 * (np.sqrt(1 + along**2) - 1)
    assert z + design.heights.max() == pytest.approx(exact, abs=2e-8)


def test_the_nose_radius_is_compensated_in_a_hollow(table):
    """A paraboloid is a B-spline whose control heights lie below it by a constant."""
    _, radius, z, _, design, _ = table(lambda x, y: 0.5 + 0.5 * (x**2 + y**2))
    middle = design.net.at(np.zeros(1), np.zeros(1), design.heights)[0].item()
    contact = np.linspace(0, 0.9, 20_001)
    length = np.sqrt(1 + contact**2)
    tool, tip = contact - 0.1 * contact / length, 0.5 * contact**2 + 0.1 / length - 0.1
    inner = radius < 0.5
    exact = middle + np.interp(radius[inner], tool, tip)
    assert z[inner] + design.heights.max() == pytest.approx(exact, abs=1e-4)


def waves(x, y):
    return 0.5 + 0.02 * np.cos(5 * x) * np.cos(4 * y)


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_the_nose_along_the_interpolated_table_leaves_the_face(table, rng, outline):
    angle, radius, z, deviation, design, _ = table(waves, **{"lens.outline": outline})
    top = design.heights.max()
    number = rng.uniform(0, len(z) - 1, 1000)
    angle, radius, tip = (np.interp(number, np.arange(len(z)), c) for c in (angle, radius, z + top))
    inside = design.outline.contains(radius * np.cos(angle), radius * np.sin(angle))
    angle, radius, tip = angle[inside], radius[inside], tip[inside]
    lowest = np.full(len(tip), np.inf)
    for part in np.linspace(-1, 1, 401):
        along = radius + 0.1 * part
        x, y = along * np.cos(angle), along * np.sin(angle)
        above = tip + 0.1 * (1 - np.sqrt(1 - part**2)) - design.net.at(x, y, design.heights)[0]
        on_face = design.outline.contains(x, y)
        lowest[on_face] = np.minimum(lowest, above)[on_face]
    assert lowest.min() > -deviation.size - 1e-7
    assert np.median(lowest) < deviation.size + 1e-6
    assert 0 < deviation.size < 2e-4


def test_by_default_points_keep_the_chord_error(table):
    *_, deviation, design, text = table(waves, Turning(feed_per_turn=0.05))
    assert 0 < deviation.size < 1.5 * design.largest_chord_error
    assert f"up to {10 * deviation.size:.3g} mm" in text
    assert "nose radius 0.5 mm, rake angle 0" in text


def test_a_nose_that_does_not_fit_and_too_many_points_are_refused(table):
    def narrow(x, y):
        return 0.5 + 0.02 * np.cos(40 * x) + 0 * y

    with pytest.raises(Refused, match=r"^nose_radius: a nose of 0.3 cm does not fit: it cuts off"):
        table(narrow, Turning(nose_radius=0.3, feed_per_turn=0.05))
    with pytest.raises(Refused, match=r"^feed_per_turn: .* more than 4,000,000; a larger one"):
        table(waves, Turning(feed_per_turn=1e-7))
    with pytest.raises(Refused, match=r"^points_per_turn: 3; from 16 to 100,000"):
        Turning(points_per_turn=3)
