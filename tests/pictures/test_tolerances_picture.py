import io

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from PIL import Image

from workbench.pictures.axes import paint
from workbench.pictures.error_curves import draw_errors, write_errors

ERRORS = [0.3, 0.1, 0.2, 0.4]


def test_the_distribution_has_a_step_for_each_lens():
    axes = Figure().subplots()
    draw_errors(axes, 0.05, ERRORS)
    curve, nominal, middle, most = axes.get_lines()
    x, y = curve.get_data()
    np.testing.assert_allclose(x, [10, 10, 20, 30, 40])
    np.testing.assert_allclose(y, [0, 25, 50, 75, 100])
    assert nominal.get_xdata()[0] == pytest.approx(5)
    assert middle.get_xdata()[0] == pytest.approx(25)
    assert most.get_label() == "95 %: 38.50 %"


def test_a_file_is_written():
    file = io.BytesIO()
    write_errors(file, 0.05, ERRORS)
    assert Image.open(file).size == (900, 600)


def test_the_legend_follows_ink_and_paper():
    figure = Figure()
    draw_errors(figure.subplots(), 0.05, ERRORS)
    paint(figure, "#eeeeee", "#202020")
    legend = figure.axes[0].get_legend()
    assert to_hex(legend.get_frame().get_facecolor()) == "#202020"
    assert {text.get_color() for text in legend.get_texts()} == {"#eeeeee"}
