"""Light of lamp files and of measured rays, and samples where a beam is narrow."""

import numpy as np
import pytest
import torch
from scipy.spatial.transform import Rotation

from tests.lamps import PLATE, behind_plate, crooked_lamp, downlight, led
from tests.measured.photometry.files import ies
from workbench.analysis.metrics import relative_l2
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.validation import validate
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.measured.lamps import intensity_of
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.samples import Corners
from workbench.optics.sources import emitter_of
from workbench.optics.sources.patterns import tabulated
from workbench.scene import Scene


@pytest.fixture
def scene(make_scene, tmp_path):
    changes = {"source": led(tmp_path), "screen.pixels": [16, 16], "lens.reflection": "none"}
    return make_scene(changes)


def waves(scene):
    x, y = (torch.as_tensor(c) for c in ControlNet.of(scene.optic).positions)
    return 0.5 + 0.05 * torch.sin(3 * x[:, None] + 1) * torch.cos(2 * y[None, :])


def test_beams_of_points_make_the_image_of_the_rays(scene):
    lens = waves(scene)
    light = BeamPlan(scene, Corners(40, 40, 64), dtype=torch.float64).trace({"lens.back": lens})

    found = validate(scene, np.ones((16, 16)), {"lens.back": lens.numpy()}, 200_000, accuracy=3e-3)

    assert found.rays == 200_000
    # The file's own noise: about 7,000 of its rays come to 256 pixels.
    assert relative_l2(light.flux.numpy(), found.irradiance) < 0.25
    assert relative_l2(light.flux.numpy(), found.by_cells.irradiance) < 5e-3
    assert found.account.on_screen == pytest.approx(light.account.on_screen, rel=0.02)
    assert found.account.on_screen + sum(found.account.lost.values()) == pytest.approx(1, abs=1e-9)


@pytest.mark.usefixtures("fewer_rays")
def test_the_lamp_stays_where_it_is_while_the_lens_is_turned(scene):
    lens, pose = {"lens.back": waves(scene).numpy()}, Pose(tilt=(0.05, -0.03), decentre=(0.1, 0.0))

    turned = validate(scene, np.ones((16, 16)), lens, 200_000, pose=pose, accuracy=1e-2)

    by_cells, rays = turned.by_cells.irradiance, turned.irradiance
    assert rays.sum() == pytest.approx(by_cells.sum(), rel=0.02)
    straight = validate(scene, np.ones((16, 16)), lens, 200_000)
    assert relative_l2(by_cells, rays) < relative_l2(by_cells, straight.irradiance)


def test_plans_of_a_lamp_share_its_table(make_scene, tmp_path):
    lamp = crooked_lamp(tmp_path)
    scene = make_scene({"source": lamp})
    turned = make_scene({"source": lamp | {"rotation": [0.0, 0.0, 0.0]}})

    def table(scene, z):
        origins = emitter_of(scene.source, scene.optic).origins
        return tabulated(origins, (1.0, 1.0), z, None).values

    first = table(scene, 0.0)
    assert table(scene, 0.0) is first
    assert not np.allclose(table(scene, 0.5), first)
    assert not np.allclose(table(turned, 0.0), first)


@pytest.mark.parametrize("kind", ["ray file", "photometric"])
def test_gradients_are_those_of_central_differences(kind, make_scene, tmp_path):
    source = led(tmp_path) if kind == "ray file" else crooked_lamp(tmp_path)
    scene = make_scene({"source": source, "screen.pixels": [16, 16]})
    plan = BeamPlan(scene, Corners(12, 12, 4 if kind == "ray file" else 1), dtype=torch.float64)
    heights = waves(scene)
    generator = torch.Generator().manual_seed(1)
    weights = torch.rand(16, 16, generator=generator, dtype=torch.float64)
    step = torch.randn(heights.shape, generator=generator, dtype=torch.float64)

    def value(z):
        return (plan.trace({"lens.back": z}).flux * weights).sum()

    leaf = heights.clone().requires_grad_()
    value(leaf).backward()
    h = 1e-6
    difference = (value(heights + h * step) - value(heights - h * step)) / (2 * h)
    assert (leaf.grad * step).sum().item() == pytest.approx(difference.item(), rel=1e-5)


@pytest.fixture
def plate(make_scene, tmp_path):
    return make_scene({**PLATE, "source": downlight(tmp_path)})


@pytest.fixture
def crooked(make_scene, tmp_path):
    return make_scene({"source": crooked_lamp(tmp_path)})


def radii(scene):
    n_x, n_y = scene.receiver.pixels
    r_x, r_y = scene.receiver.half_width
    x = (2 * (np.arange(n_x) + 0.5) / n_x - 1) * r_x
    y = (2 * (np.arange(n_y) + 0.5) / n_y - 1) * r_y
    return np.hypot(x, y[:, None])


def flat(scene):
    net = ControlNet.of(scene.optic)
    return {"lens.back": torch.full(net.shape, scene.optic.base.height, dtype=torch.float64)}


def test_light_behind_a_plate_is_that_of_the_closed_form(plate):
    light = BeamPlan(plate, (160, 160), dtype=torch.float64).trace(flat(plate))

    found = light.flux.numpy() / plate.receiver.pixel_measure
    wanted = behind_plate(radii(plate))
    assert np.linalg.norm(found - wanted) / np.linalg.norm(wanted) < 1e-3


def test_the_lamp_is_turned_about_x_then_y_then_z(crooked):
    pattern = emitter_of(crooked.source, crooked.optic).origins.pattern
    directions = np.random.default_rng(1).normal(size=(100, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)

    turn = Rotation.from_euler("xyz", [10, -20, 30], degrees=True)
    in_file = turn.inv().apply(directions)
    found = pattern.at(np.zeros(100, int), tuple(directions.T))
    assert np.allclose(found, intensity_of(crooked.source).at(in_file))


GAMMA = np.linspace(0, 90, 181)


# A quadrature over the aperture, and sums over 32 × 32 cells, are so far apart at most.
WITHIN = 5e-4


def scene_of(width, distance, aside, optic="lens", outline="rectangle"):
    """A lamp with half of its intensity within an angle, straight on or aside and turned."""
    lens = {
        "half_width": [1.0, 0.8],
        "refractive_index": 1.5,
        "control_points": [8, 8],
        "outline": outline,
    }
    if optic == "two faces":
        lens["entrance"] = {"shape": "freeform", "control_points": [8, 8]}
    content = ies([0], GAMMA, 1e5 * np.exp2(-((GAMMA / width) ** 2))[None]).encode()
    source = {
        "kind": "photometric",
        "file": "narrow.ies",
        "position": [0.41, 0.31, -distance] if aside else [0.0, 0.0, -distance],
        "rotation": [0.0, 14.0, 0.0] if aside else [0.0, 0.0, 0.0],
    }
    data = {
        "format": "freeform-scene",
        "version": 2,
        "unit": "mm",
        "lens": lens,
        "source": source,
        "screen": {"z": 20.0, "half_width": [20.0, 20.0], "pixels": [8, 8]},
        "target": {"builtin": "tophat"},
    }
    return Scene.from_data(data).carrying({"narrow.ies": content})


def traced(scene, cells=32):
    heights = {
        face: torch.full(net.shape, float(scene.optic.place_of(face, 0.0, 0.0))).double()
        for face, net in freeform_nets(scene.optic).items()
    }
    plan = BeamPlan(scene, Corners(cells, cells), dtype=torch.float64)
    return plan.trace(heights).account


@pytest.mark.parametrize("width", [1.0, 2.0, 20.0])
@pytest.mark.parametrize("distance", [0.03, 0.3, 1.2])
@pytest.mark.parametrize("aside", [False, True])
def test_samples_have_all_the_light_that_enters(width, distance, aside):
    account = traced(scene_of(width, distance, aside))

    shares = account.to_data()
    assert min(shares.values()) > -WITHIN
    assert max(shares.values()) <= 1 + WITHIN
    assert sum(shares.values()) - account.emitted == pytest.approx(account.emitted, abs=1e-9)


@pytest.mark.parametrize("distance", [3e-4, 1e-3, 0.01])
def test_light_of_a_wide_lamp_right_before_a_lens_is_that_of_a_lambertian_point(distance):
    lamp = scene_of(1.0, distance, aside=True)
    cosine = ies([0], GAMMA, np.cos(np.radians(GAMMA))[None]).encode()
    source = lamp.source.model_copy(update={"rotation": (0.0, 0.0, 0.0)})
    lamp = lamp.model_copy(update={"source": source}).carrying({"narrow.ies": cosine})
    point = {"kind": "point", "position": [0.41, 0.31, -distance], "emission": "lambertian"}
    known = Scene.from_data(lamp.to_data() | {"source": point})

    found, expected = (traced(scene, 64).to_data() for scene in (lamp, known))

    assert found == pytest.approx(expected, abs=5e-3)


@pytest.mark.parametrize("optic", ["lens", "two faces"])
@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_all_light_of_a_narrow_lamp_passes_flat_faces(optic, outline):
    account = traced(scene_of(1.0, 0.3, aside=False, optic=optic, outline=outline))

    # Fresnel's equations straight on: 4 % at each face.
    assert account.on_screen == pytest.approx(0.96**2, abs=2 * WITHIN)
    assert abs(account.lost["missed_lens"]) < WITHIN
    assert abs(account.lost["left_side"]) < WITHIN


@pytest.mark.parametrize("width", [0.6, 5.0, 40.0])
def test_directions_of_a_table_have_its_flux(width):
    table = intensity_of(scene_of(width, 1.0, aside=False).source)
    direction, flux = table.flux_nodes

    assert flux.sum() == pytest.approx(table.lumens, rel=1e-12)
    assert np.linalg.norm(direction, axis=1) == pytest.approx(1.0, abs=1e-12)
    # Within a cone of half of the width: the sum of a fine rule over its angles.
    cone = np.radians(np.linspace(0, width / 2, 4001))
    way = np.stack([np.sin(cone), np.zeros_like(cone), np.cos(cone)], axis=-1)
    wanted = 2 * np.pi * np.trapezoid(table.at(way) * np.sin(cone), cone)
    found = flux[direction[:, 2] >= np.cos(cone[-1])].sum()
    assert found == pytest.approx(wanted, abs=2e-3 * table.lumens)
