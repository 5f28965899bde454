"""Video of a run."""

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from workbench.errors import Refused
from workbench.pictures.images import full_scale, to_colours
from workbench.pictures.video import ENDINGS, Video, check_video


@pytest.fixture
def scene(make_scene):
    return make_scene({"screen.half_width": [2.0, 1.0], "screen.pixels": [8, 4]})


@pytest.fixture
def target():
    return np.arange(1.0, 33.0).reshape(4, 8)


def in_words(texts):
    def caption(iteration, error):
        texts.append((iteration, error))
        return f"iteration {iteration}"

    return caption


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_video_shows_image_after_image_and_stays_at_the_last(scene, target, ending):
    texts = []
    video = Video(scene, target, in_words(texts), "inferno")
    lights = [target[::-1], target**0.5, target / target.sum()]
    for iteration, light in enumerate(lights):
        video.add(light, iteration)
    with io.BytesIO() as file:
        video.write(file, ending)
        with Image.open(file, formats=[ENDINGS[ending]]) as found:
            assert found.n_frames == 3 and found.size == (480, 240 + 26)
            found.seek(2)
            last = np.asarray(found.convert("RGB")).astype(int)
            assert found.info["duration"] == 2000
    top = full_scale(scene, target, scene.receiver.total(lights[2]))
    wanted = to_colours(lights[2], top, "inferno").astype(int)
    assert abs(last[30:240:60, 30::60] - wanted).max() < 40  # of 255; GIF has 256 colours
    assert np.ptp(last[240:]) > 100  # the caption
    assert [iteration for iteration, _ in texts] == [0, 1, 2]
    errors = [error for _, error in texts]
    assert errors[0] > errors[1] > errors[2] == pytest.approx(0, abs=1e-12)


def test_a_long_run_has_few_images_with_its_first_and_its_last(scene, target):
    texts = []
    video = Video(scene, target, in_words(texts))
    for iteration in range(401):
        video.add(np.roll(target, iteration, 1), iteration)
    with io.BytesIO() as file:
        video.write(file, ".gif")
        with Image.open(file) as found:
            assert 60 < found.n_frames <= 128
    kept = [iteration for iteration, _ in video._images]
    assert kept[0] == 0 and kept[-1] == 400
    gaps = np.diff(kept[:-1])
    assert gaps.max() <= 2 * gaps.min()


def test_other_endings_are_refused():
    with pytest.raises(Refused, match=r"\.gif, \.webp, \.apng"):
        check_video(Path("run.mp4"))
