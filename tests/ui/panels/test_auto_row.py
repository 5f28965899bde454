"""The form offers to leave the net to the program, and shows what that comes to."""

import pytest

from tests.ui.hands import enter, row
from workbench.design.session import Session
from workbench.scene import AutoNet

NET = "elements[0].faces[1].control_points"


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene({"lens.control_points": "auto", "screen.pixels": [20, 16]})
    return Session(scene, rng.random((16, 20)))


def shown(forms, path=NET):
    net = row(forms, path)
    return net.box.isChecked(), [(e.text(), e.placeholderText()) for e in net.editors.values()]


def test_the_row_shows_what_auto_comes_to(forms):
    assert shown(forms) == (True, [("", "90"), ("", "72")])


def test_a_number_that_is_typed_takes_the_tick_away(forms, document, qtbot):
    enter(qtbot, forms, f"{NET}[0]", "12")
    assert document.session.scene.optic.control_points == (12, 12)
    assert shown(forms) == (False, [("12", "12"), ("12", "12")])
    document.undo_stack.undo()
    assert shown(forms)[0]


def test_an_empty_field_leaves_it_to_the_program_again(forms, document, qtbot):
    enter(qtbot, forms, f"{NET}[0]", "12")
    enter(qtbot, forms, f"{NET}[1]", "")
    assert document.session.scene.optic.control_points == AutoNet((90, 72))


def test_an_entrance_face_shows_the_net_of_the_exit_face_and_takes_it(forms, document):
    forms.switch_entrance()
    net = "elements[0].faces[0].control_points"
    assert shown(forms, net) == (True, [("", "90"), ("", "72")])
    row(forms, net).box.click()
    assert document.session.scene.optic.entrance.control_points == (90, 72)
    assert shown(forms, net) == (False, [("90", "90"), ("72", "72")])
    row(forms, net).box.click()
    assert document.session.scene.optic.entrance.control_points == AutoNet()
