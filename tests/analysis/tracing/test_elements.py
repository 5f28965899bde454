"""The elements of the check, one by one."""

import math

import numpy as np
import pytest

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.interfaces import DielectricBoundary
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.receivers import PlaneDetector
from workbench.analysis.tracing.surfaces.fixed import FlatFace
from workbench.analysis.tracing.surfaces.spline import SplineFace
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import ControlNet

UP = np.array([[0.0, 0.0, 1.0]])


def inclined(degrees):
    angle = math.radians(degrees)
    return np.array([[math.sin(angle), 0.0, math.cos(angle)]])


def at(*places):
    return np.array(places, dtype=float)


class TestFlatFace:
    face = FlatFace(2.0, Rectangle((1.0, 0.5)), "missed_lens")

    def test_rays_are_taken_to_its_plane(self):
        rays = TracedRays(at([0, 0, 0], [0.5, 0, 1]), inclined(-10), np.ones(2))
        met = self.face.meet(rays)
        assert met.position[:, 2] == pytest.approx(2)
        assert met.position[:, 0] == pytest.approx(
            [-2 * math.tan(math.radians(10)), 0.5 - 0.176327]
        )
        assert met.normal == pytest.approx(UP)
        assert met.flux == pytest.approx(np.ones(2))


class TestSplineFace:
    def test_rays_from_any_height_meet_the_same_place(self, make_scene, rng):
        scene = make_scene()
        face = SplineFace(scene.optic, 0.5 + 0.05 * rng.random((12, 10)), "left_side")
        direction = inclined(12)
        start = np.column_stack([rng.uniform(-0.5, 0.5, (50, 2)), np.zeros(50)])
        later = start + 0.3 * direction / direction[0, 2]
        first, second = (
            face.meet(TracedRays(each, direction, np.ones(50))) for each in (start, later)
        )
        assert (first.flux == 1).all()
        assert (second.flux == 1).all()
        assert second.position == pytest.approx(first.position, abs=1e-12)
        assert second.normal == pytest.approx(first.normal, abs=1e-10)


class TestDielectricBoundary:
    @pytest.mark.parametrize(("before", "behind"), [(1.0, 1.5), (1.5, 1.0)])
    def test_snell_and_schlick(self, before, behind):
        inside = math.asin(math.sin(math.radians(25)) * before / behind)
        crossings = Crossings(at([0, 0, 0]), UP, np.array([2.0]))
        rays = TracedRays(at([0, 0, 0]), inclined(25), np.array([2.0]))
        behind_it, lost = DielectricBoundary(before, behind, "fresnel_exit").turn(rays, crossings)
        assert behind_it.direction == pytest.approx(inclined(math.degrees(inside)), abs=1e-15)
        thinner = math.cos(math.radians(25) if before < behind else inside)
        reflectance = 0.04 + 0.96 * (1 - thinner) ** 5
        assert lost["total_reflection"] == 0
        assert lost["fresnel_exit"] == pytest.approx(2 * reflectance)
        assert behind_it.flux == pytest.approx([2 * (1 - reflectance)])

    @pytest.mark.parametrize(("before", "behind"), [(1.0, 1.5), (1.5, 1.0)])
    @pytest.mark.parametrize("degrees", [0.0, 25.0, 41.0])
    def test_fresnel_by_the_angles(self, before, behind, degrees):
        """In Fresnel's own form, of sines and tangents."""
        crossings = Crossings(at([0, 0, 0]), UP, np.array([2.0]))
        rays = TracedRays(at([0, 0, 0]), inclined(degrees), np.array([2.0]))
        boundary = DielectricBoundary(before, behind, "fresnel_exit", "fresnel")
        _, lost = boundary.turn(rays, crossings)
        outside = math.radians(degrees)
        inside = math.asin(math.sin(outside) * before / behind)
        both = outside - inside, outside + inside
        across, within = (
            (shape(both[0]) / shape(both[1])) ** 2 if degrees else 0.04
            for shape in (math.sin, math.tan)
        )
        assert lost["fresnel_exit"] == pytest.approx(across + within, rel=1e-12)

    def test_light_is_absorbed_by_the_length_of_its_way(self):
        start, end = at([0, 0, 0], [1, 2, 3]), at([3, 4, 0], [1, 2, 3])
        crossings = Crossings(end, UP, np.array([1.0, 2.0]))
        boundary = DielectricBoundary(1.5, 1.0, "fresnel_exit", 0.0, absorption=0.2)
        behind, lost = boundary.turn(TracedRays(start, inclined(0), np.ones(2)), crossings)
        assert behind.flux == pytest.approx([math.exp(-1), 2], rel=1e-14)
        assert lost["absorbed"] == pytest.approx([1 - math.exp(-1), 0], rel=1e-14)


def test_a_plane_counts_flux_in_its_pixels_and_beside(make_scene):
    scene = make_scene({"screen.pixels": [2, 2]})
    screens = [scene.receiver.moved_to(z) for z in (5.0, 8.0)]
    detector = PlaneDetector(screens, scene.optic.front_z, 1, Pose())
    flux, beside = np.zeros((detector.images, detector.pixels)), np.zeros(2)
    # The first is upper left on both; the second leaves the farther screen.
    rays = TracedRays(
        at([-0.5, 0.5, 0], [0.3, -0.5, 0], [0, 0, 0]),
        np.vstack([UP, at([0.1, 0, math.sqrt(0.99)]), -UP]),
        at(1.0, 2.0, 4.0),
    )
    detector.count(rays, flux, beside)
    assert flux.tolist() == [[1, 0, 0, 2], [1, 0, 0, 0]]
    assert beside.tolist() == [4, 6]


def test_a_thick_lens_keeps_the_digits_of_its_shape(make_scene):
    """Slopes of 1e-7 are found behind glass 250,000 thick, where heights have 3e-11 for a step."""
    lens = make_scene({"lens.base.height": 0.5}).optic
    net = ControlNet.of(lens)
    heights = np.repeat(250_000 + 1e-7 * net.positions[0][:, None], lens.net_shape[1], axis=1)
    at = np.linspace(-0.6, 0.6, 7)
    _, slope, across = SplineFace(lens, heights, "left_side").shape_at(at, 0.3 * at)
    widths = np.diff(net.positions[0]).min()
    assert slope == pytest.approx(1e-7, abs=2 * 3e-11 / widths)
    assert across == pytest.approx(0, abs=1e-16)
