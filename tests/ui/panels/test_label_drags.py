"""Numbers that change as their label is dragged."""

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from tests.ui.hands import editor, enter, row

LEFT, NONE = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
SIZE, AWAY = "images[0].receiver.half_width", "images[0].receiver.position"


class Hand:
    """Drags on a label."""

    def __init__(self, label):
        self.label, self.x = label, 10.0
        self.send(QEvent.Type.MouseButtonPress)
        self.move(4)  # until it counts as a drag

    def send(self, kind, modifiers=NONE):
        place = QPointF(self.x, 5.0)
        button = LEFT if kind is not QEvent.Type.MouseMove else Qt.MouseButton.NoButton
        buttons = Qt.MouseButton.NoButton if kind is QEvent.Type.MouseButtonRelease else LEFT
        at = self.label.mapToGlobal(place)
        event = QMouseEvent(kind, place, at, button, buttons, modifiers)
        QApplication.sendEvent(self.label, event)

    def move(self, by, modifiers=NONE):
        self.x += by
        self.send(QEvent.Type.MouseMove, modifiers)

    def drop(self):
        self.send(QEvent.Type.MouseButtonRelease)


def extent(document):
    return document.session.scene.receiver.half_width


def test_a_drag_changes_all_numbers_in_proportion_as_one_step(forms, document, qtbot):
    enter(qtbot, forms, f"{SIZE}[0]", "50")
    enter(qtbot, forms, f"{SIZE}[1]", "100")
    steps = document.undo_stack.count()
    label = row(forms, SIZE).label
    assert label.cursor().shape() is Qt.CursorShape.SizeHorCursor
    hand = Hand(label)
    for _ in range(10):
        hand.move(1)
    assert extent(document) == pytest.approx((27.6, 55.0), abs=0.3)
    assert editor(forms, f"{SIZE}[0]").text() == "55.2"
    hand.drop()
    assert document.undo_stack.count() == steps + 1
    assert document.undo_stack.undoText() == "receiver size 50 × 100 → 55.2 × 110 cm"
    hand = Hand(label)
    hand.move(-5)
    hand.drop()
    assert document.undo_stack.count() == steps + 2  # each drag is a step of its own
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert extent(document) == (25.0, 50.0)


def test_shift_makes_it_finer_and_zeros_stay(forms, document):
    hand = Hand(row(forms, AWAY).label)
    hand.move(10, SHIFT)
    assert document.session.scene.receiver.position == pytest.approx((0, 0, 5.05), abs=0.01)
    hand.drop()


def test_escape_takes_a_drag_back_and_leaves_no_step(forms, document, qtbot):
    before, label = document.session.scene, row(forms, SIZE).label
    hand = Hand(label)
    hand.move(30)
    assert extent(document) != before.receiver.half_width
    qtbot.keyClick(label, Qt.Key.Key_Escape)
    assert document.session.scene == before and not document.undo_stack.canUndo()
    hand.move(30)  # the button is still down
    hand.drop()
    assert document.session.scene == before


def test_a_drag_stays_within_the_limits_and_refuses_nothing(forms, document):
    path = "elements[0].faces[1].degree"
    hand = Hand(row(forms, path).label)
    hand.move(400)
    assert document.session.scene.optic.degree == (7, 7)
    hand.drop()
    hand = Hand(row(forms, AWAY).label)
    for _ in range(60):
        hand.move(-10)
    hand.drop()
    assert not forms.refused and not row(forms, AWAY).refusal
    assert 0.5 < document.session.scene.receiver.z < 1.5


def test_a_click_on_a_label_changes_nothing_and_goes_to_the_field(forms, document, qtbot):
    qtbot.mouseClick(row(forms, SIZE).label, LEFT)
    assert editor(forms, f"{SIZE}[0]").hasFocus()
    assert not document.undo_stack.canUndo()


def test_no_label_changes_the_scene_during_a_run(forms, document):
    document.in_run = True
    hand = Hand(row(forms, SIZE).label)
    hand.move(30)
    hand.drop()
    assert forms.postponed_edits == 0 and not document.undo_stack.canUndo()
