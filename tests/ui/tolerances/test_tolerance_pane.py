"""The dock that perturbs the shown lens."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt

from tests.ui.hands import fill
from ui.background import close_threads
from ui.manufacture import tolerance_pane as pane_module
from ui.manufacture.tolerance_pane import TolerancePane
from workbench.analysis.tolerance_fields import ABOUT
from workbench.analysis.tolerances import Distribution, perturbed
from workbench.scene import Scene

CTRL = Qt.KeyboardModifier.ControlModifier
RAYS = 5000

pytestmark = pytest.mark.usefixtures("kernels")


@pytest.fixture
def frame(frames):
    return frames(1)


@pytest.fixture
def pane(session, frame, show, monkeypatch, qtbot):
    monkeypatch.setattr(pane_module, "_RAYS", RAYS)
    pane = TolerancePane()
    qtbot.addWidget(pane, before_close_func=close_threads)
    pane.show_design(session)
    pane.show_frame(frame)
    return show(pane, 760, 420)


def enter(pane, qtbot, path, text):
    """Type into a field."""
    row = pane.form.row(path)
    fill(qtbot, row.editors[path], text)
    return row


def sample(pane, qtbot, lenses=4):
    """Have lenses traced."""
    enter(pane, qtbot, "lenses", f"{lenses}")
    qtbot.mouseClick(pane.begin, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not pane.background.busy, timeout=60_000)


def test_the_figures_are_those_of_the_engine(pane, session, frame, qtbot):
    assert pane.plot.empty and not pane.save.isEnabled()
    enter(pane, qtbot, "tilt", "1.5")
    enter(pane, qtbot, "seed", "3")
    sample(pane, qtbot)
    heights = frame.state.heights["lens.back"]
    nominal, *others = perturbed(
        session.scene, session.target, {"lens.back": heights}, pane.form.within, 4, RAYS, seed=3
    )
    assert np.degrees(pane.form.within.tilt) == pytest.approx(1.5)
    spread = Distribution.of(nominal, others)
    assert pane.summary.text() == (
        f"4 of 4 lenses: error as designed {100 * spread.nominal:.2f} %, median "
        f"{100 * spread.percentiles['50']:.2f} %, 95 % of lenses below "
        f"{100 * spread.percentiles['95']:.2f} %, worst {100 * spread.worst:.2f} %"
    )
    qtbot.waitUntil(lambda: not pane.plot.empty)
    assert pane.save.isEnabled()


def test_errors_that_trains_do_not_have_have_no_fields(pane, session):
    def fields():
        return {name for name in ABOUT if pane.form.row(name).isVisible()}

    before = fields()
    data = session.scene.to_data()
    plate = data["elements"][0] | {"name": "plate", "position": [0, 0, 2], "min_thickness": 0.1}
    plate |= {"faces": [{"shape": "plane"}, {"shape": "plane"}]}
    # A file of heights holds a scene to its unit, but not the next one.
    plate["faces"][1] = {"shape": "bspline", "fixed": True, "heights": "bowl.npy"}
    train = Scene.from_data(data | {"elements": [data["elements"][0], plate]})
    pane.show_design(replace(session, scene=train))
    assert before - fields() == {"exit_tilt", "exit_decentre", "source_tilt"}
    pane.form.check()
    decentre = pane.form.within.decentre
    pane.show_design(session.in_unit("m"))
    assert pane.form.within.decentre == pytest.approx(decentre / 100)


@pytest.mark.parametrize("back", [(Qt.Key.Key_Escape,), (Qt.Key.Key_Z, CTRL)])
def test_impossible_tolerance_is_refused_beside_its_field_and_taken_back(pane, qtbot, back):
    for path, text, word in (
        ("tilt", "50", "less than 45"),
        ("decentre", "-1", "from 0"),
        ("index", "0.9", "less than 0.5"),
        ("surface[0]", "much", "'much' is not a number"),
        ("lenses", "0", "from 1 to"),
    ):
        row = enter(pane, qtbot, path, text)
        assert word in row.refusal, path
        pane.toggle()
        assert not pane.background.busy
        qtbot.keyClick(row.editors[path], *back)
        assert not row.refusal and row.editors[path].text() != text


def test_cancelling_keeps_the_lenses_so_far(pane, qtbot):
    enter(pane, qtbot, "lenses", "50000")
    pane.toggle()
    assert pane.begin.text() == "Cancel"
    qtbot.waitUntil(lambda: len(pane._sample.others) > 2, timeout=60_000)
    pane.toggle()
    assert not pane.begin.isEnabled()
    qtbot.waitUntil(lambda: not pane.background.busy, timeout=60_000)
    assert pane.begin.text() == "Start" and pane.begin.isEnabled()
    traced = len(pane._sample.others)
    assert 2 < traced < 50000 and pane.summary.text().startswith(f"{traced} of 50000 lenses: ")
