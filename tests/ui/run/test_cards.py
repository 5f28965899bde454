"""Result cards: what they show, their buttons and goals."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QObject, Qt

from tests.ui.hands import fill, move_screen
from ui.background import close_threads
from ui.document.document import Document
from ui.run.cards import Findings, ResultCards
from ui.run.control import RunControl
from workbench.design.limits import Shortfall
from workbench.design.snapshot import SLOW
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet
from workbench.messages import Message
from workbench.optics.account import Account
from workbench.scene import AutoNet

NARROW = Shortfall("height_range", (-2.2, 2.2), (-0.3, 0.3), 0.4)
SLOW_RUN = Message(SLOW, gain=5, patience=5)


@pytest.fixture
def window(display, kernels, window):
    window.build()
    window.commands["workspace_design"].trigger()
    return window


@pytest.fixture
def run(window, as_run, qtbot):
    """Runs that end with lenses in a state."""

    def run(ended="all iterations are done", iterations=4, pause=0.0, wait=True, **state):
        def generate(scene, target, start=None, locked=None):
            for shot in as_run(iterations, pause)(scene, target, start, locked):
                yield replace(shot, state=replace(shot.state, **state))
            return ended

        window.loaded.control.runner._generate = generate
        if not wait:
            window.commands["start"].trigger()
            return
        with qtbot.waitSignal(window.loaded.control.ended):
            window.commands["start"].trigger()

    return run


def card(window, key, qtbot):
    cards = window.loaded.cards.cards
    qtbot.waitUntil(lambda: key in cards and cards[key].isVisibleTo(window.loaded.cards))
    return cards[key]


def press(card, qtbot):
    qtbot.waitUntil(card.button.isVisible)
    qtbot.mouseClick(card.button, Qt.MouseButton.LeftButton)


def test_the_missing_lens_is_started(window, run, as_run, qtbot):
    lens = card(window, "lens", qtbot)
    assert (lens.text, lens.mark.sign) == ("There is no lens yet.", "attention")
    window.loaded.control.runner._generate = as_run(2)
    with qtbot.waitSignal(window.loaded.control.ended):
        press(lens, qtbot)
    error = card(window, "error", qtbot)
    qtbot.waitUntil(lambda: not lens.isVisibleTo(window.loaded.cards))
    assert "computed error" in error.text
    assert card(window, "light", qtbot).text.startswith("92.0 % of the light lands")


def test_a_coarse_net_is_refined_and_designed_anew(window, run, qtbot):
    run(SLOW_RUN)
    net = card(window, "net", qtbot)
    assert "12 × 10 control points are too few" in net.text
    assert net.button.text() == "Refine and start over"
    with qtbot.waitSignal(window.loaded.control.ended):
        press(net, qtbot)
    assert isinstance(window.document.session.scene.optic.control_points, AutoNet)
    texts = [window.document.undo_stack.text(k) for k in range(3)]
    assert texts == ["design run", "refine and start over", "design run"]


def test_a_narrow_range_is_widened_by_a_button_that_ends_the_run(window, run, qtbot):
    run(iterations=10_000, pause=0.01, wait=False, shortfall=NARROW)
    limits = card(window, "limits", qtbot)
    assert limits.text == "The lens needs ±2.2 cm; ±0.3 cm is allowed."
    began = []
    window.loaded.control.runner.state_changed.connect(began.append)
    press(limits, qtbot)
    qtbot.waitUntil(lambda: "running" in began)
    assert began.index("idle") < began.index("running")
    assert window.document.session.scene.optic.height_range is None
    assert window.document.session.result is not None
    window.loaded.control.runner.stop()
    qtbot.waitUntil(lambda: not window.loaded.control.busy)


def test_goals_are_typed_and_judged(window, run, qtbot):
    run(SLOW_RUN)
    light = card(window, "light", qtbot)
    fill(qtbot, light.limit, "95")
    assert window.document.session.scene.run.min_light == 0.95
    assert light.limit.text() == "95 %"
    qtbot.waitUntil(lambda: light.mark.sign == "bad")
    assert window.document.session.result is not None
    fill(qtbot, light.limit, "90,5 %")
    assert window.document.session.scene.run.min_light == 0.905
    qtbot.waitUntil(lambda: light.mark.sign == "good")
    fill(qtbot, light.limit, "much")
    assert light.limit.text() == "90.5 %"
    fill(qtbot, light.limit, "")
    assert window.document.session.scene.run.min_light is None
    window.commands["undo"].trigger()
    qtbot.waitUntil(lambda: light.limit.text() == "90.5 %")


def test_a_goal_that_is_impossible_is_not_taken(window, run, qtbot):
    run(SLOW_RUN)
    light = card(window, "light", qtbot)
    for text in ("120", "0", "-3 %"):
        fill(qtbot, light.limit, text)
        assert light.limit.text() == "" and window.document.session.scene.run.min_light is None


def test_cards_are_marked_within_a_tenth_of_a_second_after_an_edit(window, run, qtbot):
    run(SLOW_RUN)
    cards, error = window.loaded.cards, card(window, "error", qtbot)
    qtbot.waitUntil(lambda: window.loaded.shown.frame.result.ended == SLOW_RUN)
    window.loaded.control._preview.setInterval(10_000_000)  # nothing comes of the next design
    move_screen(window.document, 7)
    assert window.loaded.shown._wait.interval() <= 100
    qtbot.waitUntil(cards._veil.isVisible)
    assert not error.isEnabled()
    window.commands["undo"].trigger()
    qtbot.waitUntil(lambda: not cards._veil.isVisible())
    assert error.isEnabled()


def test_cards_are_greyed_until_findings_of_the_new_lens_come(window, run, frames, qtbot):
    run(SLOW_RUN)
    cards, error = window.loaded.cards, card(window, "error", qtbot)
    qtbot.waitUntil(lambda: window.loaded.shown.frame.result.ended == SLOW_RUN)
    window.loaded.control._preview.setInterval(10_000_000)
    move_screen(window.document, 7)
    qtbot.waitUntil(cards._veil.isVisible)
    before = error.text
    window.loaded.shown.frame_changed.emit(frames(2, window.document.session))
    assert cards._veil.isVisible() and error.text == before
    qtbot.waitUntil(lambda: not cards._veil.isVisible())
    assert error.text != before


@pytest.fixture
def desk(qtbot, session, as_run):
    """Findings of a document whose runs end with totally reflected light."""
    owner = QObject()
    owner.document = Document(session, "small")
    owner.document.setParent(owner)
    owner.control = RunControl(owner.document, owner)
    x, _ = ControlNet.of(session.scene.optic).positions
    rise = 1.2 * np.clip(x - 0.3, 0, None)[:, None] * np.ones((12, 10))

    def generate(scene, target, start=None, locked=None):
        for shot in as_run(2)(scene, target):
            account = Account(0.8, {"total_reflection": 0.2})
            heights = FaceArrays({"lens.back": 0.5 + rise})
            yield replace(shot, state=replace(shot.state, account=account, heights=heights))
        return "all iterations are done"

    owner.control.runner._generate = generate
    owner.findings, owner.spots, owner.found = Findings(owner.control, lambda _: None), [], []
    owner.findings.located.connect(lambda *spots: owner.spots.append(spots))
    owner.findings.found.connect(lambda found, *_: owner.found.append(found))
    owner.control.runner.frame_ready.connect(owner.findings.show_frame)
    yield owner
    close_threads(owner.findings)
    owner.control.close()
    owner.deleteLater()


def test_total_reflection_is_marked_where_it_is(desk, qtbot):
    with qtbot.waitSignal(desk.control.ended):
        desk.control.start()
    qtbot.waitUntil(lambda: bool(desk.spots))
    heights, places = desk.spots[-1]
    assert heights == desk.document.session.heights and places[:, 0].min() > 0.1
    sentence = desk.found[-1][-1].sentence
    assert "% of the light is totally reflected at the exit face, most of it around" in sentence
    assert "as marked in the 3D scene: thicker stock" in sentence


def test_levels_differ_in_shape(qtbot, desk, window):
    cards = ResultCards(desk.findings, window.commands)
    qtbot.addWidget(cards)
    with qtbot.waitSignal(desk.control.ended):
        desk.control.start()
    qtbot.waitUntil(lambda: "error" in cards.cards)
    mark, seen = cards.cards["error"].mark, set()
    for level in ("good", "attention", "bad"):
        mark.show_sign(level)
        image = mark.grab().toImage()
        ground = image.pixelColor(0, 0)
        filled = [image.pixelColor(x, y) != ground for y in (1, 8) for x in range(16)]
        seen.add(tuple(filled))
    assert len(seen) == 3
