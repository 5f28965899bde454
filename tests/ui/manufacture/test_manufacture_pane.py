"""The dock that says whether a shop can make the shown lens."""

import pytest

from tests.ui.hands import fill
from ui.background import close_threads
from ui.manufacture.pane import ManufacturePane
from workbench.analysis.manufacture import manufacture
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet
from workbench.pictures.manufacture import MAPS


@pytest.fixture
def bowl(session, frames):
    """A frame whose face is a bowl of this depth at the middle of its sides."""

    def make(depth, session=session):
        x, y = ControlNet.of(session.scene.optic).positions
        bowl = 0.5 + depth * (x[:, None] ** 2 + y**2)
        return frames(1, session, heights=FaceArrays({"lens.back": bowl}))

    return make


@pytest.fixture
def pane(settings, session, bowl, show, qtbot):
    pane = ManufacturePane(settings, [])
    qtbot.addWidget(pane, before_close_func=close_threads)
    pane.show_design(session)
    pane.show_frame(bowl(0.2))
    show(pane, 760, 420)
    qtbot.waitUntil(lambda: pane._answer is not None and not pane.map.empty)
    return pane


def enter(pane, qtbot, name, text):
    """Type a limit."""
    return fill(qtbot, pane.figures.row(name).editors[name], text)


def states(pane):
    return {key: label.text() for key, label in pane.figures.states.items()}


def legend(pane):
    return [text.get_text() for text in pane.map._canvas.figure.axes[0].get_legend().get_texts()]


def test_a_map_shows_all_limits_and_the_3d_view_hears_of_them(pane, qtbot):
    pane.map.chooser.setCurrentIndex(MAPS.index("Limits"))
    qtbot.waitUntil(lambda: pane.map._canvas.figure.axes[0].get_legend() is not None)
    assert legend(pane) == ["Within limits (100 %)"]
    with qtbot.waitSignal(pane.figures.limits_changed) as caught:
        enter(pane, qtbot, "max_slope", "5")
    assert caught.args == [pane.figures.limits] and pane.figures.limits.max_slope == 5
    qtbot.waitUntil(lambda: len(legend(pane)) == 2 and hatched(pane))
    slope = pane._answer.maps["lens.back"].slope
    assert legend(pane)[1] == f"Slope ({100 * (slope > 5).mean():.2g} %)"
    assert set(pane.map.data()[2].values) == {0, 1}


def hatched(pane):
    return bool(pane.map._canvas.figure.axes[0].collections)


def test_the_figures_are_those_of_the_engine(pane, bowl, session):
    frame = bowl(0.2)
    found = manufacture(session.scene.optic, frame.state.heights)
    figures = pane.figures.found.items()
    texts = {key: label.text() for key, label in figures if label.isVisibleTo(pane)}
    assert texts == {
        "thinnest": f"{found.thinnest.value:.4g} cm",
        "thickest": f"{found.thickest.value:.4g} cm",
        "steepest": f"{found.steepest.value:.4g}°",
        "tightest_concave": f"{found.tightest_concave.value:.4g} cm",
        "tightest_convex": "none",
        "tool_radius": f"{found.tool_radius.value:.4g} cm",
        "sag_range": f"{found.sag_range:.4g} cm",
        "draft": f"{found.draft:.4g}°",
    }
    assert "At x = " in pane.figures.found["steepest"].toolTip()


def test_limits_are_judged_in_words_and_hatched_on_the_map(pane, qtbot):
    own = pane.figures.limits.min_thickness
    assert own > 0 and states(pane)["thinnest"] == "✓ met"  # the design's own, unless stated
    assert not any(text for key, text in states(pane).items() if key != "thinnest")
    enter(pane, qtbot, "max_slope", "5")
    assert states(pane)["steepest"] == "✗ exceeded"
    pane.map.chooser.setCurrentIndex(MAPS.index("Slope"))
    qtbot.waitUntil(lambda: hatched(pane))
    enter(pane, qtbot, "max_slope", "89")
    assert states(pane)["steepest"] == "✓ met"
    qtbot.waitUntil(lambda: not hatched(pane))
    concave = pane._answer.figures["lens"].tightest_concave
    between = f"{(concave.value + concave.bound) / 2:.12g}"
    enter(pane, qtbot, "min_radius", between)
    assert states(pane)["tightest_concave"] == "? not checked yet"
    assert states(pane)["tightest_convex"] == "✓ met"
    enter(pane, qtbot, "min_tool_radius", f"{1.01 * concave.value:.12g}")
    assert states(pane)["tool_radius"] == "✗ exceeded"


def test_figures_follow_the_lens_when_it_stops_changing(pane, bowl, qtbot):
    pane.allow(resting=False)
    pane.show_frame(bowl(0.1))
    assert "Outdated" in pane.figures.note.text()
    assert not pane.figures.found["steepest"].isEnabled()
    qtbot.wait(400)
    before = pane.figures.found["steepest"].text()
    assert not pane.background.busy and not pane._rest.isActive()
    notes, parts = [], []
    pane.background.progressed.connect(lambda *_: notes.append(pane.figures.note.text()))
    pane.background.changed.connect(lambda task: parts.append(task.part))
    pane.allow(resting=True)
    qtbot.waitUntil(lambda: pane.figures.found["steepest"].text() != before)
    assert set(notes) == {"Computing the figures…"}
    known = parts[1:-1]  # the first ones may be over before anybody asks
    assert parts[0] is None and known == sorted(known) and parts[-1] == pytest.approx(1.0)
    assert pane.figures.note.text() == "" and pane.figures.found["steepest"].isEnabled()


def test_a_lens_of_two_faces_has_figures_and_maps_of_each(pane, make_session, frames, qtbot):
    session = make_session({"version": 2, "lens.entrance": {"shape": "freeform"}})
    x, y = ControlNet.of(session.scene.optic).positions
    bowl = 0.1 * (x[:, None] ** 2 + y**2)
    heights = FaceArrays({"lens.front": bowl, "lens.back": 0.6 - 2 * bowl})
    pane.show_design(session)
    pane.show_frame(frames(1, session, heights=heights))
    found = pane.figures.found
    qtbot.waitUntil(lambda: found["entrance steepest"].isVisibleTo(pane))
    figures = manufacture(session.scene.optic, heights)
    assert found["steepest"].text() == f"{figures.steepest.value:.4g}°"
    assert found["entrance steepest"].text() == f"{figures.entrance.steepest.value:.4g}°"
    assert found["entrance tightest_concave"].text() == "none"
    assert found["entrance tightest_convex"].text() != found["tightest_convex"].text()
    enter(pane, qtbot, "max_slope", f"{figures.entrance.steepest.value * 1.1:.6g}")
    assert states(pane)["steepest"] == "✗ exceeded"
    assert states(pane)["entrance steepest"] == "✓ met"

    pane.map.chooser.setCurrentText("Slope")
    qtbot.waitUntil(lambda: pane.map.data()[2].name.startswith("Slope"))
    assert pane.map.faces.isVisibleTo(pane) and pane.map.faces.face == "lens.back"
    steep = max(pane.map.data()[2].values)
    pane.map.faces.choose("lens.front")
    qtbot.waitUntil(lambda: max(pane.map.data()[2].values) < 0.6 * steep)

    flat = make_session()
    pane.show_design(flat)
    pane.show_frame(frames(1, flat))
    qtbot.waitUntil(lambda: not found["entrance steepest"].isVisibleTo(pane))
    assert not pane.map.faces.isVisibleTo(pane)
