"""What is said and offered when an edit changes the net or the task of a designed lens."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QObject, Qt

from tests.ui.hands import enter
from ui.document.document import Document
from ui.notices.carried_lens import CarriedLens
from ui.panels.forms import Forms
from ui.widgets.message_bar import MessageBar
from workbench.geometry.approximation import deviation
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet
from workbench.powers import written
from workbench.scene import FlatEntrance, FreeformEntrance


@pytest.fixture
def desk(qtbot, session, history, rng):
    """Forms over a document with a lens that no coarser net can hold, and what is said of it."""
    result = history(4).result()
    heights = result.state.heights["exit"] + 0.01 * rng.normal(
        size=result.state.heights["exit"].shape
    )
    document = Document(
        replace(session, result=result.with_state(heights=FaceArrays({"exit": heights}))),
        "designed",
    )
    document.setParent(owner := QObject())
    owner.forms, owner.messages, owner.document = Forms(document), MessageBar(), document
    owner.log = []
    CarriedLens(document, owner.messages, owner).noted.connect(owner.log.append)
    qtbot.addWidget(owner.forms)
    qtbot.addWidget(owner.messages)
    owner.forms.show()
    yield owner
    owner.deleteLater()


def test_a_finer_net_that_holds_the_lens_keeps_its_result(desk, qtbot):
    before = desk.document.session
    enter(qtbot, desk.forms, "lens.control_points[0]", "21")  # 9 spans of degree 3 become 18
    after = desk.document.session
    assert after.result.state.heights["exit"].shape == (21, 10)
    assert after.result.state.irradiance is before.result.state.irradiance
    assert desk.messages.text == "On 21 × 10 control points the lens is the same."
    assert desk.document.undo_stack.count() == 1
    desk.document.undo_stack.undo()
    assert desk.document.session is before
    assert desk.messages.text == ""


def test_a_net_that_cannot_hold_the_lens_asks(desk, qtbot):
    before = desk.document.session
    enter(qtbot, desk.forms, "lens.control_points[0]", "20")
    after = desk.document.session
    assert after.result is None and after.start["exit"].shape == (20, 10)
    off = deviation(
        ControlNet.of(before.scene.optic),
        before.heights["exit"],
        ControlNet.of(after.scene.optic),
        after.start["exit"],
    )
    assert f"off by up to {written(off, 'cm', 2)}" in desk.messages.text
    assert desk.messages.buttons[0].text() == "Take 21 × 10, exact"
    qtbot.mouseClick(desk.messages.buttons[0], Qt.MouseButton.LeftButton)
    taken = desk.document.session
    assert taken.scene.optic.control_points == (21, 10)
    assert taken.result.state.loss == before.result.state.loss
    assert desk.messages.text == ""
    desk.document.undo_stack.undo()
    assert desk.document.session is after


def test_a_lens_of_another_task_is_reported_once(desk, qtbot):
    for z in ("6", "7", "8"):
        enter(qtbot, desk.forms, "screen.z", z)
        desk.document.undo_stack.setClean()  # steps of their own
    assert len(desk.log) == 1 and "is a start for this one" in desk.log[0]
    assert desk.document.session.start is not None
    assert desk.messages.text == ""


def test_a_second_freeform_face_is_said_and_taken_back(desk):
    document = desk.document
    before = document.session
    two_faced = before.scene.optic.altered(
        entrance=FreeformEntrance(control_points=(8, 8), height_range=(0.0, 0.1))
    )
    document.edit(before.scene.altered(lens=two_faced), "two faces", "lens.entrance.shape")
    assert set(document.session.heights) == {"entrance", "exit"}
    assert desk.messages.text.startswith("The entrance face is freeform now, and flat so far.")
    document.undo_stack.undo()
    assert document.session is before
    document.undo_stack.redo()
    two = document.session
    flat = two.scene.optic.altered(entrance=FlatEntrance())
    document.edit(two.scene.altered(lens=flat), "one face", "lens.entrance")
    assert set(document.session.heights) == {"exit"}
    assert desk.messages.text.startswith("The entrance face is flat now;")
