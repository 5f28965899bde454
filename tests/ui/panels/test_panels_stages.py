"""The stages in the form: listed, added, moved, edited, refused, undone."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListWidget, QToolButton

from tests.ui.hands import choose, enter, row, rows
from ui.document.document import Document
from workbench.scene import Stage


@pytest.fixture
def begin(make_session, open_forms):
    """Opens the forms of a scene with some run settings."""

    def opened_with(run=None):
        session = make_session({"run": run or {"iterations": 100}})
        document = Document(session, "staged")
        forms = open_forms(document)
        document.setParent(forms)
        return document, forms

    return opened_with


def stages(document):
    return document.session.scene.run.stages


def click(qtbot, forms, text):
    buttons = row(forms, "run.stages").findChildren(QToolButton)
    button = next(each for each in buttons if each.text() == text)
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def the_list(forms):
    return row(forms, "run.stages").findChild(QListWidget)


def listed(forms):
    found = the_list(forms)
    return [found.item(at).text() for at in range(found.count())]


TWO = {"iterations": 100, "stages": [{"iterations": 10}, {"iterations": 20}]}


def test_stages_are_added_and_each_is_a_step_of_its_own(begin, qtbot):
    document, forms = begin()
    assert listed(forms) == []
    click(qtbot, forms, "Add")
    click(qtbot, forms, "Add")
    assert [stage.iterations for stage in stages(document)] == [50, 25]
    assert listed(forms) == ["1.  50 iterations", "2.  25 iterations"]
    assert the_list(forms).currentRow() == 1
    document.undo_stack.undo()
    assert listed(forms) == ["1.  50 iterations"]
    document.undo_stack.undo()
    assert stages(document) == ()
    assert [each.path for each in rows(forms) if "stages" in each.path] == ["run.stages"]
    document.undo_stack.redo()
    assert listed(forms) == ["1.  50 iterations"]


def test_every_setting_of_a_stage_can_be_edited_and_left_out_again(begin, qtbot):
    document, forms = begin(TWO)
    at = "run.stages[0]"
    enter(qtbot, forms, f"{at}.iterations", "12")
    choose(forms, f"{at}.method", "paper")
    enter(qtbot, forms, f"{at}.learning_rate", "0.01")
    enter(qtbot, forms, f"{at}.control_points[0]", "6")
    enter(qtbot, forms, f"{at}.control_points[1]", "7")
    choose(forms, f"{at}.source.kind", "point")
    enter(qtbot, forms, f"{at}.source.rays", "5000")
    choose(forms, f"{at}.filter.kind", "gaussian")
    enter(qtbot, forms, f"{at}.filter.size[0]", "5")
    stage = stages(document)[0]
    assert (stage.iterations, stage.method, stage.learning_rate) == (12, "paper", 0.01)
    assert stage.control_points == (6, 7)
    assert (stage.source.kind, stage.source.rays) == ("point", 5000)
    assert stage.source.position == (0, 0, -5)
    assert stage.filter.size == (5, 3)
    assert listed(forms)[0] == (
        "1.  12 iterations, as in the paper, net of 6 × 7, point source, gaussian filter"
    )
    choose(forms, f"{at}.source.kind", "")
    choose(forms, f"{at}.filter.kind", "")
    choose(forms, f"{at}.method", "")
    enter(qtbot, forms, f"{at}.control_points[0]", "")
    assert stages(document)[0] == Stage(iterations=12)
    for path in ("learning_rate", "source.rays", "filter.size"):
        assert not row(forms, f"{at}.{path}", visible=False).isVisible()
