"""Trains of fixed lenses about a designed plate, against closed forms."""

import json
import math
import re

import numpy as np
import pytest
import torch

from resources import path
from workbench.analysis.derivatives import irradiance_derivative
from workbench.analysis.focus import screen_at, with_screen_at
from workbench.analysis.shading import shading_of
from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.surfaces.fixed import ConicSurface
from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import OpticalTrain
from workbench.cli.validate import validate as run_validate
from workbench.design.lens_state import LensState
from workbench.design.session import Session
from workbench.design.snapshot import Result
from workbench.errors import Refused
from workbench.files.session import open_design, write_session
from workbench.geometry.faces import FaceArrays
from workbench.geometry.outlines import Ellipse, Rectangle
from workbench.geometry.surface import nets_of
from workbench.optics.account import Account
from workbench.optics.plan import Plan, tensors_of
from workbench.scene import ConicFace, Scene

N = 1.5
R_0 = ((N - 1) / (N + 1)) ** 2  # at normal incidence
PLANE = {"shape": "plane"}
COLLIMATED = {"kind": "collimated"}


def lens(name, position, half_width, faces, thickness=0.5, **more):
    return {
        "kind": "lens",
        "name": name,
        "position": list(position),
        "half_width": [half_width, half_width],
        "material": {"index": N},
        "thickness": thickness,
        "faces": faces,
    } | more


def plate(name, z, half_width=2.0, aside=(0.0, 0.0), **more):
    return lens(name, (*aside, z), half_width, [PLANE, PLANE], **more)


def designed(z=0.0, half_width=1.0, **more):
    net = {"shape": "bspline", "control_points": [6, 6]}
    return lens("designed", (0.0, 0.0, z), half_width, [PLANE, net], min_thickness=0.1, **more)


def scene_of(source, elements, z=9.0, half_width=4.0, pixels=16):
    receiver = {
        "kind": "plane",
        "position": [0.0, 0.0, z],
        "half_width": [half_width, half_width],
        "pixels": [pixels, pixels],
    }
    return Scene.from_data(
        {
            "format": "freeform-scene",
            "version": 3,
            "source": source,
            "elements": elements,
            "images": [{"receiver": receiver, "target": {"builtin": "tophat"}}],
        }
    )


def flat(scene):
    optic = scene.optic
    return {optic.designed_face: np.full(optic.net_shape, optic.base.height)}


def account_of(scene, rays=4000):
    """Parts of the light by name, those on the receiver among them."""
    total = None
    for tally in Trace(scene, flat(scene), rays, 1).batches(1):
        total = added(total, tally)
    parts = {name: flux / total.emitted for name, flux in total.lost.items()}
    parts |= {
        "off_screen": float(total.beside.sum()) / total.emitted,
        "on_screen": float(total.flux.sum()) / total.emitted,
    }
    assert sum(parts.values()) == pytest.approx(1, abs=1e-12)
    return parts


def train_of(scene):
    return OpticalTrain.of(scene, flat(scene), 1000, 1, Pose(), scene.receivers)


def leaving(scene, *slopes_and_places):
    """Rays that leave the train, of given (slope along x, x) in the plane of the aperture."""
    slope, x = np.array(slopes_and_places, float).T
    way = np.column_stack([slope, 0 * slope, np.ones_like(slope)])
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    place = np.column_stack([x, 0 * x, 0 * x])
    return train_of(scene).leaving(TracedRays(place, way, np.ones(len(x))))[0]


class TestPlates:
    def test_each_face_reflects_its_part_of_collimated_light(self):
        elements = [
            plate("window", -2.0, 1.0),
            designed(absorption=0.1),
            plate("cover", 3.0, thickness=1.0, absorption=0.2),
        ]
        parts = account_of(scene_of(COLLIMATED, elements))
        passed = [(1 - R_0) ** k for k in range(6)]
        clear = [1, 1, 1, math.exp(-0.05), math.exp(-0.05), math.exp(-0.25)]
        reflected = [R_0 * p * c for p, c in zip(passed, clear, strict=True)]
        for number, name in enumerate(("window", "designed", "cover")):
            for face, part in zip(("entrance", "exit"), reflected[2 * number :], strict=False):
                assert parts[f"fresnel_{face}@{name}"] == pytest.approx(part, rel=1e-12)
        absorbed = (1 - R_0) ** 3 * (1 - math.exp(-0.05))
        assert parts["absorbed@designed"] == pytest.approx(absorbed, rel=1e-12)
        absorbed = (1 - R_0) ** 5 * math.exp(-0.05) * (1 - math.exp(-0.2))
        assert parts["absorbed@cover"] == pytest.approx(absorbed, rel=1e-12)
        assert parts["on_screen"] == pytest.approx((1 - R_0) ** 6 * math.exp(-0.25), rel=1e-12)

    def test_a_cover_shifts_the_image_plane(self):
        thickness, slope = 2.0, 1e-4
        bare, covered = (
            leaving(scene_of(COLLIMATED, [designed(), *cover]), (slope, 0.0))
            for cover in ([], [plate("cover", 1.0, thickness=thickness)])
        )

        def crossing(rays):
            """Where the ray, followed backwards, crosses the axis."""
            (x, _, z), (d_x, _, d_z) = rays.position[0], rays.direction[0]
            return z - x * d_z / d_x

        shift = crossing(covered) - crossing(bare)
        assert shift == pytest.approx(thickness * (1 - 1 / N), rel=1e-6)

    @pytest.mark.parametrize("degrees", [20.0, -50.0])
    def test_a_tilted_cover_shifts_light_aside(self, degrees):
        thickness = 1.0
        cover = plate("cover", 5.0, thickness=thickness, tilt=[0.0, degrees, 0.0])
        (place, *_), (way, *_), _ = leaving(scene_of(COLLIMATED, [designed(), cover]), (0.0, 0.1))
        angle = math.radians(degrees)
        inside = math.asin(math.sin(angle) / N)
        # A plate whose normal leans to +x takes light along +z to +x.
        shift = thickness * math.sin(angle - inside) / math.cos(inside)
        assert place[0] - 0.1 == pytest.approx(shift, rel=1e-12)
        assert way == pytest.approx([0, 0, 1], abs=1e-12)

    def test_light_beside_an_element_behind_is_lost_there(self):
        cover = plate("cover", 3.0, half_width=0.5, aside=(0.5, 0.0))
        parts = account_of(scene_of(COLLIMATED, [designed(), cover]), rays=64_000)
        # It is 1 × 1 of the 2 × 2 that is lit.
        assert parts["missed_lens@cover"] == pytest.approx(0.75 * (1 - R_0) ** 2, rel=1e-2)
        assert parts["on_screen"] == pytest.approx(0.25 * (1 - R_0) ** 4, rel=1e-2)

    def test_the_first_outline_is_the_aperture_of_all_light(self):
        window = plate("window", -1.0, half_width=0.5, outline="ellipse")
        parts = account_of(scene_of(COLLIMATED, [window, designed()]))
        assert parts["missed_lens@window"] == pytest.approx(1 - math.pi / 4, rel=1e-12)


def concentric_dome():
    """A shell about the origin, hit at right angles by all light of a point there."""
    sphere = [{"shape": "conic", "radius": -each} for each in (2.0, 3.0)]
    return lens("dome", (0.0, 0.0, 2.0), 1.0, sphere, thickness=1.0, outline="ellipse")


POINT = {"kind": "point", "position": [0.0, 0.0, 0.0], "emission": "uniform"}


class TestCurvedFaces:
    def test_a_concentric_dome_only_reflects(self):
        scene = scene_of(POINT, [concentric_dome(), designed(z=4.0, half_width=3.0)])
        first = scene.elements[0].front_z
        slopes = np.array([0.0, 0.1, -0.2, 0.33])
        left = leaving(scene, *((s, s * first) for s in slopes))
        bare = scene_of(POINT, [designed(z=4.0, half_width=3.0)])
        alone = leaving(bare, *((s, s * 4.0) for s in slopes))
        assert left.direction == pytest.approx(alone.direction, abs=1e-12)
        z = [0.0, 0.0, first - 4.0]
        assert left.position + z == pytest.approx(alone.position, abs=1e-12)
        assert left.flux == pytest.approx((1 - R_0) ** 2 * alone.flux, rel=1e-12)

    def test_accounts_of_wide_light_are_whole(self):
        source = {"kind": "area", "position": [0.0, 0.0, 0.0], "half_width": [0.3, 0.3]}
        tilted = plate("cover", 6.0, aside=(0.3, -0.2), tilt=[10.0, -20.0, 30.0])
        elements = [concentric_dome(), designed(z=4.0, half_width=3.0), tilted]
        scene = scene_of(source, elements, half_width=1.0)
        parts = account_of(scene)
        assert min(parts["missed_lens@dome"], parts["off_screen"], parts["on_screen"]) > 0.01
        assert parts["missed_lens@cover"] > 0.005

    def test_a_hyperbola_makes_light_of_its_focus_parallel(self):
        focal = 4.0
        front = {"shape": "conic", "radius": focal * (N - 1), "conic": -(N**2)}
        collimator = lens("collimator", (0.0, 0.0, 0.0), 1.5, [front, PLANE], thickness=1.0)
        source = POINT | {"position": [0.0, 0.0, -focal]}
        scene = scene_of(source, [collimator, designed(z=2.0, half_width=2.0)])
        slopes = (0.0, 0.05, -0.2, 0.3)
        left = leaving(scene, *((slope, slope * focal) for slope in slopes))
        assert left.direction == pytest.approx(np.array([[0.0, 0.0, 1.0]] * 4), abs=1e-12)
        assert (left.flux > 0.8).all()
        parts = account_of(scene)
        for name in ("collimator", "designed"):
            assert parts[f"total_reflection@{name}"] == parts[f"left_side@{name}"] == 0
        assert parts["off_screen"] == 0
        assert parts["on_screen"] > 0.4  # the cone of light is wider than the outline

    def test_a_hyperbola_brings_parallel_light_to_its_focus(self):
        focal = 6.0
        back = {"shape": "conic", "radius": -focal * (N - 1), "conic": -(N**2)}
        elements = [designed(), lens("lens", (0.0, 0.0, 3.0), 1.0, [PLANE, back], thickness=1.0)]
        left = leaving(scene_of(COLLIMATED, elements), (0.0, 0.2), (0.0, -0.5), (0.0, 0.9))
        path = (4.0 + focal - left.position[:, 2:]) / left.direction[:, 2:]
        there = left.position + path * left.direction
        assert there == pytest.approx(np.array([[0.0, 0.0, 4.0 + focal]] * 3), abs=1e-12)
        assert (left.flux > 0.8).all()


class TestConicSurface:
    rng = np.random.default_rng(3)

    @pytest.mark.parametrize("outline", [Ellipse((1.0, 0.8)), Rectangle((0.7, 0.9))])
    @pytest.mark.parametrize(
        ("radius", "conic", "coefficients"),
        [
            (2.0, 0.0, ()),
            (-1.5, -1.0, ()),
            (3.0, -4.0, ()),
            (-4.0, 0.5, (0.05, -0.02)),
            (9, 0, (0.1,)),
        ],
    )
    def test_crossings_are_on_the_surface(self, radius, conic, coefficients, outline):
        face = ConicFace(shape="conic", radius=radius, conic=conic, coefficients=coefficients)
        surface = ConicSurface(face, 0.5, outline, "left_side")
        goal = self.rng.uniform(-0.5, 0.5, (200, 2))
        z = 0.5 + face.sag(*goal.T)
        start = np.column_stack([self.rng.uniform(-0.5, 0.5, (200, 2)), np.full(200, -2.0)])
        way = np.column_stack([goal, z]) - start
        way /= np.linalg.norm(way, axis=1, keepdims=True)
        met = surface.meet(TracedRays(start, way, np.ones(200)))
        assert (met.flux == 1).all()
        assert met.position == pytest.approx(np.column_stack([goal, z]), abs=1e-12)
        step = 1e-6
        x, y = goal.T
        slope_x = (face.sag(x + step, y) - face.sag(x - step, y)) / (2 * step)
        slope_y = (face.sag(x, y + step) - face.sag(x, y - step)) / (2 * step)
        along = met.normal[:, :2] / met.normal[:, 2:]
        assert along == pytest.approx(-np.column_stack([slope_x, slope_y]), abs=1e-8)

    @pytest.mark.parametrize("coefficients", [(), (1e-9,)])
    def test_light_over_the_rim_of_a_bowl_is_missed(self, coefficients):
        face = ConicFace(shape="conic", radius=-1.2, coefficients=coefficients)
        surface = ConicSurface(face, 0.0, Ellipse((1.0, 1.0)), "missed_lens")
        low = float(face.sag(1.0, 0.0))
        start = np.array([[0.0, 0.0, -2.0], [-1.5, 0.0, low - 0.1], [-0.5, 0.0, -2.0]])
        way = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.35], [0.6, 0.0, 0.8]])
        way[1] /= np.linalg.norm(way[1])
        met = surface.meet(TracedRays(start, way, np.ones(3)))
        assert met.flux.tolist() == [1.0, 0.0, 1.0]


class TestChecksOfTrains:
    elements = (plate("window", -2.0, 1.0), designed(), plate("cover", 3.0))

    def test_a_lens_out_of_its_place_is_refused(self):
        scene = scene_of(COLLIMATED, list(self.elements))
        with pytest.raises(Refused, match="3 given"):
            Trace(scene, flat(scene), 1000, 1, Pose(tilt=(0.01, 0.0)))

    def test_a_receiver_within_the_last_element_is_refused(self):
        scene = scene_of(COLLIMATED, list(self.elements))
        with pytest.raises(Refused, match="may touch the element cover"):
            Trace(scene, flat(scene), 1000, 1, distances=[3.2])

    def test_a_trough_behind_a_plate_sends_its_light_to_its_other_side(self):
        net = {"shape": "bspline", "control_points": [41, 4], "degree": [1, 1]}
        trough = {"kind": "mirror", "name": "trough", "half_width": [1.0, 1.0], "face": net}
        data = scene_of(COLLIMATED, [designed()]).to_data()
        data["elements"] = [plate("window", -6.0, 1.0), trough]
        data["images"][0]["receiver"] |= {"position": [0, 0, -9], "half_width": [0.5, 0.4]}
        scene = Scene.from_data(data)
        x, _ = nets_of(scene)["trough.face"].positions
        heights = {"trough.face": np.repeat(-np.abs(x)[:, None], 4, axis=1)}
        found = shading_of(scene, heights, 1)
        assert found.meets_again == pytest.approx((1 - R_0) ** 2, rel=2e-2)
        assert found.through_receiver == pytest.approx(0.5 * 0.4, rel=2e-2)

    def test_screens_are_moved_along_the_light_behind_the_last_element(self):
        scene = scene_of(COLLIMATED, list(self.elements))
        assert screen_at(scene, flat(scene), 0.0) == pytest.approx(3.5)
        assert screen_at(scene, flat(scene), 1.0) == scene.receiver.z
        folded = open_design(path("examples", "fold-mirror.json")).scene
        with pytest.raises(Refused, match="light comes to the screen across the z axis"):
            with_screen_at(folded, 10.0)

    @pytest.mark.parametrize("face", ["first.back", "second.back"])
    def test_a_derivative_map_of_a_train_is_a_difference(self, rng, face):
        net = {"shape": "bspline", "control_points": [6, 6]}
        elements = [
            lens(name, (0.1, 0.0, z), 1.0 + z / 8, [PLANE, net], min_thickness=0.1)
            for name, z in (("first", 0.0), ("second", 2.0))
        ]
        scene = scene_of(COLLIMATED | {"rays": [96, 96]}, elements, half_width=2.0)
        optics = {optic.designed_face: optic for optic in scene.optics}
        heights = {
            name: optic.base.height + 0.02 * rng.normal(size=(6, 6))
            for name, optic in optics.items()
        }
        found = irradiance_derivative(scene, heights, (2, 3), face=face)
        images, step = [], 1e-5
        for way in (step, -step):
            moved = {name: each.copy() for name, each in heights.items()}
            moved[face][2, 3] += way
            plan = Plan(scene, dtype=torch.float64)
            images.append(plan.flux(tensors_of(moved, scene)).numpy())
        difference = (images[0] - images[1]) / (2 * step * scene.receiver.pixel_measure)
        assert found.map == pytest.approx(difference, abs=1e-4 * np.abs(found.map).max())
        assert found.position == tuple(
            p[k] for p, k in zip(nets_of(scene)[face].positions, (2, 3), strict=True)
        )

    def test_the_command_checks_the_session_of_a_train(self, tmp_path, capsys):
        scene = scene_of(COLLIMATED, list(self.elements))
        image = np.ones((16, 16))
        state = LensState(FaceArrays(flat(scene)), image, 1.0, Account(1.0, {}))
        result = Result(state, losses=np.ones(1), seconds=1.0)
        file = tmp_path / "train.freeform"
        write_session(Session(scene, image, result), file)
        run_validate(file, 4000, None, False, [8.0], None, as_json=True)
        figures = json.loads(capsys.readouterr().out)
        assert figures["efficiency"] == pytest.approx((1 - R_0) ** 6, rel=1e-12)
        assert "relative_l2_bound" not in figures
        assert figures["ledger"]["fresnel_exit@window"] == pytest.approx((1 - R_0) * R_0)
        run_validate(file, 4000, None, False, [], None, as_json=False)
        assert re.search(r"fresnel exit \(window\): 0\.0384\d", capsys.readouterr().out)
        assert figures["through_focus"][0]["efficiency"] == pytest.approx((1 - R_0) ** 6)
