"""Each job makes an ordinary scene; what is not possible is refused where it was asked."""

import math
from pathlib import Path

import numpy as np
import pytest

from workbench.errors import Refused
from workbench.files.scene import read_scene, write_scene
from workbench.jobs import JOBS
from workbench.jobs.lenses import (
    BeamShaper,
    LedRectangle,
    StreetLight,
    SunPlate,
    Torch,
    TorchBeam,
    WallWasher,
)
from workbench.jobs.mirrors import MirrorJob
from workbench.targets import load_target

_ROUNDED = 5e-5  # numbers of a scene have five digits

every_job = pytest.mark.parametrize("kind", JOBS, ids=lambda kind: kind.__name__)


@every_job
def test_the_scene_of_a_job_is_read_back_from_a_scene_file(kind, tmp_path):
    scene = kind().scene()
    write_scene(scene, tmp_path / "job.json")
    assert read_scene(tmp_path / "job.json") == scene


def test_a_refused_size_is_quoted_as_it_was_asked():
    with pytest.raises(Refused, match=r"size: 1e-09 makes the element slimmer .*; at least 0.1$"):
        SunPlate().with_answers({"size": [1e-9, 100.0]})


@pytest.mark.parametrize(
    ("kind", "answers", "field"),
    [
        (SunPlate, {"distance": 3.0}, "distance"),
        (SunPlate, {"distance": 1e13}, "distance"),
        (SunPlate, {"size": [1e-9, 100.0]}, "size"),
        (SunPlate, {"target": {"image": ""}}, "target.image"),
        (Torch, {"lamp_distance": 1e15}, "lamp_distance"),
        (BeamShaper, {"beam_diameter": 0.01}, "beam_diameter"),
        (BeamShaper, {"wavelength": 10600.0}, "wavelength"),
        (LedRectangle, {"thickness": -1.0}, "thickness"),
        (WallWasher, {"wall_distance": 1e13}, "wall_distance"),
    ],
)
def test_an_impossible_answer_is_refused_at_its_question(kind, answers, field):
    with pytest.raises(Refused) as refused:
        kind().with_answers(answers)
    assert refused.value.path.startswith(field)


def test_pixels_are_square_and_fewer_where_the_light_blurs_them():
    fine = SunPlate().with_answers({"image_size": [240.0, 160.0]}).scene()
    coarse = LedRectangle().with_answers({"lamp_size": [4.0, 4.0]}).scene()
    n_x, n_y = fine.receiver.pixels
    assert (n_x, n_y) == (256, round(256 * 160 / 240 / 8) * 8)
    assert max(coarse.receiver.pixels) == 96


def test_a_proposed_lens_is_thicker_where_its_face_has_to_be_steeper():
    near, far = (
        SunPlate().with_answers({"distance": distance}).scene().optic for distance in (300.0, 900.0)
    )
    assert near.base.height > far.base.height > far.min_thickness


@pytest.mark.parametrize("above", [900.0, -300.0, 0.0])
def test_a_lamp_beside_a_wall_sees_the_wall_where_it_is(above):
    job = WallWasher().with_answers({"above": above})
    scene = job.scene()
    height = job.wall_size[1]
    edges = [
        scene.receiver.drawn(scene.optic, np.array(0.0), np.array(v))[1:]
        for v in (-height / 2, height / 2)
    ]
    # Turned so that the wall stands upright, its edges are where the job says.
    aim = math.radians(scene.receiver.tilt[0])
    for (y, z), wanted in zip(edges, (-height / 2, height / 2), strict=True):
        away = z * math.cos(aim) - y * math.sin(aim)
        up = z * math.sin(aim) + y * math.cos(aim)
        assert away == pytest.approx(job.wall_distance, rel=_ROUNDED)
        assert up == pytest.approx(wanted - above, abs=_ROUNDED * job.wall_distance)
    (low_y, low_z), (high_y, high_z) = edges
    assert math.atan2(low_y, low_z) == pytest.approx(-math.atan2(high_y, high_z), rel=_ROUNDED)
    assert max(len(str(number)) for number in scene.receiver.position) <= 7  # fields show them


@pytest.mark.parametrize("aside", [20.0, 45.0, 70.0])
def test_a_mirror_has_its_image_at_the_distance_and_angle_asked_for(aside):
    screen = MirrorJob().with_answers({"aside": aside}).scene().receiver
    x, _, z = screen.position
    assert math.hypot(x, z) == pytest.approx(100.0, rel=_ROUNDED)
    assert math.degrees(math.atan2(x, -z)) == pytest.approx(aside, rel=_ROUNDED)
    assert np.cross(screen.sides[2], screen.position) == pytest.approx(0.0, abs=100 * _ROUNDED)


def test_a_torch_has_the_beam_and_field_angle_asked_for():
    answers = {"beam_angle": 12.0, "field_angle": 30.0, "spill_angle": 60.0, "spill": 2.0}
    scene = TorchBeam().with_answers(answers).scene()
    light, receiver = load_target(scene, Path()), scene.receiver
    n_x, n_y = receiver.pixels
    row = light[n_y // 2 - 1 : n_y // 2 + 1].mean(axis=0)
    degrees, _ = receiver.from_pixels(np.arange(n_x) + 0.5, 0.0)
    for full, level in ((12.0, 0.5), (30.0, 0.1)):
        assert np.interp(full / 2, degrees, row) == pytest.approx(level, abs=0.02)
    assert np.interp(29.0, degrees, row) == pytest.approx(0.02, abs=2e-3)
    assert not row[degrees > 31].any()


@pytest.mark.parametrize(
    ("answers", "path"),
    [
        ({"field_angle": 20.0}, "field_angle"),
        ({"spill_angle": 39.0}, "spill_angle"),
    ],
)
def test_angles_of_a_torch_grow_outwards(answers, path):
    with pytest.raises(Refused) as refused:
        TorchBeam().with_answers(answers)
    assert refused.value.path == path


@pytest.mark.parametrize(
    "kind", [SunPlate, Torch, LedRectangle, WallWasher, StreetLight, MirrorJob]
)
def test_pictures_on_opaque_walls_read_right_from_the_side_of_the_light(kind):
    scene = kind().scene()
    assert scene.target.viewed_from == "front"
    letter = {"builtin": "text", "text": "F"}
    wanted = kind().with_answers({"target": {**letter, "viewed_from": "front"}}).scene()
    behind = kind().with_answers({"target": {**letter, "viewed_from": "back"}}).scene()
    light, mirrored = (load_target(each, Path()) for each in (wanted, behind))
    np.testing.assert_allclose(light, mirrored[:, ::-1], atol=1e-12)
    stem = light.sum(axis=0)  # of the F, which is all bright from top to bottom
    lens = kind is not MirrorJob  # whose light goes on to +z: its viewer sees +x at the left
    assert (stem.argmax() > light.shape[1] / 2) == lens
