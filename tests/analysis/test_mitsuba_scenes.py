"""Mitsuba finds the same light of mirrors, of two faces, and of trains of several elements."""

import numpy as np
import pytest

from resources import path
from tests.diffusers import with_diffuser
from workbench.analysis import mitsuba_elements as elements
from workbench.analysis.cross_check import cross_check
from workbench.analysis.mitsuba import MitsubaScene
from workbench.analysis.mitsuba_elements import Coordinates
from workbench.analysis.mitsuba_lights import mitsuba_lights
from workbench.analysis.tracing.trace import Trace
from workbench.geometry.ball_cutter import CutFace
from workbench.geometry.outlines import outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.progress import finished, no_progress
from workbench.scene import Scene
from workbench.scene.making.milling import Milling

pytestmark = pytest.mark.full


pytest.importorskip("mitsuba")


@pytest.mark.parametrize(
    "source", [{"kind": "collimated"}, {"kind": "point", "position": [-2.0, 0.0, -6.0]}]
)
def test_mitsuba_finds_the_same_light_of_a_mirror(source):
    scene = Scene.from_data(
        {
            "mirror": {"half_width": [1, 1], "control_points": [6, 6], "reflectance": 0.8},
            "source": source,
            "screen": {
                "z": -6.0,
                "center": [5.0, 0.5],
                "tilt": [0.0, -40.0],
                "half_width": [2.0, 2.0],
                "pixels": [16, 16],
            },
            "target": {"builtin": "ball"},
        }
    )
    x, y = ControlNet.of(scene.optic).positions
    # It leans towards the screen, and is bent more along x than along y.
    heights = 0.28 * x[:, None] - 0.05 * np.square(x[:, None]) - 0.02 * np.square(y)
    found = cross_check(scene, np.ones((16, 16)), {"mirror.face": heights}, rays=200_000)
    assert found.ours.efficiency > 0.3
    assert found.mitsuba.efficiency == pytest.approx(found.ours.efficiency, rel=0.01)
    assert found.difference < 1.3 * found.noise


TILTED = {"kind": "collimated", "direction": [12, -5]}


POINT = {"kind": "point", "position": [0.2, 0, -4], "rays": 1000}


@pytest.mark.parametrize(("source", "outline"), [(TILTED, "rectangle"), (POINT, "ellipse")])
def test_mitsuba_finds_the_same_light_of_two_faces(make_scene, monkeypatch, source, outline):
    monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 128)  # made sooner
    scene = make_scene(
        {
            "version": 2,
            "lens.outline": outline,
            "lens.entrance": {
                "shape": "freeform",
                "control_points": [7, 9],
                "height_range": [-0.05, 0.3],
            },
            "lens.base": {"shape": "flat", "height": 0.6},
            "source": source,
            "screen.half_width": [1.8, 1.8],
            "screen.pixels": [16, 16],
            "lens.reflection": "fresnel",
        }
    )
    heights = {}
    for (name, net), z in zip(freeform_nets(scene.optic).items(), (0.0, 0.6), strict=True):
        x, y = net.positions[0][:, None], net.positions[1]
        heights[name] = z + 0.01 * np.sin(2 * x + len(name)) * np.cos(3 * y)
    x, y = freeform_nets(scene.optic)["lens.front"].positions
    heights["lens.front"] += 0.12 * (x[:, None] ** 2 + y**2)
    found = cross_check(scene, np.ones((16, 16)), heights, rays=100_000)
    assert found.ours.efficiency > 0.3
    assert found.mitsuba.efficiency == pytest.approx(found.ours.efficiency, rel=0.015)
    assert found.difference < 1.3 * found.noise


def test_mitsuba_finds_the_same_light_of_a_train(monkeypatch):
    monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 128)  # made sooner
    lens = {"kind": "lens", "thickness": 0.5, "material": {"index": 1.5}}
    plane, ball = {"shape": "plane"}, {"shape": "conic", "radius": -1.0, "conic": -0.4}
    dome = {"name": "dome", "position": [0, 0, -3], "half_width": [0.9, 0.7], "outline": "ellipse"}
    freeform = {"name": "lens", "half_width": [1.2, 1.0]}
    cover = {"name": "cover", "half_width": [1.5, 1.5], "material": "N-BK7"}
    bowl = {"shape": "conic", "radius": 4.0, "coefficients": [0.01]}
    scene = Scene.from_data(
        {
            "version": 3,
            "source": {"kind": "area", "position": [0.1, 0, -3.5], "half_width": [0.1, 0.2]},
            "elements": [
                lens | dome | {"faces": [plane, ball]},
                lens | freeform | {"faces": [plane, {"shape": "bspline"}]},
                lens
                | cover
                | {"position": [0.3, 0.1, 1.6], "tilt": [10, -15, 30], "faces": [bowl, plane]},
            ],
            "images": [
                {
                    "receiver": {
                        "kind": "plane",
                        "position": [0.3, 0, 5],
                        "tilt": [0, 12, 0],
                        "half_width": [1.6, 1.6],
                        "pixels": [16, 16],
                    },
                    "target": {"builtin": "ball"},
                }
            ],
        }
    ).with_net((8, 8))
    x, y = ControlNet.of(scene.optic).positions
    heights = 0.5 - 0.12 * np.square(x[:, None]) - 0.08 * np.square(y) + 0.03 * x[:, None]
    found = cross_check(scene, np.ones((16, 16)), {"lens.back": heights}, rays=200_000)
    assert found.ours.efficiency > 0.1
    assert found.mitsuba.efficiency == pytest.approx(found.ours.efficiency, rel=0.02)
    assert found.difference < 1.3 * found.noise


@pytest.mark.parametrize(
    ("scatter", "tilt"),
    [({"kind": "gaussian", "sigma": 25.0}, 30.0), ({"kind": "lambertian"}, 0.0)],
)
def test_mitsuba_finds_the_same_light_of_a_diffuser(monkeypatch, scatter, tilt):
    """Also of slanted light, some of which a wide scatter would send back."""
    monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 96)  # made sooner
    plane = {"kind": "plane", "position": [0, 0, 45], "half_width": [40, 40], "pixels": [16, 16]}
    how = {"transmittance": 0.8, "outline": "ellipse", "tilt": [0, tilt, 0]}
    scene = Scene.from_data(with_diffuser(scatter, plane, **how))
    x, y = ControlNet.of(scene.optic).positions
    heights = scene.optic.base.height + 0.01 * (x[:, None] ** 2 - 2 * y**2 + x[:, None])
    found = cross_check(scene, np.ones((16, 16)), {"lens.back": heights}, rays=400_000)
    assert found.ours.efficiency > 0.3
    assert found.mitsuba.efficiency == pytest.approx(found.ours.efficiency, rel=0.005)
    assert found.difference < 1.3 * found.noise


def test_mitsuba_finds_the_light_of_a_cut_in_a_fine_mesh_of_it(make_scene, monkeypatch):
    """The check knows scallops by their slopes; here Mitsuba meets the ridges themselves."""
    changes = {
        "version": 2,
        "lens.control_points": [24, 24],
        "lens.reflection": "fresnel",
        "screen.half_width": [3.0, 3.0],
        "screen.pixels": [24, 24],
    }
    scene = make_scene(changes)
    (net,) = freeform_nets(scene.optic).values()
    x, y = net.positions
    heights = 0.5 + 0.08 * x[:, None] ** 2 - 0.05 * y**2 + 0.05 * x[:, None] * y
    face = CutFace(net, heights, outline_of(scene.optic))
    raster = finished(face.plan_raster(0.25, 0.005, 10**6))
    step = float(raster.y[1] - raster.y[0])
    ridges = (raster.y[1:] + raster.y[:-1]) / 2
    inner = ridges[np.abs(ridges) < net.half_width[1]] / net.half_width[1]
    v = np.interp(
        np.linspace(0, len(inner) + 1, 24 * (len(inner) + 1) + 1),
        np.arange(len(inner) + 2),
        [-1, *inner, 1],
    )
    smooth, mesh = elements.face_points, elements._mesh

    def points(element, placed, u, v, heights):
        found = element.seen(smooth(element, placed, u, v, heights))
        if placed.name in heights:
            found[..., 2] = raster.cut_at(found[..., 0].ravel(), found[..., 1].ravel()).reshape(
                found.shape[:2]
            )
        return element.in_scene(found)

    monkeypatch.setattr(elements._Placed, "grid", lambda _: (np.linspace(-1, 1, 193), v))
    monkeypatch.setattr(elements, "face_points", points)
    monkeypatch.setattr(
        elements, "_mesh", lambda placed, points, law, _=None: mesh(placed, points, law)
    )
    rays, faces = 150_000, {"lens.back": heights}
    theirs = [MitsubaScene(scene, faces).flux(rays, seed, no_progress) for seed in (1, 2)]

    def apart(scene):
        """Difference to the check's image of a scene, without the scatter of the rays."""
        ours = [
            sum(
                batch.flux[0]
                for batch in filter(None, Trace(scene, faces, 4 * rays, seed).batches())
            )
            for seed in (1, 2)
        ]
        (m_1, m_2), (o_1, o_2) = (
            [each / each.sum() for each in images]
            for images in (theirs, [o.reshape(24, 24) for o in ours])
        )
        return ((m_1 - o_1) * (m_2 - o_2)).sum() / (o_1 * o_2).sum()

    milled = scene.altered(processes=(Milling(ball_radius=0.25, step_over=step),))
    assert apart(scene) > 0.2**2
    assert apart(milled) < 0.02**2


def test_rays_of_mitsuba_start_at_an_emitter_just_before_a_dome():
    """Single precision moves them onwards; 2 % of the gap cost 0.05 % of the light of a train."""
    import mitsuba

    mitsuba.set_variant("scalar_rgb")
    scene = Scene.from_json(path("examples", "dome-cover.json").read_bytes())
    coordinates = Coordinates.of(scene)
    lights, _ = mitsuba_lights(
        mitsuba, *coordinates.entrance(scene), coordinates.unit, rays=1, seed=1
    )
    lit = mitsuba.load_dict({"type": "scene", **lights})
    ray, *_ = lit.sample_emitter_ray(0.0, 0.5, [0.3, 0.9], [0.4, 0.7], True)
    gap = scene.first.position[2] - scene.source.position[2]
    assert gap == pytest.approx(0.1)
    beyond = ray.o[2] * coordinates.unit + coordinates.begin - scene.source.position[2]
    assert 0 <= beyond < 1e-3 * gap


def test_mitsuba_finds_the_same_light_of_a_folded_train(monkeypatch):
    monkeypatch.setattr("workbench.analysis.mitsuba_elements._CELLS", 128)  # made sooner
    plane = {"shape": "plane"}
    # Two mirrors as in a periscope, whose light goes beside the first one.
    scene = Scene.from_data(
        {
            "version": 3,
            "source": {"kind": "point", "position": [0.1, 0, -5]},
            "elements": [
                {"kind": "lens", "name": "lens", "half_width": [1.2, 1.0], "tilt": [4, -3, 20]}
                | {"thickness": 0.5, "material": {"index": 1.5}, "position": [0.1, -0.1, 0]}
                | {"faces": [plane, {"shape": "bspline"}]},
                {"kind": "mirror", "name": "fold", "half_width": [1.6, 2.2], "reflectance": 0.9}
                | {"position": [0, 0, 3], "tilt": [45, 0, 0]}
                | {"face": {"shape": "conic", "radius": 60.0}},
                {"kind": "mirror", "name": "back", "half_width": [1.8, 2.4], "outline": "ellipse"}
                | {"position": [0, 4, 3], "tilt": [-135, 0, 0], "face": plane},
            ],
            "images": [
                {
                    "receiver": {"kind": "plane", "position": [0, 4, 9]}
                    | {"half_width": [1.8, 1.8], "pixels": [16, 16]},
                    "target": {"builtin": "ball"},
                }
            ],
        }
    ).with_net((8, 8))
    x, y = ControlNet.of(scene.optic).positions
    heights = 0.5 - 0.16 * np.square(x[:, None]) - 0.12 * np.square(y) + 0.03 * x[:, None]
    found = cross_check(scene, np.ones((16, 16)), {"lens.back": heights}, rays=200_000)
    assert found.ours.efficiency > 0.2
    assert found.mitsuba.efficiency == pytest.approx(found.ours.efficiency, rel=0.01)
    assert found.difference < 1.3 * found.noise
