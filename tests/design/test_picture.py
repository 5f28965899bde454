"""The picture of a target that a session keeps, and when its file is read."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from workbench.design.picture import changed_on_disk
from workbench.design.task import begin, with_file, with_task
from workbench.scene import Scene

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
    data = session.scene.to_data()
    data["target"] |= target
    return with_task(session, Scene.from_data(data), Path(session.scene.image).parent)


def test_the_target_is_drawn_anew_without_the_file(session, image):
    expected = edited(session, blur=1.5, padding=0.1, invert=True).target
    image.unlink()
    found = edited(session, blur=1.5, padding=0.1, invert=True)
    np.testing.assert_array_equal(found.target, expected)
    assert found.picture is session.picture


def test_the_kept_picture_counts_until_the_file_is_read_again(session, image):
    Image.fromarray(255 - LETTER).save(image)
    assert changed_on_disk(session.scene, session.picture)
    kept = edited(session, padding=0.1)
    assert kept.picture is session.picture
    again = with_file(kept, image.parent)
    assert again.picture == image.read_bytes() and again.scene == kept.scene
    assert not changed_on_disk(again.scene, again.picture)
    assert np.abs(again.target - kept.target).max() > 0.9
