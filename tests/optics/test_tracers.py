"""Which compiled tracer serves a path, and that the walk serves all others."""

import numpy as np
import pytest
import torch

from tests.optics.kernels.twins import account
from tests.optics.points import GRID, POINT, smooth
from tests.optics.rays import Given, bundle
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Passed
from workbench.optics.kernels.point import FusedPointRays
from workbench.optics.path import Path
from workbench.optics.rays import RayBundle
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.surfaces import Plane
from workbench.optics.tracers import Tracers
from workbench.optics.train.compiled import CompiledTrain

COLLIMATED = {"kind": "collimated", "rays": [40, 30]}
MESH = POINT | {"intersection": {"method": "mesh"}}


class Unchanged:
    """An interface that lets all light pass straight on."""

    def turn(self, rays, meeting):
        flux = torch.where(meeting.met, rays.flux, 0.0)
        return Passed(RayBundle(meeting.position, rays.direction, flux, meeting.met), {})


def path_of(scene, samples=None):
    return Path.of(scene, ControlNet.of(scene.optic), torch.float64, samples=samples)


def changed(path, emitter=None, steps=None):
    return Path(
        emitter or path.emitter,
        steps or path.steps,
        path.receiver,
        path.datum,
        path.outline,
        0,
        path.dtype,
    )


def kind(path):
    return Tracers(path, (False, False)).kind


@pytest.mark.parametrize(
    ("source", "samples", "expected"),
    [
        (COLLIMATED, None, CompiledTrain),
        (COLLIMATED, (20, 20), CompiledTrain),
        (POINT, None, FusedPointRays),
        (GRID, None, FusedPointRays),
        (MESH, None, None),
        (POINT, Corners(20, 20), CompiledTrain),
        (GRID, Corners(20, 20), CompiledTrain),
        (MESH, Corners(20, 20), None),
    ],
)
def test_the_compiled_tracer_follows_from_the_elements(make_scene, source, samples, expected):
    assert kind(path_of(make_scene({"source": source}), samples)) is expected


@pytest.mark.parametrize("source", [COLLIMATED, POINT], ids=["collimated", "point"])
def test_no_kernel_stands_for_an_interface_that_it_does_not_know(make_scene, source):
    scene = make_scene({"source": source})
    path = path_of(scene)
    entrance, exit_face = path.steps
    window = changed(path, steps=[entrance, exit_face._replace(interface=Unchanged())])
    assert kind(window) is None
    # Without refraction at the exit, light keeps its direction: more of it passes the screen by.
    light = Reference(window).image({"exit": smooth(scene)}, scene.filter)
    assert light.account.lost["fresnel_exit"] == 0
    assert sum(account(light).values()) == pytest.approx(2, abs=1e-12)  # and once as emitted


def test_another_step_before_the_exit_face_needs_no_other_kernel(make_scene):
    scene = make_scene({"source": POINT})
    path = path_of(scene)
    entrance, exit_face = path.steps
    pane = entrance._replace(
        surface=Plane("pane", 0.1, Rectangle((0.5, 0.5))), interface=Unchanged()
    )
    stopped = changed(path, steps=[entrance, pane, exit_face])
    assert kind(stopped) is FusedPointRays
    lights = [
        tracer(stopped).image({"exit": smooth(scene)}, scene.filter)
        for tracer in (FusedPointRays, Reference)
    ]
    assert torch.allclose(lights[0].flux, lights[1].flux, rtol=0, atol=1e-12)
    assert account(lights[0]) == pytest.approx(account(lights[1]), abs=1e-12)
    assert lights[0].account.lost["missed_lens"] > path.lost["missed_lens"].item() + 0.1


def test_light_of_an_emitter_that_no_kernel_knows_is_traced_by_the_one_that_takes_any_rays(
    make_scene, rng
):
    scene = make_scene({"source": COLLIMATED})
    places = np.column_stack([*rng.uniform(-0.7, 0.7, (2, 500)), np.full(500, -1.0)])
    tilted = np.array([0.1, -0.05, 1.0]) / np.linalg.norm([0.1, -0.05, 1.0])
    rays = bundle(places, np.tile(tilted, (500, 1)), np.full(500, 1 / 500))
    path = changed(path_of(scene), emitter=Given(rays))
    assert kind(path) is FusedPointRays
    lights = [
        tracer(path).image({"exit": smooth(scene)}, scene.filter)
        for tracer in (FusedPointRays, Reference)
    ]
    assert torch.allclose(lights[0].flux, lights[1].flux, rtol=0, atol=1e-12)
    assert account(lights[0]) == pytest.approx(account(lights[1]), abs=1e-12)


def test_the_compiled_train_refuses_a_path_whose_face_is_not_sampled(make_scene):
    path = path_of(make_scene({"source": POINT}))
    assert not CompiledTrain.matches(path)
    with pytest.raises(TypeError, match="not sampled"):
        CompiledTrain(path)


class Measuring(Unchanged):
    """An interface that keeps how far rays came."""

    def turn(self, rays, meeting):
        ways = zip(meeting.position, rays.position, strict=True)
        self.way = sum((there - here).square() for there, here in ways).sqrt()
        return super().turn(rays, meeting)


def test_samples_of_the_face_come_from_where_their_light_entered(make_scene):
    """So that what depends on the way in the glass is right for them, too."""
    scene = make_scene({"source": POINT | {"position": [0, 0, -2.0]}})
    path, measuring = path_of(scene, Corners(30, 30)), Measuring()
    entrance, exit_face = path.steps
    steps = [entrance, exit_face._replace(interface=measuring)]
    Reference(changed(path, steps=steps)).arrival(
        {"exit": torch.full((12, 10), 0.5, dtype=torch.float64)}
    )
    # Straight on the axis, and refracted where light enters at the radius e: e + d tan = ρ.
    assert measuring.way[15, 15].item() == pytest.approx(0.5)
    x = 1.0
    sine = measuring.way[30, 15].item()
    slope = np.sqrt(sine**2 - 0.25) / 0.5
    entered = x - 0.5 * slope
    outside = np.sin(np.arctan2(entered, 2.0))
    assert np.sin(np.arctan(slope)) == pytest.approx(outside / scene.optic.index, rel=1e-9)
