"""Elements that the check follows, and the aperture of a bent mirror."""

import numpy as np
import pytest
import torch

from workbench.analysis.tracing.elements import Crossings, TracedRays
from workbench.analysis.tracing.surfaces import FlatFace
from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.scene import Scene

TILTED = {"kind": "collimated", "direction": [20.0, -10.0]}


SCENES = {
    "mirror": {"mirror": {}, "source": TILTED},
    "mirror of an ellipse": {"mirror": {"outline": "ellipse"}, "source": TILTED},
    "mirror beside a point": {
        "mirror": {},
        "source": {"kind": "point", "position": [2.0, 0.0, -3.0]},
    },
    "mirror beside an emitter": {
        "mirror": {},
        "source": {"kind": "area", "center": [2.0, 0.0, -3.0], "half_width": [0.1, 0.1]},
    },
    "narrow beam on a mirror": {
        "mirror": {},
        "source": TILTED | {"profile": {"kind": "gaussian", "radius": 0.05}},
    },
}


def scene_of(parts):
    optic = {"half_width": [1.0, 1.0], "control_points": [8, 8]}
    data = {"mirror": optic | parts["mirror"], "source": parts["source"]}
    return Scene.from_data(
        data
        | {
            "format": "freeform-scene",
            "version": 2,
            "unit": "mm",
            "screen": {"z": -5.0, "half_width": [9.0, 9.0], "pixels": [16, 16]},
            "target": {"builtin": "tophat"},
        }
    )


@pytest.mark.parametrize("parts", SCENES.values(), ids=SCENES)
def test_as_much_light_reaches_a_bent_mirror_in_each_trace(parts):
    scene = scene_of(parts)
    x, y = freeform_nets(scene.optic)["mirror"].positions
    heights = {"mirror": 0.15 * x[:, None] ** 2 - 0.1 * y**2 + 0.1 * x[:, None]}
    run = BeamPlan(scene, (64, 64), dtype=torch.float64)
    account = run.trace({"mirror": torch.as_tensor(heights["mirror"])}).account
    assert min(account.on_screen, *account.lost.values()) > -1e-4
    total = None
    for tally in Trace(scene, heights, 60_000, 0).batches(1):
        total = added(total, tally)
    rays = float(total.flux.sum()) / total.emitted
    missed = total.lost["missed_mirror"] / total.emitted
    assert account.on_screen == pytest.approx(rays, abs=4e-3)
    assert account.lost["missed_mirror"] == pytest.approx(missed, abs=4e-3)


UP = np.array([[0.0, 0.0, 1.0]])


class Lamp:
    """Even light over a square, along the axis."""

    rays, beside = 20_000, 0.0

    def batch(self, number):
        place = np.random.default_rng(number).uniform(-1, 1, (self.rays, 3))
        yield TracedRays(place * [1, 1, 0], UP, np.ones(self.rays))


class RoundFace:
    missed = "beside_the_ring"

    def meet(self, rays):
        inside = np.hypot(*rays.position.T[:2]) < 0.5
        flux = np.where(inside, rays.flux, 0)
        return Crossings(rays.position, UP, flux, float(rays.flux.sum() - flux.sum()))


class GreyFilter:
    def turn(self, rays, crossings):
        lost = {"absorbed": 0.25 * float(crossings.flux.sum())}
        return rays._replace(flux=0.75 * crossings.flux), lost


class Halves:
    """Two pixels: left and right."""

    images, pixels = 1, 2

    def count(self, rays, flux, beside):
        right = rays.position[:, 0] > 0
        flux[0] += [rays.flux[~right].sum(), rays.flux[right].sum()]


def test_elements_of_new_kinds_are_followed_and_their_losses_counted():
    faces = [
        (FlatFace(0.0, Rectangle((1.0, 0.5)), "missed_lens"), GreyFilter()),
        (RoundFace(), GreyFilter()),
    ]
    train = OpticalTrain(Lamp(), faces, Halves())
    tally = Tally(1, 2)
    for rays in train.source.batch(1):
        train.walk(rays, tally)
    assert tally.emitted == Lamp.rays
    disc = np.pi * 0.25 / 4  # of the square
    assert tally.lost == pytest.approx(
        {
            "missed_lens": Lamp.rays / 2,
            "beside_the_ring": 0.75 * Lamp.rays * (0.5 - disc),
            "absorbed": 0.25 * Lamp.rays * (0.5 + 0.75 * disc),
        },
        rel=0.02,
    )
    assert tally.flux.sum() + sum(tally.lost.values()) == pytest.approx(tally.emitted)
    assert tally.flux[0] == pytest.approx(0.75**2 * Lamp.rays * disc / 2, rel=0.05)
