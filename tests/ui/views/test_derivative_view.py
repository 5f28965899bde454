"""The derivative dock's view: when it computes, of which lens, what it states."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from ui.views.derivative_view import DerivativeView
from workbench.analysis.derivatives import irradiance_derivative
from workbench.geometry.faces import FaceArrays
from workbench.measured.lamps import light_unit
from workbench.powers import written


@pytest.fixture
def frame(session, snapshots):
    """What the view needs of a frame: a lens, lower with each iteration, and its scene."""

    def make(iteration, of=session):
        heights = FaceArrays({"lens.back": np.full((12, 10), 0.5 - 0.01 * iteration)})
        snapshot = dataclasses.replace(
            snapshots(iteration),
            state=dataclasses.replace(snapshots(iteration).state, heights=heights),
        )
        return SimpleNamespace(session=of, state=snapshot.state)

    return make


@pytest.fixture
def view(qtbot):
    view = DerivativeView()
    qtbot.addWidget(view)
    return view


@pytest.fixture
def seen(view, show):
    return show(view, 380, 380)


def test_shows_the_map_of_the_middle_point_and_its_sum(seen, frame, session, qtbot):
    seen.show_frame(frame(1))
    assert seen.point.index == (6, 5)
    qtbot.waitUntil(lambda: "changes by" in seen._readout.text(), timeout=20_000)
    scene = session.scene
    wanted = irradiance_derivative(scene, {"lens.back": np.full((12, 10), 0.49)}, (6, 5))
    qtbot.waitUntil(lambda: not seen.empty)
    shown = seen._image.image.get_array()
    in_unit = wanted.map * light_unit(scene).density
    np.testing.assert_allclose(shown.filled(0), in_unit, atol=1e-12)
    np.testing.assert_array_equal(shown.mask, wanted.map == 0)
    assert f"{written(wanted.sum, digits=2)} per cm," in seen._readout.text()
    assert seen._readout.text().startswith("x = 0.111 cm, y = 0.143 cm. ")


def test_a_refusal_is_shown_and_the_old_map_removed(seen, frame, make_session, qtbot):
    seen.show_frame(frame(1))
    qtbot.waitUntil(lambda: seen._answer is not None and not seen.empty, timeout=20_000)
    seen.show_frame(frame(1, of=make_session({"filter": {"kind": "box"}})))
    qtbot.waitUntil(lambda: "filter.kind: 'box' counts rays" in seen._readout.text())
    qtbot.waitUntil(lambda: seen._image.image.get_array().count() == 0)
    qtbot.waitUntil(lambda: seen.empty and "'box' counts rays" in seen._hint.text())
