"""Runs that shape both faces of a lens."""

import json
import re
from itertools import islice

import numpy as np
import pytest
import torch

from resources import path
from tests.scenes import changed
from workbench.analysis.validation import validate
from workbench.design.levels import asked_light_of
from workbench.design.limits import HeightLimits, bounded, undesigned
from workbench.design.net import definite
from workbench.design.run import run
from workbench.design.session import Session
from workbench.design.snapshot import History
from workbench.design.transport import behind_flat_entrance, first_of
from workbench.design.wide_image import WideImage
from workbench.files.session import read_session, write_session
from workbench.geometry.faces import FaceArrays
from workbench.interruption import interrupted_when
from workbench.optics.beam_plan import BeamPlan
from workbench.scene import Scene
from workbench.targets import load_target

FREEFORM = {"lens.entrance": {"shape": "freeform"}, "lens.height_range": None}
PAPER = {"method": "paper", "iterations": 4}
NETWORKS = [("none", "zeros"), ("sparse", "uniform"), ("dense", "random")]


@pytest.fixture
def uneven():
    """A rectangle, brighter in one quarter."""
    image = np.zeros((32, 32))
    image[6:26, 10:22] = 1.0
    image[6:16, 16:22] = 0.4
    return image


def assert_apart(scene, heights):
    """The minimal thickness holds everywhere: each face is in the hull of its control points."""
    assert heights["exit"].min() - heights["entrance"].max() >= scene.optic.min_thickness - 1e-12
    limits = HeightLimits.of_faces(bounded(scene))
    assert all(limits[face].hold(z) for face, z in heights.items())


def test_auto_shapes_both_faces_and_keeps_them_apart(make_scene, uneven):
    scene = make_scene({**FREEFORM, "run.iterations": 5})
    shots = list(run(scene, uneven))
    assert shots[-1].state.loss < 0.8 * shots[1].state.loss
    for shot in shots:
        assert_apart(scene, shot.state.heights)
    first, last = shots[1].state.heights, shots[-1].state.heights
    assert list(last) == ["entrance", "exit"]
    assert all(np.abs(last[face] - first[face]).max() > 1e-5 for face in last)


def test_the_first_lens_bends_parallel_light_by_half_at_each_face(make_scene, uneven):
    scene = make_scene(FREEFORM)
    first = first_of(scene, uneven)
    flat = first_of(make_scene({"lens.height_range": None}), uneven)
    alone = np.ptp(flat.heights["exit"])
    for z in first.heights.values():
        assert np.ptp(z) == pytest.approx(alone / 2, rel=0.1)
    assert "% by both faces, " in first.notes[0]
    assert first.notes[0].endswith("it begins with both faces")


def test_a_run_sees_the_error_that_the_check_finds(make_scene, uneven):
    # Both faces spread light, and some of it leaves through the side: the rim cuts cells.
    wide = {**FREEFORM, "screen.half_width": [1.8, 1.8], "screen.z": 9.0, "run.iterations": 12}
    scene = make_scene({**wide, "lens.control_points": [24, 24]})
    *_, last = run(scene, uneven)
    assert last.state.account.lost["left_side"] > 1e-3
    found = validate(scene, uneven, last.state.heights, 20_000, accuracy=2e-3).by_cells
    assert found is not None
    assert last.state.loss == pytest.approx(found.loss, rel=0.05)


def test_the_log_compares_the_lens_with_that_of_one_face_at_the_end(make_scene, uneven):
    history = History()
    scene = make_scene({**FREEFORM, "run.iterations": 200})
    losses = [each.state.loss for each in history.follow(run(scene, uneven))][1:]
    ended = history.result().ended
    found = re.fullmatch(
        r"converged: .*; after (\d+) iterations the error of both faces was ([\d.]+) times that of "
        r"the exit face behind a flat entrance",
        ended,
    )
    assert found is not None
    count = int(found[1])
    flat = behind_flat_entrance(definite(scene, uneven))
    alone = [each.state.loss for each in islice(run(flat, uneven), 1, count + 2)]
    assert float(found[2]) == pytest.approx(min(losses[: count + 1]) / min(alone), rel=0.05)


def test_a_run_is_interrupted_within_its_first_lens(make_scene, uneven):
    asked = 0

    def fourth():
        nonlocal asked
        asked += 1
        return asked == 4

    history = History()
    with interrupted_when(fourth):
        shown = list(history.follow(run(make_scene(FREEFORM), uneven)))
    assert [each.iteration for each in shown] == [0]
    assert asked == 4
    assert history.result().ended == "stopped"


def test_the_log_compares_the_first_lens_with_that_of_one_face(make_scene, uneven):
    *_, last = run(make_scene({**FREEFORM, "run.iterations": 1}), uneven)
    assert any(note.startswith("first lens: ") for note in last.notes)


def test_an_entrance_face_without_room_bends_less(make_scene, uneven):
    narrow = {"shape": "freeform", "height_range": [0, 0.02]}
    scene = make_scene({**FREEFORM, "lens.entrance": narrow})
    first = first_of(scene, uneven)
    assert 0.01 < np.ptp(first.heights["entrance"]) <= 0.02
    assert np.ptp(first.heights["exit"]) > 0.1


@pytest.mark.parametrize("height_range", [None, [-0.3, 0.3]])
@pytest.mark.parametrize("parametrisation, start", NETWORKS)
def test_the_paper_method_shapes_both_faces(
    make_scene, uneven, parametrisation, start, height_range
):
    settings = {**PAPER, "parametrisation": parametrisation, "start": start}
    scene = make_scene({**FREEFORM, "lens.height_range": height_range, "run": settings})
    shots = list(run(scene, uneven))
    assert shots[-1].state.loss < shots[0].state.loss
    assert_apart(scene, shots[-1].state.heights)
    entrance, exit = (
        np.abs(z - shots[0].state.heights[face]).max()
        for face, z in shots[-1].state.heights.items()
    )
    assert entrance > 0.1 * exit > 1e-6


def test_locked_control_points_of_the_entrance_face_stay(make_scene, uneven):
    scene = make_scene({**FREEFORM, "run.iterations": 2})
    start = {
        "entrance": np.full(scene.optic.net_shape, 0.1),
        "exit": np.full(scene.optic.net_shape, 0.5),
    }
    mask = np.zeros(scene.optic.net_shape, dtype=bool)
    mask[:, :4] = True
    *_, last = run(scene, uneven, start, {"entrance": mask})
    moved = last.state.heights["entrance"] != 0.1
    assert not moved[mask].any()
    assert moved[~mask].all()


def test_a_run_goes_on_from_both_faces(make_scene, uneven):
    scene = make_scene({**FREEFORM, "run.iterations": 2})
    *_, last = run(scene, uneven)
    first, *_ = run(scene, uneven, last.state.heights)
    for face, z in last.state.heights.items():
        np.testing.assert_array_equal(first.state.heights[face], z)


def test_sessions_keep_the_entrance_face_and_its_locks(make_scene, uneven, tmp_path):
    scene = make_scene(
        {**FREEFORM, "lens.entrance": {"shape": "freeform", "control_points": [7, 9]}}
    )
    start = undesigned(scene.optic)
    mask = np.arange(63).reshape(7, 9) % 5 == 0
    session = Session(scene, uneven, start=start, locked=FaceArrays({"entrance": mask}))
    write_session(session, tmp_path / "two.freeform")
    again = read_session(tmp_path / "two.freeform")
    assert again.start == start
    assert again.locked == session.locked
    assert again.scene == scene


def test_a_lens_becomes_two_faced_and_one_faced_again(make_scene, uneven):
    flat = make_scene({"lens.height_range": None})
    curved = np.linspace(0.4, 0.6, 120).reshape(12, 10)
    session = Session(flat, uneven, start=FaceArrays({"exit": curved}))
    two = session.with_scene(make_scene(FREEFORM), uneven)
    assert list(two.start) == ["entrance", "exit"]
    np.testing.assert_array_equal(two.start["exit"], curved)
    assert np.ptp(two.start["entrance"]) == 0
    one = two.with_scene(flat, uneven)
    assert list(one.start) == ["exit"]
    np.testing.assert_array_equal(one.start["exit"], curved)


def test_another_entrance_net_carries_the_face(make_scene, uneven):
    def scene(count):
        return Scene.from_data(make_scene({**FREEFORM, "lens.entrance": {**_net(count)}}).to_data())

    coarse = scene(8)
    curved = 0.1 + 0.05 * np.random.default_rng(2).random((8, 8))
    start = FaceArrays({"entrance": curved, "exit": np.full((12, 10), 0.5)})
    session = Session(coarse, uneven, start=start)
    finer = session.with_scene(scene(13), uneven)
    assert finer.start["entrance"].shape == (13, 13)
    again = finer.with_scene(coarse, uneven)
    np.testing.assert_allclose(again.start["entrance"], curved, atol=1e-12)


def _net(count):
    return {"shape": "freeform", "control_points": [count, count]}


def test_the_entrance_face_keeps_light_of_a_near_point_from_the_side(make_scene):
    near = {
        "source": {"kind": "point", "position": [0, 0, -0.56], "rays": 1000},
        "screen.z": 10.0,
        "screen.half_width": [4, 4],
        "lens.outline": "ellipse",
        "lens.height_range": None,
        "lens.base": {"shape": "flat", "height": 0.12},
        "lens.max_thickness": 1.8,
        "lens.min_thickness": 0.02,
        "run.iterations": 3,
        "version": 2,
    }
    disc = (np.hypot(*np.meshgrid(np.linspace(-1, 1, 32), np.linspace(-1, 1, 32))) < 0.8) * 1.0
    wide = {"shape": "freeform", "height_range": [0, 0.48]}
    one, two = (
        list(run(make_scene({**near, "lens.entrance": each}), disc))[-1].state.account
        for each in ({"shape": "flat"}, wide)
    )
    share_one, share_two = (
        each.lost["left_side"] / (1 - each.lost["missed_lens"]) for each in (one, two)
    )
    assert share_two < 0.45 * share_one


def test_near_an_led_two_faces_make_a_better_image_of_more_light_than_one():
    example = json.loads(path("examples", "led-dome.json").read_text())
    small = {
        "lens.control_points": [16, 16],
        "screen.pixels": [24, 24],
        "run.iterations": 20,
        "target": {"builtin": "tophat"},
    }

    def verified(changes):
        scene = Scene.from_data(changed({**small, **changes}, example))
        target = load_target(scene, path("examples"))
        best = [shot for shot in run(scene, target) if shot.best][-1]
        return validate(scene, target, best.state.heights, rays=300_000)

    two, one = verified({}), verified({"lens.entrance": {"shape": "flat"}})
    (_, two_at_most), (one_at_least, _) = (
        each.relative_l2_corrected_interval for each in (two, one)
    )
    assert two_at_most < one_at_least / 1.5
    assert two.efficiency > one.efficiency


def test_two_faces_close_to_a_source_are_asked_for_more_light_than_the_first_lens_sends(make_scene):
    near = make_scene({**FREEFORM, "source": {"kind": "point", "position": [0, 0, -0.5]}})
    far = make_scene({**FREEFORM, "source": {"kind": "point", "position": [0, 0, -4.0]}})
    heights = {face: torch.tensor(z) for face, z in undesigned(bounded(near)).items()}
    arrived = BeamPlan(near, (128, 128)).trace(heights).account.arrived
    asked = asked_light_of(near, heights)
    assert asked > 1.01 * arrived
    assert asked_light_of(far, heights) is None
    assert asked_light_of(near, {"exit": heights["exit"]}) is None
    target = np.ones((32, 32))
    least, more = (
        WideImage(near, target, (32, 32), (1.0, 1.0), asked_light=light).compare(heights)[0]
        for light in (arrived, 2 * arrived)
    )
    # Compared with twice the light, an image is half as bright: what it lacks is the wanted one.
    assert (least - 2 * more).norm().item() == pytest.approx(1, abs=1e-5)
