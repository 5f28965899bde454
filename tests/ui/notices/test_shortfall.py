"""What the window says, and offers, when the limits of a lens are too narrow for its task."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QObject, Qt

from ui.document.document import Document
from ui.run.control import RunControl
from ui.widgets.messages import MessageBar
from ui.window.run_notices import ShortfallNotice
from workbench.design.limits import Shortfall

NARROW = Shortfall("height_range", (-2.2, 2.2), (-0.3, 0.3), 0.4)
THIN = Shortfall("max_thickness", (0.1, 0.9), (0.1, 0.6), 0.4)


@pytest.fixture
def desk(qtbot, session, as_run, snapshots):
    """A document whose runs fall short by as much as a test says."""
    owner = QObject()
    owner.document = Document(session, "small")
    owner.document.setParent(owner)
    owner.control, owner.messages = RunControl(owner.document, owner), MessageBar()
    owner.begun = []

    def fall_short(shortfall, iterations=4, pause=0.0):
        def run(scene, target, start=None, locked=None):
            ended = as_run(iterations, pause)(scene, target, start, locked)
            for shot in ended:
                yield replace(shot, state=replace(shot.state, shortfall=shortfall))
            return "all iterations are done"

        owner.control.runner._generate = run

    owner.fall_short = fall_short
    ShortfallNotice(
        owner.document,
        owner.control,
        owner.messages,
        lambda: owner.begun.append("anew"),
        lambda: owner.begun.append("from the lens"),
    )
    qtbot.addWidget(owner.messages)
    yield owner
    owner.control.close()
    owner.deleteLater()


def design(desk, qtbot):
    with qtbot.waitSignal(desk.control.ended):
        desk.control.start()


def offers(desk):
    return [button.text() for button in desk.messages.buttons]


def press(desk, qtbot):
    (button,) = desk.messages.buttons
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_a_too_small_range_is_reported_and_can_be_widened_keeping_the_lens(desk, qtbot):
    desk.fall_short(NARROW)
    design(desk, qtbot)
    assert desk.messages.text == "The lens needs ±2.2 cm; ±0.3 cm is allowed."
    assert offers(desk) == ["Widen"]
    lens = desk.document.session.result.state.heights["lens.back"]
    press(desk, qtbot)
    session = desk.document.session
    assert session.scene.optic.height_range is None
    assert (
        session.result.state.heights["lens.back"] is lens and session.result.state.shortfall is None
    )
    assert "is automatic now" in desk.messages.text
    assert offers(desk) == ["Start over", "Continue"]
    for button in desk.messages.buttons:
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert desk.begun == ["anew", "from the lens"]


def test_the_notice_comes_during_the_run_and_can_stop_it(desk, qtbot):
    desk.fall_short(NARROW, iterations=10_000, pause=0.01)
    desk.control.start()
    qtbot.waitUntil(lambda: "The run goes on within them" in desk.messages.text)
    assert offers(desk) == ["Stop and widen"]
    with qtbot.waitSignal(desk.control.ended):
        press(desk, qtbot)
    assert desk.document.session.scene.optic.height_range is None
    assert desk.document.session.result is not None
    assert offers(desk) == ["Start over", "Continue"]


def test_too_thin_stock_is_reported_with_its_own_cure(desk, qtbot):
    desk.fall_short(THIN)
    design(desk, qtbot)
    assert desk.messages.text == (
        "The lens needs to be 0.9 cm thick; the stock allows 0.6 cm: "
        "thicker stock, or a smaller minimal thickness, lets the lens bend more."
    )
    assert offers(desk) == []


def test_an_automatic_range_is_replaced_by_one_as_wide_as_the_lens_needs(desk, qtbot):
    free = desk.document.session.scene.optic.shaped(height_range=None)
    desk.document.edit(desk.document.session.scene.with_optic(free), "range", "")
    desk.fall_short(NARROW)
    design(desk, qtbot)
    assert "±0.3 cm is the automatic limit" in desk.messages.text
    press(desk, qtbot)
    low, high = desk.document.session.scene.optic.height_range
    assert low < -2.2 and high > 2.2
