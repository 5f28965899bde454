"""The form offers to leave the net to the program, and shows what that comes to."""

import numpy as np
import pytest

from tests.ui.hands import editor, enter, row
from workbench.design.session import Session
from workbench.scene import AutoNet

NET = "lens.control_points"


@pytest.fixture
def session(make_scene, rng):
    scene = make_scene({NET: "auto", "screen.pixels": [20, 16]})
    return Session(scene, rng.random((16, 20)))


def shown(forms, path=NET):
    net = row(forms, path)
    return net.box.isChecked(), [(e.text(), e.placeholderText()) for e in net.editors.values()]


def test_the_row_shows_what_auto_comes_to(forms):
    assert shown(forms) == (True, [("", "49"), ("", "39")])


def test_a_number_that_is_typed_takes_the_tick_away(forms, document, qtbot):
    enter(qtbot, forms, f"{NET}[0]", "12")
    assert document.session.scene.optic.control_points == (12, 12)
    assert shown(forms) == (False, [("12", "12"), ("12", "12")])
    document.undo_stack.undo()
    assert shown(forms)[0]


def test_an_empty_field_leaves_it_to_the_program_again(forms, document, qtbot):
    enter(qtbot, forms, f"{NET}[0]", "12")
    enter(qtbot, forms, f"{NET}[1]", "")
    assert document.session.scene.optic.control_points == AutoNet((49, 39))


def test_the_tick_takes_the_numbers_that_count_and_gives_them_back(forms, document, qtbot):
    row(forms, NET).box.click()
    assert document.session.scene.optic.control_points == (49, 39)
    assert editor(forms, f"{NET}[0]").text() == "49"
    row(forms, NET).box.click()
    assert document.session.scene.optic.control_points == AutoNet((49, 39))


def test_the_same_value_again_is_no_step(forms, document, qtbot):
    before = document.session
    enter(qtbot, forms, "screen.z", "5.0")
    assert document.session is before and not document.undo_stack.count()


def test_an_edit_of_the_screen_changes_what_auto_comes_to(forms, document, qtbot):
    enter(qtbot, forms, "screen.pixels[0]", "40")
    assert document.session.scene.optic.net_shape[0] == 75
    assert np.shape(document.session.target) == (16, 40)
    assert shown(forms)[1][0] == ("", "75")


def test_a_number_beside_one_that_is_refused_takes_the_tick_away_with_it(forms, document, qtbot):
    enter(qtbot, forms, f"{NET}[0]", "x")
    assert row(forms, NET).refusal
    enter(qtbot, forms, f"{NET}[1]", "7")
    assert document.session.scene.optic.control_points == AutoNet((49, 39))
    enter(qtbot, forms, f"{NET}[0]", "9")
    assert document.session.scene.optic.control_points == (9, 7)
    assert not forms.refused


def test_an_entrance_face_shows_the_net_of_the_exit_face_and_takes_it(forms, document):
    forms.switch_entrance()
    net = "lens.entrance.control_points"
    assert shown(forms, net) == (True, [("", "49"), ("", "39")])
    row(forms, net).box.click()
    assert document.session.scene.optic.entrance.control_points == (49, 39)
    assert shown(forms, net) == (False, [("49", "49"), ("39", "39")])
    row(forms, net).box.click()
    assert document.session.scene.optic.entrance.control_points == AutoNet()
