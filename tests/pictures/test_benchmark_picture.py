import dataclasses
from io import BytesIO
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from workbench.analysis.benchmark import experiments
from workbench.analysis.benchmark.bounds import BoundedDesign
from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.analysis.benchmark.frontier import Course
from workbench.analysis.benchmark.leds import LedDesign
from workbench.pictures import benchmark
from workbench.pictures.benchmark import page

COURSES = [
    Course("flame", "paper", times=(0.1, 1.0, 10.0), errors=(0.8, 0.5, 0.2)),
    Course(
        "flame", "auto", times=(0.1, 1.0), errors=(0.8, 0.1), own_curve=((0.1, 0.7), (0.5, 0.2))
    ),
    Course("letter", "auto", failure="no light"),
]
TRACED = [SimpleNamespace(scene="one face, point", difference=0.02, noise=0.019)]
BOUNDED = [BoundedDesign("letter", sharp=0.12, bound=0.048, spots=0.052, light=0.049, lens=0.057)]
LIT = [LedDesign("flat, freeform", seconds=16.0, efficiency=0.64, deviation=0.05)]


@pytest.fixture(scope="module")
def designs():
    """One designed lens, and one that was refused."""
    small = {
        "lens": {"control_points": [8, 8]},
        "source": {"rays": [48, 48]},
        "screen": {"pixels": [16, 16]},
        "run": {"iterations": 3},
    }
    example = BenchmarkTask.of("flame-x3", **small)
    design = experiments.design(example, "auto", 5000, lambda case, state: None)
    refused = dataclasses.replace(design, result=None, failure="refused: too bold", error=None)
    return design, refused


@pytest.fixture
def derivative(make_scene):
    scene = make_scene()
    return SimpleNamespace(name="a", scene=scene, map=np.eye(32), balance=1e-9)


@pytest.mark.parametrize(
    ("name", "rows"),
    [
        ("quick", COURSES),
        ("bound", BOUNDED),
        ("led", LIT),
        ("mitsuba", TRACED),
    ],
)
def test_writes_a_png(name, rows):
    file = BytesIO()
    benchmark.draw(name, rows, file)
    with Image.open(file) as picture:
        assert picture.format == "PNG"
        low, high = picture.convert("L").getextrema()
        assert low < 60 and high > 200


def test_the_page_shows_each_experiment(designs, derivative, tmp_path):
    design, refused = designs
    figure = page([derivative, *designs])
    titles = [axes.get_title() for axes in figure.axes]
    assert titles[0] == design.group
    assert sum(title.startswith("height − base") for title in titles) == 1
    texts = [text.get_text() for axes in figure.axes for text in axes.texts]
    assert refused.failure in texts
    over_iterations, over_time = figure.axes[:2]
    for axes, steps in ((over_iterations, [1, 2, 3]), (over_time, design.times[1:])):
        (line,) = axes.lines
        np.testing.assert_array_equal(line.get_xdata(), steps)
        np.testing.assert_array_equal(line.get_ydata(), design.result.losses)
    figure.savefig(tmp_path / "page.png", dpi=30)
