"""First lenses that need deflections near the critical angle, and what is said of them."""

import math

import numpy as np
import pytest

from workbench.analysis.validation import validate
from workbench.design.bounds import Bounds
from workbench.design.run import run
from workbench.design.transport import first_design
from workbench.design.transport.entrance import out_of_reach
from workbench.design.transport.turning import Turning
from workbench.geometry.reach import largest_turn
from workbench.scene import CustomIndex, Scene
from workbench.targets import load_target

PLANE, HOLLOW = {"shape": "plane"}, {"shape": "conic", "radius": -40.0}
FREEFORM = {"shape": "bspline"}
LED = {"kind": "area", "half_width": [1.0, 1.0], "position": [0, 0, -10]}
POINT = {"kind": "point", "position": [0, 0, -12]}


def _steep(front=PLANE, source=LED, half=15.0, wide=250.0, high=100.0):
    """A lens close to its source, for a rectangle at 100 mm."""
    scene = Scene.from_data(
        {
            "version": 3,
            "unit": "mm",
            "source": source,
            "elements": [
                {
                    "kind": "lens",
                    "name": "lens",
                    "half_width": [half, half],
                    "material": "PMMA",
                    "thickness": 6,
                    "min_thickness": 1,
                    "faces": [front, {"shape": "bspline", "control_points": [24, 24]}],
                }
            ],
            "images": [
                {
                    "receiver": {
                        "kind": "plane",
                        "position": [0, 0, 100],
                        "half_width": [1.1 * wide, 1.1 * high],
                        "pixels": [50, 20],
                    },
                    "target": {"builtin": "rectangle", "width": 0.9, "height": 0.9},
                }
            ],
        }
    )
    return scene, load_target(scene, None)


@pytest.mark.parametrize("index", [1.3, 1.49, 1.8])
def test_directions_within_reach_stay_and_others_come_to_the_rim_of_the_cone(rng, index):
    scene, _ = _steep()
    optic = scene.optic.model_copy(update={"material": CustomIndex(index=index)})
    turning = Turning.at_exit(optic)
    a, b = (each / np.linalg.norm(each, axis=0) for each in rng.normal(size=(2, 3, 500)))
    spread = rng.uniform(0, 0.2, 500)
    found = np.array(turning.reached(tuple(a), tuple(b), spread))
    cosine = (a * found).sum(axis=0)
    most = turning.largest(spread)
    within = (a * b).sum(axis=0) >= np.cos(most)
    assert 0 < within.sum() < 500 and (found[:, within] == b[:, within]).all()
    np.testing.assert_allclose(np.linalg.norm(found, axis=0), 1)
    np.testing.assert_allclose(cosine[~within], np.cos(most[~within]))
    assert (most < largest_turn(index)).all()
    # No direction of the cone is nearer: it lies on the great circle from a to b.
    assert np.abs(np.einsum("ij,ij->j", found, np.cross(a, b, axis=0))).max() < 1e-12
    # What is deflected by the most still passes, also from the rim of the source.
    assert (turning.passing(most * 0.999) > 0.7 * turning.passing(np.zeros(1))).all()


@pytest.mark.parametrize("front", [PLANE, HOLLOW, FREEFORM], ids=["plane", "hollow", "freeform"])
@pytest.mark.parametrize("source", [LED, POINT], ids=["led", "point"])
def test_the_first_lens_of_a_steep_scene_reflects_next_to_no_light_totally(front, source):
    scene, target = _steep(front, source)
    bounds = Bounds(scene, target)
    heights = {face: bounds.limits[face].nearest(z) for face, z in bounds.first.items()}
    account = validate(scene, target, heights, 100_000).account
    assert account.lost["total_reflection"] < 0.03
    assert account.lost["off_screen"] < 0.02


def test_a_run_does_not_throw_light_into_total_reflection():
    scene, target = _steep()
    shots = [shot for shot, _ in zip(run(scene, target), range(25), strict=False)]
    first, best = shots[1].state, [shot for shot in shots if shot.best][-1].state
    assert best.loss < 0.95 * first.loss
    assert best.account.on_screen > 0.9 * first.account.on_screen
    assert any("it would reflect" in note for note in shots[0].notes)


def test_what_is_out_of_reach_is_stated_with_place_cause_and_cure():
    found = out_of_reach(*_steep())
    assert "left and right sides of the screen" in found
    assert f"{math.degrees(largest_turn(1.4918)):.0f}: it would reflect" in found
    assert "% with a plane entrance face" in found and "% with a freeform one" in found
    assert "Set elements[0].faces[0].shape" in found
    assert "top and bottom" in out_of_reach(*_steep(wide=100.0, high=250.0))
    # Two freeform faces share the deflection, and a narrow target needs little.
    assert out_of_reach(*_steep(FREEFORM)) is None
    assert out_of_reach(*_steep(wide=60.0, high=60.0)) is None


def test_a_scene_that_needs_nothing_has_the_same_first_lens_to_the_last_bit(monkeypatch):
    for front in (PLANE, FREEFORM):
        scene, target = _steep(front, LED | {"position": [0, 0, -40]}, wide=40.0, high=40.0)
        found = first_design(scene, target).heights
        with monkeypatch.context() as patch:
            patch.setattr(Turning, "reached", lambda self, coming, going, spread=0.0: going)
            plain = first_design(scene, target).heights
        assert all(np.array_equal(z, plain[face]) for face, z in found.items())
