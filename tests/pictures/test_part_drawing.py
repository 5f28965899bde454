"""Drawing of a part: its dimensions and its scale on paper."""

import json

import numpy as np
import pytest
from matplotlib.figure import Figure

from resources import path
from tests.analysis.lenses import net_of
from workbench.geometry.surface import nets_of
from workbench.pictures.part.drawing import PartDrawing
from workbench.scene import Scene

WIDTH = 7.5


def drawn(scene, height):
    drawing = PartDrawing(scene.optic, {"lens.back": net_of(scene, height)}, scene.unit, WIDTH)
    figure = Figure(figsize=(WIDTH, drawing.height))
    drawing.draw(figure)
    (axes,) = figure.axes
    return drawing, axes, [text.get_text() for text in axes.texts if text.get_text()]


def wedge(x, y):
    return 0.6 + 0.1 * y + 0 * x


def test_dimensions_are_in_mm_whatever_the_unit_of_the_scene(make_scene):
    scene = make_scene({"lens.half_width": [1.0, 0.5]})  # cm
    _, _, texts = drawn(scene, wedge)
    assert {"20", "10", "overall 6.5", "centre 6"} <= set(texts)
    assert sorted(text for text in texts if text.startswith("edge")) == [
        "edge 5.5",
        "edge 6",
        "edge 6",
        "edge 6.5",
    ]


def test_the_drawing_is_to_scale_on_paper(make_scene):
    drawing, axes, _ = drawn(make_scene(), wedge)
    across, up = axes.get_xlim()[1], axes.get_ylim()[1]
    assert (across, up) == pytest.approx((25.4 * WIDTH, 25.4 * drawing.height))  # mm of paper
    front = axes.patches[0].get_path().vertices
    assert drawing.scale_in_words == "2 : 1"
    assert np.ptp(front, axis=0) == pytest.approx([40, 40])  # of 2 × 2 cm


@pytest.mark.parametrize("factor", [0.01, 3.0, 300.0])
def test_each_size_fits_the_page(make_scene, factor):
    scene = make_scene({"lens.half_width": [factor, 0.4 * factor], "screen.z": 1 + 40 * factor})
    drawing, axes, _ = drawn(scene, lambda x, y: 0.5 + 0 * (x + y))
    points = np.concatenate([patch.get_path().vertices for patch in axes.patches])
    low, high = points.min(axis=0), points.max(axis=0)
    assert (low > 0).all() and high[0] < axes.get_xlim()[1] and high[1] < axes.get_ylim()[1]
    assert drawing.height < 7


def test_an_inch_stays_an_inch(make_scene):
    drawing, _, texts = drawn(make_scene({"unit": "inch"}), wedge)
    assert drawing.unit == "inch" and "2" in texts


def test_the_rim_of_an_ellipse_is_drawn(make_scene):
    _, axes, _ = drawn(make_scene({"lens.outline": "ellipse"}), wedge)
    front = axes.patches[0].get_path().vertices
    middle = (front.max(axis=0) + front.min(axis=0)) / 2
    assert np.hypot(*(front - middle).T) == pytest.approx(20, rel=1e-6)


def test_both_sections_of_a_mirror_have_the_same_flat_back():
    data = json.loads(path("examples", "mirror-letter.json").read_text())
    data["elements"][0]["face"]["control_points"] = [8, 8]
    scene = Scene.from_data(data)
    ((face, net),) = nets_of(scene).items()
    rises = np.linspace(0, 3, net.shape[0])[:, None] * np.ones(net.shape[1])  # along x
    drawing = PartDrawing(scene.optic, {face: rises}, scene.unit, WIDTH)
    figure = Figure(figsize=(WIDTH, drawing.height))
    drawing.draw(figure)
    texts = [text.get_text() for text in figure.axes[0].texts]
    (centre,) = (text.removeprefix("centre ") for text in texts if text.startswith("centre"))
    assert texts.count(f"edge {centre}") == 2  # across y
    thin, thick = sorted(
        float(text.removeprefix("edge "))
        for text in texts
        if text.startswith("edge") and not text.endswith(centre)
    )
    assert thick - thin == pytest.approx(3)
    assert (thin + thick) / 2 == pytest.approx(float(centre))
