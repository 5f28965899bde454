"""What is stated and offered when an edit changes the net or the task of a designed lens."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QObject, Qt

from tests.ui.hands import enter
from ui.document.document import Document
from ui.panels.forms import Forms
from ui.widgets.messages import Messages
from ui.window.edit_notices import CarriedLens
from workbench.geometry.approximation import deviation
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import ControlNet
from workbench.powers import written
from workbench.scene import PlaneFace, SplineFace


@pytest.fixture
def desk(qtbot, session, history, rng):
    """Forms over a document with a lens that no coarser net can hold, and what is stated of it."""
    result = history(4).result()
    heights = result.state.heights["lens.back"] + 0.01 * rng.normal(
        size=result.state.heights["lens.back"].shape
    )
    document = Document(
        replace(session, result=result.with_state(heights=FaceArrays({"lens.back": heights}))),
        "designed",
    )
    document.setParent(owner := QObject())
    owner.forms, owner.messages, owner.document = Forms(document), Messages(), document
    owner.log = []
    CarriedLens(document, owner.messages, owner).noted.connect(owner.log.append)
    qtbot.addWidget(owner.forms)
    qtbot.addWidget(owner.messages)
    owner.forms.show()
    yield owner
    owner.deleteLater()


def test_a_finer_net_that_holds_the_lens_keeps_its_result(desk, qtbot):
    before = desk.document.session
    enter(
        qtbot, desk.forms, "elements[0].faces[1].control_points[0]", "21"
    )  # 9 spans of degree 3 become 18
    after = desk.document.session
    assert after.result.state.heights["lens.back"].shape == (21, 10)
    assert after.result.state.irradiance is before.result.state.irradiance
    assert desk.messages.text == "The lens is unchanged on 21 × 10 control points."
    assert desk.document.undo_stack.count() == 1
    desk.document.undo_stack.undo()
    assert desk.document.session is before
    assert desk.messages.text == ""


def test_a_net_that_cannot_hold_the_lens_asks(desk, qtbot):
    before = desk.document.session
    enter(qtbot, desk.forms, "elements[0].faces[1].control_points[0]", "20")
    after = desk.document.session
    assert after.result is None and after.start["lens.back"].shape == (20, 10)
    off = deviation(
        ControlNet.of(before.scene.optic),
        before.heights["lens.back"],
        ControlNet.of(after.scene.optic),
        after.start["lens.back"],
    )
    assert f"deviation up to {written(off, 'cm', 2)}" in desk.messages.text
    assert desk.messages.buttons[0].text() == "Use 21 × 10, exact"
    qtbot.mouseClick(desk.messages.buttons[0], Qt.MouseButton.LeftButton)
    taken = desk.document.session
    assert taken.scene.optic.control_points == (21, 10)
    assert taken.result.state.loss == before.result.state.loss
    assert desk.messages.text == ""
    desk.document.undo_stack.undo()
    assert desk.document.session is after


def test_a_run_keeps_the_net_that_it_began_with(desk, qtbot):
    enter(qtbot, desk.forms, "elements[0].faces[1].control_points[0]", "20")
    there = desk.document.session
    desk.document.in_run = True
    for _ in range(2):
        qtbot.mouseClick(desk.messages.buttons[0], Qt.MouseButton.LeftButton)
        assert desk.document.session is there
        assert desk.messages.text == "Not possible during a run. Stop it first"
    desk.document.in_run = False
    assert desk.messages.buttons[0].text() == "Use 21 × 10, exact"
    qtbot.mouseClick(desk.messages.buttons[0], Qt.MouseButton.LeftButton)
    assert desk.document.session.scene.optic.control_points == (21, 10)


def test_a_lens_of_another_task_is_reported_once(desk, qtbot):
    for z in ("6", "7", "8"):
        enter(qtbot, desk.forms, "images[0].receiver.position[2]", z)
        desk.document.undo_stack.setClean()  # steps of their own
    assert len(desk.log) == 1 and "was designed for another task" in desk.log[0]
    assert desk.document.session.start is not None
    assert desk.messages.text == ""


def test_a_lens_of_another_outline_is_dropped_and_the_window_says_so(desk, qtbot):
    enter(qtbot, desk.forms, "elements[0].half_width[0]", "1.5")
    assert "does not fit the new outline" in desk.messages.text
    assert desk.document.session.heights is None
    desk.document.undo_stack.undo()
    assert desk.document.session.result is not None
    assert desk.messages.text == ""


def test_a_lens_that_exceeds_its_new_range_is_changed_and_the_window_says_by_how_much(desk, qtbot):
    before = desk.document.session.heights["lens.back"]
    enter(qtbot, desk.forms, "elements[0].faces[1].height_range[1]", "0.01")
    after = desk.document.session
    moved = np.abs(after.heights["lens.back"] - before).max()
    assert after.result is None and after.heights["lens.back"].max() <= 0.51
    assert f"moved by up to {moved:.2g} cm" in desk.messages.text


def test_a_second_freeform_face_is_stated_and_taken_back(desk):
    document = desk.document
    before = document.session
    front = SplineFace(control_points=(8, 8), height_range=(0.0, 0.1))
    two_faced = before.scene.optic.with_face("lens.front", front)
    document.edit(before.scene.with_optic(two_faced), "two faces", "elements[0].faces[0].shape")
    assert set(document.session.heights) == {"lens.front", "lens.back"}
    assert desk.messages.text.startswith("The entrance face is freeform now, and still flat.")
    document.undo_stack.undo()
    assert document.session is before
    document.undo_stack.redo()
    two = document.session
    flat = two.scene.optic.with_face("lens.front", PlaneFace())
    document.edit(two.scene.with_optic(flat), "one face", "elements[0].faces[0]")
    assert set(document.session.heights) == {"lens.back"}
    assert desk.messages.text.startswith("The entrance face is flat now;")
