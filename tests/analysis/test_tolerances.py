import math

import numpy as np
import pytest

from tests.lamps import crooked_lamp, led
from workbench.analysis.tolerance_fields import Tolerances
from workbench.analysis.tolerances import (
    Distribution,
    ElementError,
    Perturbation,
    Perturbed,
    draw,
    perturbed,
)
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.validation import validate
from workbench.errors import Refused
from workbench.geometry.surface import ControlNet
from workbench.scene import Scene

INDEX = 1.5
RAYS = 16 * 64 * 64


@pytest.fixture
def wide(make_scene):
    """A screen wider than a shifted image."""
    return make_scene({"screen.half_width": [2.0, 2.0], "screen.pixels": [64, 64]})


def prism(scene, slope_x, slope_y):
    x, y = ControlNet.of(scene.optic).positions
    return 0.5 + slope_x * np.asarray(x)[:, None] + slope_y * np.asarray(y)[None, :]


def middle(scene, heights, perturbation):
    """Centre of the light of a lens that is off, x and y."""
    off, moved = perturbation.applied(scene, {"lens.back": heights})
    image = validate(off, np.ones((64, 64)), moved, RAYS, pose=perturbation.pose).irradiance
    place = (np.arange(64) + 0.5) / 16 - 2
    return np.array([(image * place).sum(), (image * -place[:, None]).sum()]) / image.sum()


class TestDecentre:
    def test_decentring_the_lens_is_moving_the_point_back(self, make_scene, rng):
        heights = 0.5 + 0.05 * rng.random((12, 10))
        target, shift = np.ones((32, 32)), (2 / 16, -3 / 16)
        source = {"kind": "point", "position": [0.3, 0.1, -2.0]}
        moved = {"kind": "point", "position": [0.3 - shift[0], 0.1 - shift[1], -2.0]}
        images = [
            validate(
                make_scene({"source": each}), target, {"lens.back": heights}, RAYS, pose=pose
            ).irradiance
            for each, pose in ((source, Pose(decentre=shift)), (moved, Pose()))
        ]
        expected = np.roll(images[1], (3, 2), axis=(0, 1))[3:, 2:]  # pixels of 1/16
        assert np.abs(images[0][3:, 2:] - expected).sum() < 1e-3 * expected.sum()


class TestTilt:
    @pytest.mark.parametrize("degrees", [-8.0, 3.0, 10.0])
    @pytest.mark.parametrize("axis", [0, 1])
    def test_a_plate_moves_light_aside(self, wide, degrees, axis):
        angle = math.radians(degrees)
        tilt = (angle, 0.0) if axis == 0 else (0.0, angle)
        flat = np.full((12, 10), 0.5)
        found = middle(wide, flat, Perturbation(Pose(tilt=tilt)))
        # Parallel displacement of a ray through a plate of thickness 1/2. The rays through the
        # whole entrance face that leave at the side are missing: at one edge only.
        inside = math.asin(math.sin(angle) / INDEX)
        aside = 0.5 * math.sin(angle - inside) / math.cos(inside)
        lost = 0.5 * abs(math.tan(inside))  # width of the strip of lost light
        centre = (aside, 0.0) if axis == 1 else (0.0, -aside)
        strip = math.copysign(lost / 2 * math.cos(angle), angle)
        edge = (strip, 0.0) if axis == 1 else (0.0, -strip)
        assert found == pytest.approx(np.add(centre, edge), abs=1e-3)

    def test_flux_through_a_tilted_plate(self, make_scene):
        scene = make_scene({"screen.half_width": [2.0, 2.0]})
        angle = math.radians(30)
        account = validate(
            scene,
            np.ones((32, 32)),
            {"lens.back": np.full((12, 10), 0.5)},
            RAYS,
            pose=Pose(tilt=(angle, 0.0)),
        ).account
        reflectance = 0.04 + 0.96 * (1 - math.cos(angle)) ** 5
        assert account.lost["fresnel_entrance"] == pytest.approx(reflectance, rel=1e-9)
        side = 0.25 * math.tan(math.asin(0.5 / INDEX))  # strip over the width of 2
        assert account.lost["left_side"] == pytest.approx((1 - reflectance) * side, rel=0.01)
        assert account.lost["fresnel_exit"] == pytest.approx(
            reflectance * (1 - reflectance) * (1 - side), rel=0.01
        )

    def test_the_scene_is_rotated_inversely_in_lens_coordinates(self):
        angle = 0.1
        pose = Pose(tilt=(0.0, angle))
        assert pose.to_lens(np.array([[0.0, 0.0, -2.0]]), 0.0)[0] == pytest.approx(
            [2 * math.sin(angle), 0.0, -2 * math.cos(angle)]
        )
        turn, shift = pose.to_scene(0.25)
        there = np.array([0.3, -0.2, 0.7])
        back = pose.to_lens((turn @ there + shift)[None, :], 0.25)[0]
        assert back == pytest.approx(there, abs=1e-15)


@pytest.mark.parametrize("error", [-0.05, 0.02])
def test_index_error_of_a_prism(wide, error):
    found = middle(wide, prism(wide, 0.2, 0.0), Perturbation(index=error))
    angle = math.atan(0.2)
    away = math.asin((INDEX + error) * math.sin(angle)) - angle
    # Towards the thick side, from a mean height of 1/2.
    assert found == pytest.approx([4.5 * math.tan(away), 0.0], abs=2e-3)


class TestDraw:
    ALL = Tolerances(tilt=0.01, decentre=0.2, index=0.001, distance=0.3, surface=(1e-4, 0.2))

    def test_within_the_tolerances_and_up_to_them(self):
        found = list(draw(self.ALL, 2000, 1))
        tilt, shift = (
            [math.hypot(*getattr(each.pose, name)) for each in found]
            for name in ("tilt", "decentre")
        )
        for sizes, most in ((tilt, 0.01), (shift, 0.2)):
            assert 0.99 * most < max(sizes) <= most
            # Evenly in the disc: half of them within 1/√2 of the radius.
            assert np.median(sizes) == pytest.approx(most / math.sqrt(2), rel=0.05)
        for name, most in (("index", 0.001), ("distance", 0.3)):
            values = [getattr(each, name) for each in found]
            assert -most <= min(values) < -0.99 * most
            assert 0.99 * most < max(values) <= most
            assert abs(np.mean(values)) < 0.05 * most


class TestPerturbed:
    def test_the_nominal_lens_comes_first_and_larger_shifts_err_more(self, wide, rng):
        heights = 0.5 + 0.02 * rng.random((12, 10))
        target = validate(wide, np.ones((64, 64)), {"lens.back": heights}, RAYS).irradiance
        within = Tolerances(decentre=0.2, surface=(1e-3, 0.5))
        nominal, *others = perturbed(wide, target, {"lens.back": heights}, within, 6, 20_000)
        assert len(others) == 6
        assert nominal.perturbation == Perturbation()
        assert nominal.relative_l2 < 0.1 < min(each.relative_l2 for each in others)
        again = list(perturbed(wide, target, {"lens.back": heights}, within, 6, 20_000))
        assert again == [nominal, *others]
        # What moves the lens further makes more of an error.
        moved = [math.hypot(*each.perturbation.pose.decentre) for each in others]
        assert np.corrcoef(moved, [each.relative_l2 for each in others])[0, 1] > 0.8

    def test_distribution_by_hand(self):
        nominal, *others = (
            Perturbed(Perturbation(), error, 0.9) for error in (0.1, 0.5, 0.3, 0.2, 0.4, 0.6)
        )
        found = Distribution.of(nominal, others)
        assert (found.nominal, found.worst) == (0.1, 0.6)
        assert found.mean == pytest.approx(0.4)
        assert found.percentiles == pytest.approx({"5": 0.22, "50": 0.4, "95": 0.58})


SOURCES = {
    "tilted light": {"kind": "collimated", "direction": [3.0, 1.0], "angular_diameter": 2.0},
    "beam": {"kind": "collimated", "profile": {"kind": "gaussian", "radius": 0.5}},
    "point": {"kind": "point", "position": [0.3, 0.1, -3.0]},
    "grid": {
        "kind": "grid",
        "center": [0.1, 0.0, -3.0],
        "half_width": [0.2, 0.1],
        "points": [2, 3],
    },
    "emitter": {"kind": "area", "center": [0.1, 0.2, -3.0], "half_width": [0.3, 0.2]},
    "lamp": "photometric",
    "rays": "ray_file",
}


def source_of(name, folder):
    data = SOURCES[name]
    if isinstance(data, dict):
        return data
    return crooked_lamp(folder) if data == "photometric" else led(folder, 20_000)


class TestSource:
    """A source that is out of its place is a lens and a screen that are, the other way."""

    @pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
    @pytest.mark.parametrize("name", SOURCES)
    def test_shifting_the_source_is_decentring_the_lens_the_other_way(
        self, make_scene, rng, tmp_path, name, outline
    ):
        shift = (2 / 16, -3 / 16)
        scene = make_scene({"source": source_of(name, tmp_path), "lens.outline": outline})
        heights = {"lens.back": 0.5 + 0.05 * rng.random((12, 10))}
        target = np.ones((32, 32))
        moved = Pose(source_shift=(*shift, 0.0))
        other = Pose(decentre=(-shift[0], -shift[1]))
        here, there = (
            validate(scene, target, heights, RAYS, pose=pose).irradiance for pose in (moved, other)
        )
        expected = np.roll(there, (3, 2), axis=(0, 1))[3:, 2:]  # pixels of 1/16
        assert np.abs(here[3:, 2:] - expected).sum() < 1e-3 * expected.sum()

    @pytest.mark.parametrize("name", ["emitter", "lamp", "rays", "grid"])
    def test_turning_the_source_turns_what_it_emits(self, make_scene, tmp_path, name):
        """In a far field a lens that turns with its source sends all light that much aside."""
        angle = math.radians(2.0)
        field = {"half_angle": [16.0, 16.0], "pixels": [32, 32]}
        scene = make_scene(
            {"source": source_of(name, tmp_path), "screen": None, "far_field": field}
        )
        place = scene.source.place
        # About its own middle; the lens about its own, which moves it beside.
        aside = np.array(place)
        swung = Pose(tilt=(0.0, angle)).to_scene(0.0)[0] @ aside - aside
        together = Pose(
            tilt=(0.0, angle), source_tilt=(0.0, angle), source_shift=tuple(map(float, swung))
        )
        heights = {"lens.back": np.full((12, 10), 0.5)}
        here, there = (
            validate(scene, np.ones((32, 32)), heights, RAYS, pose=pose).irradiance
            for pose in (Pose(), together)
        )
        # Two pixels to the right; those of a far field are not quite the same in each row.
        moved = np.roll(here, 2, axis=1)[14:18, 4:28]
        assert np.abs(there[14:18, 4:28] - moved).sum() < 0.05 * moved.sum()

    def test_tolerance_without_meaning_for_the_source_is_refused(self, make_scene):
        point = make_scene({"source": {"kind": "point", "position": [0, 0, -2.0]}})
        for scene, tolerances, words in (
            (make_scene(), Tolerances(source_shift=0.1), "source_shift: 0.1 changes nothing"),
            (point, Tolerances(source_tilt=0.1), "source_tilt: 5.72958 degrees change nothing"),
            (point, Tolerances(source_shift=2.0), "source_shift: 2; at least 0, less than 2"),
            (point, Tolerances(source_shift=-1.0), "source_shift: -1; a finite number from 0"),
            (make_scene(), Tolerances(source_tilt=1.0), "source_tilt: 57.2958 degrees; at least"),
        ):
            with pytest.raises(Refused) as refused:
                tolerances.check(scene)
            assert str(refused.value).startswith(words)


@pytest.mark.parametrize(
    "tolerances, message",
    [
        (Tolerances(tilt=-0.1), "tilt: -5.72958 degrees; at least 0"),
        (Tolerances(decentre=math.nan), "decentre: nan"),
        (Tolerances(index=0.5), "index: 0.5; at least 0, less than 0.5"),
        (Tolerances(distance=4.5), "distance: 4.5; at least 0, less than 4.2"),
        (Tolerances(surface=(-1.0, 1.0)), "surface[0]: -1"),
        (Tolerances(surface=(1e-3, 0.001)), "surface[1]: 0.001; from 0.008 to 2"),
    ],
)
def test_refusals(make_scene, tolerances, message):
    with pytest.raises(Refused) as refused:
        tolerances.check(make_scene())
    assert str(refused.value).startswith(message)


class TestTrains:
    @pytest.fixture
    def train(self, make_scene):
        """A wavy lens and a wide plane plate, which is turned by 90 degrees about z."""
        data = make_scene({"screen.pixels": [16, 16]}).to_data()
        first = data["elements"][0]
        plate = first | {"name": "plate", "position": [0, 0, 2], "tilt": [0, 0, 90]}
        plate |= {"half_width": [3, 3], "thickness": 0.2, "min_thickness": 0.1}
        plate |= {"faces": [{"shape": "plane"}, {"shape": "plane"}]}
        return Scene.from_data(data | {"elements": [first, plate]})

    def test_each_element_has_errors_of_its_own(self, train, rng):
        heights = {"lens.back": 0.5 + 0.01 * rng.normal(size=train.optic.net_shape)}
        lens = ElementError(decentre=(0.01, 0.02), index=0.003)
        plate = ElementError(tilt=(math.radians(3), 0.0), decentre=(0.1, 0.0))
        off, own = Perturbation(elements=(lens, plate)).applied(train, heights)
        assert off.elements[0].position == pytest.approx((0.01, 0.02, 0))
        assert off.elements[0].index == pytest.approx(train.optic.index + 0.003)
        # Its own x is the y of the scene.
        assert off.elements[1].position == pytest.approx((0, 0.1, 2), abs=1e-12)
        turn = off.elements[1].turn
        assert turn[:, 2] == pytest.approx(
            [math.sin(math.radians(3)), 0, math.cos(math.radians(3))]
        )
        assert own["lens.back"] == pytest.approx(heights["lens.back"])
        drawn = list(draw(Tolerances(tilt=0.1), 2, 1, 2))
        assert len({each.tilt for errors in drawn for each in errors.elements}) == 4

    def test_a_decentred_plane_plate_changes_nothing(self, train):
        target, flat = np.ones((16, 16)), {"lens.back": np.full(train.optic.net_shape, 0.5)}
        moved = Perturbation(elements=(ElementError(), ElementError(decentre=(0.5, -0.5))))
        nominal = validate(train, target, flat, 20_000, 1)
        off, own = moved.applied(train, flat)
        found = validate(off, target, own, 20_000, 1)
        assert found.relative_l2 == pytest.approx(nominal.relative_l2, abs=1e-12)
        assert found.efficiency == pytest.approx(nominal.efficiency, abs=1e-12)
        with pytest.raises(Refused, match="exit_tilt"):
            Tolerances(exit_tilt=0.1).check(train)
