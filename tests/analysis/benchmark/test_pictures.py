"""The benchmark of real pictures."""

import io
import os

import numpy as np
import pytest
from PIL import Image

from resources import pictures
from resources.pictures import PICTURES, picture
from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.analysis.benchmark.frontier import TracedError, verified
from workbench.analysis.benchmark.machine import FreshRun
from workbench.analysis.benchmark.names import Settings
from workbench.analysis.benchmark.pictures import PictureDesign, designs, tables
from workbench.analysis.metrics import relative_l2
from workbench.errors import Refused
from workbench.pictures.benchmark import draw

GREYS = (
    *(115.5, 111.5, 129.1, 117.4, 96.8, 96.7, 160.1, 196.2, 112.2, 174.6),  # astronaut to page
    *(31.7, 126.8, 19.6, 90.5, 67.2),  # phantom to rocket
    *(20.0, 36.1, 127.5, 28.2, 47.7, 118.4),  # drawn
)
"""Mean grey values of the pictures at 64 pixels a side; figures of other pictures differ."""


def test_pictures_stay_the_same():
    for name, grey in zip(PICTURES, GREYS, strict=True):
        once, again = (np.asarray(picture(name, 64)) for _ in range(2))
        np.testing.assert_array_equal(once, again)
        assert once.mean() == pytest.approx(grey, abs=0.3), name


def test_a_photograph_without_its_package_is_refused(monkeypatch, progress):
    monkeypatch.setattr(pictures, "find_spec", lambda name: None)
    with pytest.raises(Refused, match=r"^camera: .* pip install '.*\[pictures\]'"):
        next(designs(Settings(only=("hello", "camera")), progress))
    with pytest.raises(Refused, match=r"^cat: is no picture; there are astronaut, "):
        next(designs(Settings(only=("cat",)), progress))
    assert progress.lines == []


def test_median_and_worst_are_those_of_the_finished_designs(rng):
    target = rng.random((8, 16))

    def row(name, error, seconds, noise):
        own = target + noise
        run = FreshRun(seconds, seconds, 10**8, 0.5, 4, np.zeros((5, 6)), own)
        return PictureDesign(name, target, run, TracedError(error, 0.001, 0.9, target))

    figures = {"a": (0.01, 8.0), "b": (0.04, 2.0), "c": (0.02, 1.0), "d": (0.03, 4.0)}
    rows = [row(name, *each, 0.02 * rng.random((8, 16))) for name, each in figures.items()]
    rows.insert(1, PictureDesign("e", target, failure="no light"))
    each, summary = tables(rows)
    assert [row["scene"] for row in each.to_data()] == ["a", "e", "b", "c", "d"]
    assert each.to_data()[1] | {"failure": "no light", "error": None} == each.to_data()[1]
    median, worst = summary.to_data()
    assert (median["error"], worst["error"]) == (0.025, 0.04)
    assert (median["seconds"], worst["seconds"]) == (3.0, 8.0)
    assert (median["yardsticks"], worst["yardsticks"]) == (6.0, 16.0)
    off = [abs(row.own / row.error - 1) for row in rows if row.run]
    assert worst["own_off_by"] == max(off)
    assert "4 of 5 pictures" in summary.to_markdown()
    assert "| e | – |" in each.to_markdown() and "16 × 8 pixels" in each.to_markdown()


def test_one_picture_from_end_to_end(progress):
    settings = Settings(iterations=2, pixels=32, only=("hello",))
    (found,) = designs(settings, progress)
    task = BenchmarkTask.picture("hello", 32)
    run = found.run
    assert found.failure == "" and found.iterations == 2
    assert run.heights.shape == task.scene.optic.net_shape
    assert found.error == verified(task, run.heights).error < 0.5
    assert found.own == relative_l2(run.irradiance, task.target)
    assert found.own_off_by < 0.1
    assert run.seconds > 0.1 and run.yardsticks == run.seconds / run.yardstick
    if os.path.exists("/proc/self/status"):
        assert 50e6 < run.memory < 4e9 and run.processor > 0.1
    assert progress.lines[-1] == ("hello", "verifying")
    file = io.BytesIO()
    draw("pictures", [found, PictureDesign("dark", task.target, failure="no light")], file)
    with Image.open(file) as gallery:
        assert gallery.format == "PNG"
        colours = np.asarray(gallery.convert("RGB")).astype(int)
    red, _, blue = np.moveaxis(colours, -1, 0)
    assert (red > blue + 100).any() and (blue > red + 100).any()  # too much light, too little
