"""Runs that shape both faces of a lens."""

import numpy as np
import pytest

from resources import path
from workbench.analysis.validation import validate
from workbench.design.limits import HeightLimits, bounded
from workbench.design.run import run
from workbench.design.transport import first_of
from workbench.scene import Scene
from workbench.scene.paths import with_values
from workbench.targets import load_target

FREEFORM = {"lens.entrance": {"shape": "freeform"}, "lens.height_range": None}


@pytest.fixture
def uneven():
    """A rectangle, brighter in one quarter."""
    image = np.zeros((32, 32))
    image[6:26, 10:22] = 1.0
    image[6:16, 16:22] = 0.4
    return image


def assert_apart(scene, heights):
    """The minimal thickness holds everywhere: each face is in the hull of its control points."""
    assert (
        heights["lens.back"].min() - heights["lens.front"].max()
        >= scene.optic.min_thickness - 1e-12
    )
    limits = HeightLimits.of_faces(bounded(scene))
    assert all(limits[face].hold(z) for face, z in heights.items())


def test_auto_shapes_both_faces_and_keeps_them_apart(make_scene, uneven):
    scene = make_scene({**FREEFORM, "run.iterations": 5})
    shots = list(run(scene, uneven))
    assert shots[-1].state.loss < 0.8 * shots[1].state.loss
    for shot in shots:
        assert_apart(scene, shot.state.heights)
    first, last = shots[1].state.heights, shots[-1].state.heights
    assert list(last) == ["lens.front", "lens.back"]
    assert all(np.abs(last[face] - first[face]).max() > 1e-5 for face in last)


def test_the_first_lens_bends_parallel_light_by_half_at_each_face(make_scene, uneven):
    scene = make_scene(FREEFORM)
    first = first_of(scene, uneven)
    flat = first_of(make_scene({"lens.height_range": None}), uneven)
    alone = np.ptp(flat.heights["lens.back"])
    for z in first.heights.values():
        assert np.ptp(z) == pytest.approx(alone / 2, rel=0.1)
    assert "% by both faces, " in first.notes[0]
    assert first.notes[0].endswith("it begins with both faces")


def test_locked_control_points_of_the_entrance_face_stay(make_scene, uneven):
    scene = make_scene({**FREEFORM, "run.iterations": 2})
    start = {
        "lens.front": np.full(scene.optic.net_shape, 0.1),
        "lens.back": np.full(scene.optic.net_shape, 0.5),
    }
    mask = np.zeros(scene.optic.net_shape, dtype=bool)
    mask[:, :4] = True
    *_, last = run(scene, uneven, start, {"lens.front": mask})
    moved = last.state.heights["lens.front"] != 0.1
    assert not moved[mask].any()
    assert moved[~mask].all()


def test_near_an_led_two_faces_make_a_better_image_of_more_light_than_one():
    example = Scene.from_json(path("examples", "led-dome.json").read_text())
    small = {
        "lens.back.control_points": 16,
        "images[0].receiver.pixels": 24,
        "run.iterations": 12,
        "images[0].target": {"builtin": "tophat"},
    }

    def verified(changes):
        scene = with_values(example, {**small, **changes})
        target = load_target(scene, path("examples"))
        best = [shot for shot in run(scene, target) if shot.best][-1]
        return validate(scene, target, best.state.heights, rays=200_000)

    two, one = verified({}), verified({"lens.faces[0]": {"shape": "plane"}})
    (_, two_at_most), (one_at_least, _) = (
        each.relative_l2_corrected_interval for each in (two, one)
    )
    assert two_at_most < one_at_least / 1.5
    assert two.efficiency > one.efficiency
