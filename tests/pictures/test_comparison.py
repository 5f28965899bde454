"""Two runs drawn beside each other."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from tests.accounts import account_of
from workbench.design.lens_state import LensState
from workbench.design.session import KeptRun
from workbench.design.snapshot import Result
from workbench.design.task import begin
from workbench.geometry.faces import FaceArrays
from workbench.pictures.comparison import Comparison


@pytest.fixture
def kept(make_scene):
    """Makes runs of a scene with some fields changed, whose light is given."""

    def make(name, light, changes=None):
        session = begin(make_scene(changes), Path())
        n_x, n_y = session.scene.receiver.pixels
        state = LensState(
            heights=FaceArrays({"exit": np.full(session.scene.optic.net_shape, 0.5)}),
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
    np.testing.assert_allclose(difference.get_array(), 0.2)
    assert difference.get_clim() == (-0.2, 0.2)
    names = [axes.get_title() for axes in figure.axes]
    assert names[:4] == ["dim", "bright", "Second minus first", "Loss"]
    losses = figure.axes[3].lines
    assert [line.get_label() for line in losses] == ["dim", "bright"]
    assert drawn.in_words(figure.axes[2], 0.1, 0.1) == "0.1 → 0.3 / cm² at x = 0.1 cm, y = 0.1 cm"


def test_other_pixels_are_averaged_and_other_units_converted(kept):
    first = kept("coarse", 0.1)
    fine = kept("fine", 0.3, {"screen.pixels": [96, 64]})
    fine.result.state.irradiance[::2] = 0.5  # rows in turn: the mean counts
    assert Comparison(Figure(), (first, fine)).difference == pytest.approx(
        np.full(first.target.shape, 0.3), abs=1e-12
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
    assert "nothing to subtract" in figure.axes[2].texts[0].get_text()
    assert drawn.in_words(figure.axes[1], 1.5, 0) == "0.1 / cm² at x = 1.5 cm, y = 0 cm"
