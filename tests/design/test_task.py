"""The task of a run: what it needs, where it came from, its picture and its notes."""

from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.accounts import result_of
from tests.lamps import PLATE, downlight
from workbench.design.checks import grazed
from workbench.design.run import check_stages, run
from workbench.design.session import KeptRun, Session
from workbench.design.task import begin, origin, with_task
from workbench.errors import Refused
from workbench.messages import Message


def test_a_lamp_that_shines_away_from_the_lens_is_refused(make_scene, tmp_path):
    away = downlight(tmp_path) | {"rotation": [180.0, 0.0, 0.0]}
    scene = make_scene(PLATE | {"source": away})
    with pytest.raises(Refused, match=r"^source: none of its light goes to the lens"):
        check_stages(scene.stage_scenes(), 0, None, {})


def test_a_screen_that_light_grazes_is_stated_with_what_helps(make_scene):
    wall = {
        "version": 2,
        "screen.z": 4.0,
        "screen.center": [0.0, 2.0],
        "lens.half_width": [0.1, 0.1],
    }
    assert grazed(make_scene(wall | {"screen.tilt": [20.0, 0.0]})) is None
    stated = grazed(make_scene(wall | {"screen.tilt": [52.0, 0.0]}))
    assert "from across it" in stated and "turn the screen towards the lens" in stated


POINT = {"kind": "point", "position": [0, 0, -3], "rays": 4096}


AREA = {"kind": "area", "center": [0, 0, -3], "half_width": [0.1, 0.1]}


SUN = {"kind": "collimated", "rays": [64, 64], "angular_diameter": 1.0}


TWO_FACES = {"shape": "freeform", "control_points": [8, 8], "degree": [3, 3]}


@pytest.mark.parametrize(
    ("changes", "beginning"),
    [
        ({}, "collimated light: "),
        ({"run.method": "paper"}, "fused kernels, "),
        ({"source": POINT}, "samples on the exit face, "),
        ({"source": AREA}, "beams run between points "),
        ({"source": SUN}, "its light is blurred over "),
        ({"lens.entrance": TWO_FACES}, "first design: "),
        ({"lens.control_points": "auto"}, "control points: "),
        ({"lens.height_range": None}, "heights within "),
    ],
)
def test_notes_have_their_values_apart(make_scene, changes, beginning):
    scene = make_scene({"lens.control_points": [8, 8], "run.iterations": 1, **changes})
    shots = list(islice(run(scene, np.ones(scene.receiver.pixels[::-1])), 2))
    notes = {note for shot in shots for note in shot.notes}
    assert any(note.startswith(beginning) for note in notes), notes
    assert [note for note in notes if not isinstance(note, Message)] == []


@pytest.fixture
def task(make_scene):
    scene = make_scene()
    n_x, n_y = scene.receiver.pixels
    return Session(scene, np.ones((n_y, n_x)))


@pytest.fixture
def designed(task):
    """A design whose lens is that of its only kept run."""
    result = result_of(np.full(task.scene.optic.net_shape, 0.5), task.target)
    return replace(task, result=result, runs=(KeptRun("Run 1", task.scene, task.target, result),))


def test_a_lens_of_a_run_is_designed_for_the_task_of_the_run(designed):
    assert origin(designed) == "designed for this task"


LETTER = np.array([[255, 255, 0], [255, 0, 0], [255, 0, 0]], dtype=np.uint8)


@pytest.fixture
def image(tmp_path):
    path = tmp_path / "letter.png"
    Image.fromarray(LETTER).save(path)
    return path


@pytest.fixture
def session(make_scene, image):
    return begin(make_scene({"target": {"image": str(image)}}), image.parent)


def edited(session, **target):
    first = session.scene.images[0]
    first = first.model_copy(update={"target": first.target.altered(**target)})
    scene = session.scene.with_images([first])
    return with_task(session, scene, Path(session.scene.image).parent)


def test_the_target_is_drawn_anew_without_the_file(session, image):
    expected = edited(session, blur=1.5, padding=0.1, invert=True).target
    image.unlink()
    found = edited(session, blur=1.5, padding=0.1, invert=True)
    np.testing.assert_array_equal(found.target, expected)
    assert found.picture is session.picture
