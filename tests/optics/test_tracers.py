"""Which compiled tracer serves a path, and that the walk serves all others."""

import numpy as np
import pytest
import torch

from tests.optics.kernels.twins import account
from tests.optics.points import GRID, POINT, smooth
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Passed, Refraction
from workbench.optics.path import Path
from workbench.optics.plan import Tracers
from workbench.optics.rays import RayBundle
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners

COLLIMATED = {"kind": "collimated", "rays": [40, 30]}
MESH = POINT | {"intersection": {"method": "mesh"}}


class Unchanged:
    """An interface that lets all light pass straight on."""

    compiled = False

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


def is_compiled(path):
    return Tracers(path, (False, False)).compiled == "train"


@pytest.mark.parametrize(
    ("source", "samples", "expected"),
    [
        (COLLIMATED, None, True),
        (COLLIMATED, (20, 20), True),
        (POINT, None, True),
        (GRID, None, True),
        (MESH, None, False),
        (POINT, Corners(20, 20), True),
        (GRID, Corners(20, 20), True),
        (MESH, Corners(20, 20), False),
    ],
)
def test_whether_the_train_is_compiled_follows_from_the_elements(
    make_scene, source, samples, expected
):
    assert is_compiled(path_of(make_scene({"source": source}), samples)) is expected


@pytest.mark.parametrize("source", [COLLIMATED, POINT], ids=["collimated", "point"])
def test_no_kernel_stands_for_an_interface_that_it_does_not_know(make_scene, source):
    scene = make_scene({"source": source})
    path = path_of(scene)
    entrance, exit_face = path.steps
    window = changed(path, steps=[entrance, exit_face._replace(interface=Unchanged())])
    assert not is_compiled(window)
    # Without refraction at the exit, light keeps its direction: more of it passes the screen by.
    light = Reference(window).image({"lens.back": smooth(scene)}, scene.filter)
    assert light.account.lost["fresnel_exit"] == 0
    assert sum(account(light).values()) == pytest.approx(2, abs=1e-12)  # and once as emitted


class Half:
    """A law of a face that refracts half of all light."""

    def __init__(self, ratio):
        self.ratio = ratio

    def at(self, cos_in, cos_out):
        return 0.5 * (cos_in + cos_out) / (cos_in + cos_out)


@pytest.mark.parametrize("source", [COLLIMATED, POINT], ids=["collimated", "point"])
def test_a_law_that_kernels_do_not_know_is_passed_in_torch(make_scene, source):
    """Before the freeform face light passes it once, and kernels go on from there."""
    scene = make_scene({"source": source})
    path = path_of(scene, Corners(40, 40))
    entrance, exit_face = path.steps
    for number, compiled in enumerate((True, False)):
        step = path.steps[number]
        own = Refraction(Half(step.interface.law.ratio), step.interface.reflected)
        steps = [entrance, exit_face]
        steps[number] = step._replace(interface=own)
        found = changed(path, steps=steps)
        assert is_compiled(found) is compiled
        light = Reference(found).arrival({"lens.back": smooth(scene)})
        half = (1 - light.lost["missed_lens"].sum()) / 2 if compiled else light.rays.flux.sum()
        assert float(light.lost[step.interface.reflected].sum()) == pytest.approx(float(half))


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
        {"lens.back": torch.full((12, 10), 0.5, dtype=torch.float64)}
    )
    # Straight on the axis, and refracted where light enters at the radius e: e + d tan = ρ.
    assert measuring.way[15, 15].item() == pytest.approx(0.5)
    x = 1.0
    sine = measuring.way[30, 15].item()
    slope = np.sqrt(sine**2 - 0.25) / 0.5
    entered = x - 0.5 * slope
    outside = np.sin(np.arctan2(entered, 2.0))
    assert np.sin(np.arctan(slope)) == pytest.approx(outside / scene.optic.index, rel=1e-9)
