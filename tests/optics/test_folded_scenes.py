"""Scenes whose axis is folded at mirrors, or whose elements are tilted and shifted."""

import numpy as np
import pytest
import torch

from tests.optics.rays import bundle
from workbench.analysis.tracing.elements import TracedRays
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import OpticalTrain
from workbench.geometry.frames import Frame
from workbench.geometry.surface import ControlNet
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.path import Path
from workbench.optics.samples import Corners
from workbench.scene import Scene
from workbench.scene.turning import tilt_of, tilted

PLANE = {"shape": "plane"}
NET = {"shape": "bspline", "control_points": [6, 7]}
FOLD, ASIDE = [45.0, 0.0, 0.0], [-90.0, 0.0, 0.0]  # light along +z goes to +y
SUN = {"kind": "collimated", "angular_diameter": 2.0}
LED = {"kind": "area", "position": [0.1, -0.2, -9.0], "half_width": [0.3, 0.2]}


def lens(name, position, faces, half=1.2, tilt=(0.0, 0.0, 0.0), **more):
    return {
        "kind": "lens",
        "name": name,
        "position": list(position),
        "tilt": list(tilt),
        "half_width": [half, half],
        "material": {"index": 1.5},
        "thickness": 0.5,
        "faces": list(faces),
    } | more


def mirror(name, position, half, face=PLANE, tilt=(0.0, 0.0, 0.0)):
    return {
        "kind": "mirror",
        "name": name,
        "position": list(position),
        "tilt": list(tilt),
        "half_width": list(half),
        "face": face,
        "reflectance": 0.9,
    }


def scene_of(source, elements, place, tilt=(0.0, 0.0, 0.0), half=2.0):
    receiver = {
        "kind": "plane",
        "position": list(place),
        "tilt": list(tilt),
        "half_width": [half, half],
        "pixels": [12, 10],
    }
    image = {"receiver": receiver, "target": {"builtin": "tophat"}}
    return Scene.from_data(
        {"version": 3, "source": source, "elements": elements, "images": [image]}
    )


FREEFORM = [PLANE, NET]
BENT = {"shape": "conic", "radius": -9.0, "conic": -1.0}


def fold_before(source):
    elements = [mirror("fold", (0, 0, 0), (1.0, 1.45), tilt=FOLD)]
    elements.append(lens("lens", (0.1, 3, 0.05), FREEFORM, tilt=ASIDE))
    return scene_of(source, elements, (0, 9, 0), ASIDE)


def fold_behind(source):
    elements = [lens("lens", (0, 0, 0), FREEFORM)]
    elements.append(mirror("fold", (0, 0, 4), (2.0, 3.0), tilt=FOLD))
    return scene_of(source, elements, (0, 5, 4), ASIDE)


def mirror_before_lens(source):
    elements = [mirror("mirror", (0, 0, 0), (1.0, 1.4), NET, FOLD)]
    elements.append(lens("lens", (0, 4, 0), [PLANE, BENT], half=1.5, tilt=ASIDE))
    return scene_of(source, elements, (0, 9, 0), ASIDE)


def askew(source):
    elements = [lens("lens", (0.2, -0.1, 0.3), FREEFORM, tilt=(8, -5, 20))]
    elements.append(lens("field", (0.1, 0, 3), [PLANE, BENT], half=2.0, tilt=(0, 10, 0)))
    return scene_of(source, elements, (0, 0, 9))


def askew_behind(source):
    elements = [lens("first", (0.1, 0.1, 0), [PLANE, BENT], half=1.0, tilt=(5, 4, 0))]
    elements.append(lens("lens", (0.1, -0.1, 2), FREEFORM, half=1.4, tilt=(-8, 3, 10)))
    return scene_of(source, elements, (0, 0, 9))


TRAINS = [fold_before, fold_behind, mirror_before_lens, askew, askew_behind]


def waves(scene, size=0.02):
    """Control heights that are no mirror image of themselves."""
    optic, rng = scene.optic, np.random.default_rng(5)
    noise = size * rng.normal(size=optic.net_shape)
    return {optic.designed_face: optic.base.height + noise}


def tensors(heights):
    return {face: torch.tensor(each) for face, each in heights.items()}


def landed(scene, heights, place, way):
    """Columns and rows (2, m) of rays of the scene, by the walk and by the check."""
    path = Path.of(scene, ControlNet.of(scene.optic), torch.float64)
    first = scene.first
    own, there = way @ first.turn, first.seen(place)
    _, arrival = path.follow(bundle(there, own, np.ones(len(own))), tensors(heights))
    train = OpticalTrain.of(scene, heights, 100, 0, Pose(), scene.receivers)
    start = there - [0.0, 0.0, first.front_z]
    hits = np.zeros((len(own), 2))
    train.hits(TracedRays(start, np.ascontiguousarray(own), np.ones(len(own))), hits, np.ones(100))
    return np.stack([arrival.column.numpy(), arrival.row.numpy()]), hits.T


@pytest.mark.parametrize("where", [fold_before, fold_behind])
def test_a_train_folded_at_a_plane_mirror_is_the_unfolded_one(where, rng):
    """The mirror exchanges y and z; what is behind it counts y from there."""
    folded = where({"kind": "collimated"})
    heights = waves(folded)
    (own,) = (each for each in folded.elements if each.designed)
    x, y = rng.uniform(-0.8, 0.8, (2, 100))
    place = np.column_stack([x, y, np.full(100, -2.0)])
    way = np.column_stack([*rng.uniform(-0.05, 0.05, (2, 100)), np.ones(100)])
    way /= np.linalg.norm(way, axis=1)[:, None]
    flip = np.array([1.0, -1.0, 1.0])
    if where is fold_before:
        x_0, y_0 = own.position[0], -own.position[2]
        straight = scene_of(
            {"kind": "collimated"}, [lens("lens", (x_0, y_0, 3), FREEFORM)], (0, 0, 9)
        )
        unfolded = landed(straight, waves(straight), place * flip, way * flip)
    else:  # the screen counts its rows against y of the lens
        straight = scene_of({"kind": "collimated"}, [lens("lens", (0, 0, 0), FREEFORM)], (0, 0, 9))
        unfolded = [
            np.stack([columns, 10 - rows])
            for columns, rows in landed(straight, heights, place, way)
        ]
    for found, expected in zip(landed(folded, heights, place, way), unfolded, strict=True):
        assert np.isfinite(found).all()
        assert found == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("train", [fold_behind, mirror_before_lens, askew, askew_behind])
def test_a_scene_turned_and_shifted_as_a_whole_is_the_same(train):
    """Beams by the compiled train, and the random rays of the check, with the same seed."""
    scene = train({"kind": "collimated", "direction": [4.0, -3.0]})
    turn = Frame.at((0.4, -0.7, 2.0), (25.0, 20.0, -70.0))
    data = scene.to_data()
    for part in (*data["elements"], data["images"][0]["receiver"]):
        rotation = turn.rotation @ tilted(part.get("tilt", (0, 0, 0)))
        part["tilt"] = list(tilt_of(rotation))
        part["position"] = (turn.position + turn.rotation @ part["position"]).tolist()
    moved = scene.source.standing(None, turn.rotation)
    data["source"] = moved.model_dump(mode="json", exclude_none=True)
    images = []
    for each in (scene, Scene.from_data(data)):
        heights = waves(each)  # z of the front vertex is another one
        plan = BeamPlan(each, Corners(12, 10, 5), dtype=torch.float64)
        light = plan.trace(tensors(heights))
        tally = None
        for batch in Trace(each, heights, 2000, 1).batches(1):
            tally = added(tally, batch)
        images.append((light, tally))
    (light, tally), (same, same_tally) = images
    assert light.flux.sum() > 0.3
    assert (light.flux - same.flux).abs().max() < 1e-9 * light.flux.max()
    assert same.account.lost == pytest.approx(light.account.lost, abs=1e-9)
    assert same_tally.lost == pytest.approx(tally.lost, abs=1e-9 * tally.emitted)
    assert same_tally.beside == pytest.approx(tally.beside, abs=1e-9 * tally.emitted)


@pytest.mark.parametrize("turned", [0.0, 180.0])
def test_a_paraboloid_behind_a_plate_brings_parallel_light_to_its_focus(turned, rng):
    """Also one that light meets from its back: its radius counts along its own z."""
    radius = 20.0 if turned else -20.0
    face = {"shape": "conic", "radius": radius, "conic": -1.0}
    dish = mirror("dish", (0, 0, 20), (3.0, 3.0), face, (turned, 0, 0))
    elements = [lens("lens", (0, 0, 0), FREEFORM), dish]
    scene = scene_of({"kind": "collimated"}, elements, (0, 0, 10))
    x, y = rng.uniform(-1, 1, (2, 50))
    place, way = np.column_stack([x, y, np.full(50, -2.0)]), np.tile([0.0, 0.0, 1.0], (50, 1))
    for found in landed(scene, waves(scene, 0.0), place, way):
        assert found == pytest.approx(np.tile([[6.0], [5.0]], 50), abs=1e-9)


def test_a_tilted_designed_mirror_and_a_hyperboloid_make_a_focus(rng):
    focal = 3.0
    back = {"shape": "conic", "radius": -0.5 * focal, "conic": -(1.5**2)}
    elements = [mirror("mirror", (0, 0, 0), (1.0, 1.4), NET, FOLD)]
    elements.append(lens("lens", (0, 4, 0), [PLANE, back], tilt=ASIDE))
    scene = scene_of({"kind": "collimated"}, elements, (0, 4.5 + focal, 0), ASIDE)
    x, y = rng.uniform(-0.8, 0.8, (2, 50))
    place, way = np.column_stack([x, y, np.full(50, -2.0)]), np.tile([0.0, 0.0, 1.0], (50, 1))
    for found in landed(scene, waves(scene, 0.0), place, way):
        assert found == pytest.approx(np.tile([[6.0], [5.0]], 50), abs=1e-9)


@pytest.mark.parametrize("source", [SUN, LED], ids=["sun", "led"])
@pytest.mark.parametrize("train", TRAINS)
def test_gradients_of_compiled_walk_reference_and_differences_agree(train, source):
    scene = train(source)
    heights, cells = tensors(waves(scene)), Corners(8, 8, 4)
    rng = np.random.default_rng(2)
    weight = torch.tensor(rng.normal(size=(10, 12)))
    step = torch.tensor(rng.normal(size=scene.optic.net_shape))
    plans = [BeamPlan(scene, cells, dtype=torch.float64, fused=fused) for fused in (True, False)]
    face = scene.optic.designed_face

    def value(plan, by=0.0):
        leaf = (heights[face] + by * step).requires_grad_()
        found = (plan.trace({face: leaf}).flux * weight).sum()
        (gradient,) = torch.autograd.grad(found, leaf)
        return found.item(), gradient

    (one, gradient), (other, expected) = map(value, plans)
    assert one == pytest.approx(other, rel=1e-9)
    assert (gradient - expected).norm() < 1e-7 * expected.norm()
    small = 1e-6
    difference = (value(plans[0], small)[0] - value(plans[0], -small)[0]) / (2 * small)
    assert (gradient * step).sum().item() == pytest.approx(difference, rel=1e-4)


@pytest.mark.parametrize("train", TRAINS)
def test_the_check_finds_the_light_of_the_beams(train):
    """An emitter is turned against the first element of each of these trains but one."""
    near = LED | {"position": [0.1, -0.2, -3.0]}
    scene = train(near)
    heights = waves(scene)
    light = BeamPlan(scene, Corners(48, 48, 128), dtype=torch.float64).trace(tensors(heights))
    tally = None
    for batch in Trace(scene, heights, 200_000, 1).batches(2):
        tally = added(tally, batch) if batch is not None else tally
    parts = {name: flux / tally.emitted for name, flux in tally.lost.items()}
    for name, flux in parts.items():
        assert light.account.lost[name] == pytest.approx(flux, abs=1e-3)
    quarters = tally.flux.reshape(2, 5, 2, 6).sum(axis=(1, 3)) / tally.emitted
    assert light.flux.numpy().reshape(2, 5, 2, 6).sum(axis=(1, 3)) == pytest.approx(
        quarters, rel=0.03
    )
