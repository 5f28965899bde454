"""Pages of pictures, and pictures written to files."""

import dataclasses
import io
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

from tests.accounts import account_of
from workbench.analysis.benchmark import experiments
from workbench.analysis.benchmark.bounds import BoundedDesign
from workbench.analysis.benchmark.examples import BenchmarkTask
from workbench.analysis.benchmark.frontier import Course
from workbench.analysis.benchmark.leds import LedDesign
from workbench.design.lens_state import LensState
from workbench.design.run import run
from workbench.design.session import KeptRun
from workbench.design.snapshot import History, Result
from workbench.design.task import begin
from workbench.files.session import Session
from workbench.geometry.faces import FaceArrays
from workbench.pictures import PICTURES, benchmark
from workbench.pictures.benchmark import page
from workbench.pictures.comparison import Comparison
from workbench.targets import load_target

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
        "lens.back.control_points": 8,
        "source.rays": 48,
        "images[0].receiver.pixels": 16,
        "run.iterations": 3,
    }
    example = BenchmarkTask.of("flame-x3", changes=small)
    design = experiments.design(example, "auto", 5000, lambda case, state: None)
    refused = dataclasses.replace(design, result=None, failure="refused: too bold", error=None)
    return design, refused


@pytest.fixture
def derivative(make_scene):
    scene = make_scene()
    return SimpleNamespace(name="a", scene=scene, map=np.eye(32), balance=1e-9)


@pytest.mark.parametrize(
    ("name", "rows"), [("quick", COURSES), ("bound", BOUNDED), ("led", LIT), ("mitsuba", TRACED)]
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


@pytest.fixture
def kept(make_scene):
    """Makes runs of a scene with some fields changed, whose light is given."""

    def make(name, light, changes=None):
        session = begin(make_scene(changes), Path())
        n_x, n_y = session.scene.receiver.pixels
        state = LensState(
            heights=FaceArrays({"lens.back": np.full(session.scene.optic.net_shape, 0.5)}),
            irradiance=np.broadcast_to(light, (n_y, n_x)).copy(),
            loss=0.1,
            account=account_of(1.0, 0.92, 0.0, 0.0, 0.0, 0.0, 0.04, 0.04),
        )
        result = Result(state, losses=np.array([0.2, 0.1]), seconds=1.0)
        return KeptRun(name, session.scene, session.target, result)

    return make


def images(figure):
    return [axes.images[0] for axes in figure.axes if axes.images]


def test_both_are_drawn_on_one_scale_and_subtracted(kept):
    figure = Figure()
    drawn = Comparison(figure, (kept("dim", 0.1), kept("bright", 0.3)))
    one, other, difference = images(figure)
    assert one.get_clim() == other.get_clim()
    np.testing.assert_allclose(difference.get_array(), 0.8)  # of a screen of 4 cm²
    assert difference.get_clim() == pytest.approx((-1.0, 1.0))
    names = [axes.get_title() for axes in figure.axes]
    assert names[:4] == ["dim", "bright", "Second minus first", "Loss"]
    losses = figure.axes[3].lines
    assert [line.get_label() for line in losses] == ["dim", "bright"]
    assert drawn.in_words(figure.axes[2], 0.1, 0.1) == "0.4 → 1.2 × mean at x = 0.1 cm, y = 0.1 cm"


def test_lines_of_equal_light_are_drawn_over_lighting_alone(kept):
    y, x = np.mgrid[1:-1:32j, -1:1:32j]
    spot = 1 - np.hypot(x, y) / 2
    lamp = {"kind": "grid", "center": [0, 0, -5], "half_width": [0.1, 0.1], "points": [3, 3]}
    drawn = Figure()
    even = kept("even", spot, {"target": {"builtin": "rectangle"}})
    picture = replace(kept("picture", spot, {"source": lamp}), target=spot**3)
    Comparison(drawn, (even, picture))
    first, second = drawn.axes[:2]
    assert first.lines and not second.lines


def test_other_pixels_are_averaged_and_other_units_converted(kept):
    first = kept("coarse", 0.1)
    fine = kept("fine", 0.3, {"screen.pixels": [96, 64]})
    fine.result.state.irradiance[::2] = 0.5  # rows in turn: the mean counts
    assert Comparison(Figure(), (first, fine)).difference == pytest.approx(
        np.full(first.target.shape, 1.2), abs=1e-12
    )
    in_mm = replace(
        first,
        scene=first.scene.in_unit("mm"),
        result=first.result.with_state(irradiance=first.result.state.irradiance / 100),
    )
    np.testing.assert_allclose(Comparison(Figure(), (first, in_mm)).difference, 0, atol=1e-12)


def test_receivers_that_cover_different_places_are_not_subtracted(kept):
    figure = Figure()
    drawn = Comparison(
        figure, (kept("near", 0.1), kept("wide", 0.1, {"screen.half_width": [2.0, 2.0]}))
    )
    assert drawn.difference is None
    assert len(images(figure)) == 2
    assert "no difference image" in figure.axes[2].texts[0].get_text()
    assert drawn.in_words(figure.axes[1], 1.5, 0) == "1.6 × mean at x = 1.5 cm, y = 0 cm"


@pytest.fixture
def session(make_scene):
    scene = make_scene({"run.iterations": 2})
    target = load_target(scene, Path.cwd())
    history = History()
    for snapshot in run(scene, target):
        history.add(snapshot)
    return Session(scene, target, history.result())


def test_each_picture_shows_something(session):
    assert list(PICTURES) == ["irradiance.png", "lens.png", "loss.png"]
    for write in PICTURES.values():
        png = io.BytesIO()
        write(session, png)
        with Image.open(png, formats=["PNG"]) as picture:
            low, high = picture.convert("L").getextrema()
            assert low < 60 and high > 200
