"""Inspection of simulated parts: known placements, known residuals, and what a correction gains."""

import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from resources import path
from tests.accounts import result_of
from tests.analysis.lenses import net_of
from workbench.analysis.inspection.alignment import aligned
from workbench.analysis.inspection.inspection import Units, corrected_session, inspected
from workbench.analysis.inspection.placement import DesignedFace, Placement
from workbench.analysis.inspection.residual import residual_of
from workbench.analysis.validation import validate
from workbench.design.design_run import DesignRun
from workbench.design.session import Session
from workbench.design.task import begin
from workbench.errors import Refused
from workbench.files.export.write import export
from workbench.geometry.surface import ControlNet
from workbench.measured.surfaces import read_surface
from workbench.measured.surfaces.points import MeasuredSurface, surface_of
from workbench.scene import Scene

MICROMETRE = 1e-4  # cm
FACE = "lens.back"
UPRIGHT = pytest.mark.usefixtures("upright_parts")


def relief(x, y):
    """A face without symmetry, with fine relief."""
    fine = 0.003 * np.cos(9 * x + 2 * y) * np.sin(11 * y - x)
    return 0.5 + 0.05 * x**2 - 0.03 * x * y + 0.04 * np.sin(2 * y + x) + fine


def form(x, y):
    """Astigmatism and waviness, cm."""
    return MICROMETRE * (2 * x * y + x**2 - y**2 + 0.8 * np.cos(5 * x + 1) * np.cos(4 * y))


@pytest.fixture
def scene(make_scene):
    return make_scene({"lens.control_points": (32, 32)})


@pytest.fixture
def session(scene):
    return Session(scene, np.ones((32, 32)), result_of(net_of(scene, relief)))


@pytest.fixture
def face(session):
    return DesignedFace.of(session.scene, session.heights[FACE], FACE)


def points_of(face, error=form, noise=0.0, count=64, part=1.0, seed=3):
    """Points of a part of a face with a form error and noise, in the face's coordinates."""
    middles = part * (2 * (np.arange(count) + 0.5) / count - 1)
    x, y = (each.ravel() for each in np.meshgrid(middles, middles))
    z = face.net.at(x, y, face.heights)[0] + error(x, y)
    z += noise * np.random.default_rng(seed).standard_normal(x.shape)
    return np.column_stack([x, y, z])


def turned(points, seed=1):
    """Points in the coordinates of a measuring machine, and the placement that takes them back."""
    rotation = Rotation.random(random_state=seed).as_matrix()
    shift = np.random.default_rng(seed).uniform(-5, 5, 3)
    return (points - shift) @ rotation, Placement(rotation, shift)


def none(x, y):
    return np.zeros_like(x)


@pytest.mark.parametrize("seed", range(4))
def test_known_placement_is_recovered(face, seed):
    points, placement = turned(points_of(face, none), seed)
    found = aligned([points], face, "part").placement
    np.testing.assert_allclose(found.rotation, placement.rotation, rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.shift, placement.shift, rtol=0, atol=1e-8)


def test_standard_errors_are_those_of_noise(face):
    noise = 0.1 * MICROMETRE
    off, stated = [], []
    for seed in range(6):
        points, placement = turned(points_of(face, none, noise, 50, seed=seed))
        found = aligned([points], face, "part")
        middle = [each.applied(points).mean(axis=0) for each in (found.placement, placement)]
        off.append(middle[0] - middle[1])
        stated.append(found.shift_error)
    measured, expected = np.sqrt(np.mean(np.square(off), axis=0)), np.mean(stated, axis=0)
    assert (measured / expected < 2.5).all() and (measured / expected > 0.3).all()


def test_a_part_of_the_face_is_placed(face):
    points, placement = turned(points_of(face, none, part=0.6))
    beside = points_of(face, none, part=0.6)
    found = aligned([points], face, "part").placement
    np.testing.assert_allclose(found.applied(points), beside, rtol=0, atol=1e-8)
    np.testing.assert_allclose(found.rotation, placement.rotation, rtol=0, atol=1e-8)


def test_dust_does_not_move_a_part(face):
    points = points_of(face, none)
    points[::101, 2] += 0.01
    measured, placement = turned(points)
    found = aligned([measured], face, "part").placement
    np.testing.assert_allclose(found.shift, placement.shift, rtol=0, atol=1e-7)
    residual = residual_of(face, found, measured, "part")
    assert residual.spikes == len(points[::101])
    assert residual.rms < 1e-3 * MICROMETRE


@UPRIGHT
def test_scale_is_determined_if_asked_for(face):
    points = 1.004 * points_of(face, none)
    found = aligned([points], face, "part", with_scale=True)
    assert found.placement.scale == pytest.approx(1 / 1.004, abs=1e-9)
    assert aligned([points], face, "part").placement.scale == 1


def test_a_rotation_that_the_face_leaves_open_has_no_finite_error(scene):
    sphere = DesignedFace.of(scene, net_of(scene, lambda x, y: 0.5 + 0 * x * y), FACE)
    points = points_of(sphere, none)
    found = aligned([points], sphere, "part")
    assert np.isinf(found.shift_error[:2]).all() and np.isinf(found.turn_error[2])
    assert np.isfinite(found.shift_error[2]) and np.isfinite(found.turn_error[:2]).all()


@pytest.mark.parametrize(
    ("signs", "reason"), [([-1, 1, 1], "sign of its x"), ([1, 1, -1], "sign of its heights")]
)
def test_mirror_images_are_refused(face, signs, reason):
    with pytest.raises(Refused, match=f"^part: it is a mirror image of the face: .*{reason}"):
        aligned([points_of(face) * signs], face, "part")


def test_another_face_is_refused(face):
    def other(x, y):
        return 0.1 * np.sin(7 * x) * np.cos(8 * y)

    with pytest.raises(Refused, match=r"do not fit lens\.back"):
        aligned([points_of(face, other)], face, "part")


@UPRIGHT
def test_the_patch_that_fits_is_taken(face):
    flat = points_of(face, none) * [1, 1, 0]
    found = aligned([flat, points_of(face, none)], face, "part")
    assert np.abs(found.patch[:, 2]).max() > 0


def surface(points, unit=None):
    return "part", surface_of(points, unit)


def inspect(session, *points, unit=Units(), **settings):  # noqa: B008
    return inspected(session, [surface(each) for each in points], unit=unit, **settings)


def bump(x, y):
    return 2 * MICROMETRE * np.exp(-((x - 0.2) ** 2 + (y + 0.1) ** 2) / 0.2**2)


def test_residual_of_a_known_bump(session, face):
    measured, _ = turned(points_of(face, bump, noise=0.02 * MICROMETRE, count=100))
    (part,) = inspect(session, measured).parts
    x, y = np.linspace(-0.9, 0.9, 41)[:, None], np.linspace(-0.9, 0.9, 41)
    z = face.net.at(*np.broadcast_arrays(x, y), part.residual.on_design)[0]
    # Apart from the mean plane, which is a matter of the placement.
    plane = np.column_stack([np.ones(z.size), *(a.ravel() for a in np.broadcast_arrays(x, y))])
    left = (z - bump(x, y)).ravel()
    left -= plane @ np.linalg.lstsq(plane, left, rcond=None)[0]
    assert np.abs(left).max() < 0.05 * MICROMETRE
    assert part.residual.noise == pytest.approx(0.02 * MICROMETRE, rel=0.1)


def test_long_form_errors_are_not_taken_for_a_shift(session):
    heights = net_of(session.scene, lambda x, y: relief(x, y) + 1e-3 * np.cos(40 * x + 37 * y))
    session.result = result_of(heights)
    face = DesignedFace.of(session.scene, heights, FACE)
    measured, placement = turned(points_of(face, form, noise=0.02 * MICROMETRE))
    (part,) = inspect(session, measured).parts
    plain = aligned([measured], face, "part").placement
    expected = placement.applied(measured).mean(axis=0)[:2]
    off, off_plain = (
        float(np.linalg.norm(each.applied(measured).mean(axis=0)[:2] - expected))
        for each in (part.alignment.placement, plain)
    )
    assert off < 0.2 * MICROMETRE < 0.2 * off_plain


@UPRIGHT
def test_slope_of_a_known_residual(session, face):
    def ripple(x, y):
        return MICROMETRE * np.sin(10 * x) + 0 * y

    (part,) = inspect(session, points_of(face, ripple)).parts
    # The slope of a sine of amplitude a and wave number k is a k / √2 rms.
    slopes = 10 * MICROMETRE * np.sqrt(np.mean(np.cos(10 * np.linspace(-1, 1, 1001)) ** 2))
    assert part.residual.slope_rms == pytest.approx(slopes, rel=0.05)
    assert part.residual.rms == pytest.approx(MICROMETRE / np.sqrt(2), rel=0.1)


@UPRIGHT
@pytest.mark.parametrize(("factor", "unit"), [(10, "mm"), (1e4, "um"), (0.01, "m")])
def test_sizes_in_another_unit_are_refused_with_the_unit(session, face, factor, unit):
    points = factor * points_of(face)
    with pytest.raises(Refused, match=f"the unit {unit} fits"):
        inspect(session, points)
    found = inspect(session, points, unit=Units(unit))
    assert found.parts[0].residual.rms < 3 * MICROMETRE


@UPRIGHT
def test_heights_in_another_unit_are_refused_with_the_unit(session, face):
    points = points_of(face) * [1, 1, 1e4]
    with pytest.raises(Refused, match="heights in um fit"):
        inspect(session, points)
    found = inspect(session, points, unit=Units("cm", "um"))
    assert found.parts[0].residual.rms < 3 * MICROMETRE


@UPRIGHT
def test_unit_of_the_file_counts(session, face):
    points = 10 * points_of(face)
    found = inspected(session, [surface(points, "mm")])
    assert found.parts[0].residual.rms < 3 * MICROMETRE


@UPRIGHT
def test_too_little_of_the_face_is_refused(session, face):
    points = points_of(face)
    with pytest.raises(Refused, match=r"covers \d+ % of lens.back; at least 50 %"):
        inspect(session, points[np.hypot(points[:, 0], points[:, 1]) > 0.85])


def test_unknown_face_is_refused(session, face):
    with pytest.raises(Refused, match=r"^face: 'lens.front' is no freeform face; lens.back"):
        inspect(session, points_of(face), face="lens.front")


def error_of(session, heights):
    found = validate(session.scene, session.target, {FACE: heights}, 400_000, accuracy=1e-3)
    return found.verified.relative_l2_corrected


@pytest.fixture(scope="module")
def designed():
    """A lens designed for a letter."""
    data = json.loads(path("examples", "letter.json").read_text())
    data["images"][0]["receiver"]["pixels"] = [96, 96]
    data["elements"][0]["faces"][1]["control_points"] = [160, 160]
    session = begin(Scene.from_data(data), path("examples"))
    run = DesignRun(session, iterations=8)
    for _ in run:
        pass
    return run.session


def warped(x, y):
    return 3 * form(x, y)


@pytest.mark.full
def test_a_corrected_second_part_is_as_good_as_the_design(designed):
    heights = designed.heights[FACE]
    face = DesignedFace.of(designed.scene, heights, FACE)
    net = ControlNet.of(designed.scene.optic)
    x, y = np.meshgrid(*net.positions, indexing="ij")
    repeating = warped(x, y)
    parts = [
        turned(points_of(face, warped, noise=0.1 * MICROMETRE, count=400, seed=k), k)[0]
        for k in (1, 2)
    ]
    found = inspect(designed, *parts)
    ideal, first, second = (
        error_of(designed, each)
        for each in (heights, heights + repeating, found.corrected()[FACE] + repeating)
    )
    assert first > 1.5 * ideal
    assert second <= 1.2 * ideal
    measured = error_of(designed, found.as_measured(found.parts[0])[FACE])
    assert measured == pytest.approx(first, rel=0.03)
    assert found.spread < 0.05 * MICROMETRE


@UPRIGHT
def test_corrected_session(session, face):
    found = inspect(session, points_of(face))
    heights = found.corrected()
    light = validate(session.scene, session.target, heights, 100_000, accuracy=1e-2)
    corrected = corrected_session(session, heights, light)
    assert corrected.result.state.heights == heights
    assert corrected.result.state.account == (light.by_cells or light).account
    np.testing.assert_allclose(
        heights[FACE], session.heights[FACE] - found.parts[0].residual.on_design
    )
    again = found.corrected(heights)
    np.testing.assert_allclose(again[FACE], heights[FACE] - found.repeating)


@UPRIGHT
@pytest.mark.parametrize(
    ("name", "tolerance"),
    [("a.height.png", 3e-6), ("a.height.csv", 1e-9), ("a.xyz", 1e-9), ("a.stl", 1e-6)],
)
def test_exports_are_read_as_measurements(session, tmp_path, monkeypatch, name, tolerance):
    monkeypatch.setattr("workbench.files.export.design._STEPS", 80)
    path = tmp_path / name
    assert list(export(session, [path]))
    with path.open("rb") as file:
        (part,) = inspected(session, [(name, read_surface(path, file))]).parts
    assert part.residual.rms < tolerance
    assert part.residual.covered == 1


@UPRIGHT
def test_a_mesh_of_several_patches(session, face):
    patches = (points_of(face) * [1, 1, 0], points_of(face))
    found = inspected(session, [("part", MeasuredSurface(patches))])
    assert found.parts[0].residual.rms < 3 * MICROMETRE
