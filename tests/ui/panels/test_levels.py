"""Fields that a job needs are in view; others are folded, counted, found and revealed."""

from itertools import pairwise

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QToolButton

import resources
from tests.ui.hands import editor, enter, fill, row, rows
from ui.document.document import Document
from workbench.files.session import open_design

CTRL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def begin(open_forms):
    """Opens the forms of an example."""

    def opened_with(name):
        document = Document(open_design(resources.path("examples", f"{name}.json")), name)
        forms = open_forms(document)
        document.setParent(forms)
        return document, forms

    return opened_with


def seen(forms):
    return [each.path for each in rows(forms) if each.isVisible()]


def heading(forms, title):
    found = forms.findChildren(QToolButton, "heading")
    return next(each for each in found if each.text().startswith(title))


@pytest.mark.parametrize("name", ["photo", "led-dome", "mirror-letter", "street-light"])
def test_a_job_has_few_fields_in_view_and_no_bar_below_them(begin, name):
    _, forms = begin(name)
    forms.resize(320, 600)
    assert 10 <= len(seen(forms)) <= 16
    assert forms.horizontalScrollBar().maximum() == 0
    wanted = {"images[0].receiver.kind", "source.kind", "elements[0].half_width"}
    assert wanted <= set(seen(forms))
    assert "run.seed" not in seen(forms)


def test_a_group_is_unfolded_by_its_heading_and_stays_so(begin, qtbot, tmp_path):
    settings = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    _, forms = begin("photo")
    forms.remember(settings)
    qtbot.mouseClick(heading(forms, "Expert"), Qt.MouseButton.LeftButton)
    assert "run.seed" in seen(forms) and "run.min_radius" not in seen(forms)
    _, again = begin("photo")
    again.remember(settings)
    assert "run.seed" in seen(again) and "run.min_radius" not in seen(again)
    qtbot.mouseClick(heading(again, "Expert"), Qt.MouseButton.LeftButton)
    assert settings.value("form/expert", type=bool) is False


def test_a_folded_group_counts_the_values_that_are_not_by_default(forms, document, qtbot):
    before = heading(forms, "Expert").text()
    enter(qtbot, forms, "run.seed", "5")
    after = heading(forms, "Expert")
    assert int(after.text().split()[2]) == int(before.partition("· ")[2].split()[0] or 0) + 1
    assert "Run seed" in after.toolTip()
    enter(qtbot, forms, "run.seed", "0")
    assert heading(forms, "Expert").text() == before


def test_a_refused_field_is_revealed(begin, qtbot):
    _, forms = begin("photo")
    enter(qtbot, forms, "elements[0].min_thickness", "0.4")
    qtbot.mouseClick(heading(forms, "Limits"), Qt.MouseButton.LeftButton)
    assert not row(forms, "elements[0].min_thickness", visible=False).isVisible()
    enter(qtbot, forms, "elements[0].thickness", "-1")
    assert forms.refused
    blamed = [each for each in rows(forms) if each.refusal]
    assert blamed and all(each.isVisible() for each in blamed)


def test_a_search_finds_fields_of_all_levels_by_title_tip_and_path(forms, qtbot):
    before = seen(forms)
    qtbot.keyClick(editor(forms, "source.direction[0]"), Qt.Key.Key_F, CTRL)
    assert forms.search.hasFocus()
    for words, path in (
        ("seed", "run.seed"),
        ("random numbers", "run.seed"),
        ("run.min_tool_radius", "run.min_tool_radius"),
        ("MATERIAL", "elements[0].material"),
    ):
        fill(qtbot, forms.search, words, key=None)
        assert path in seen(forms) and "source.kind" not in seen(forms)
    fill(qtbot, forms.search, "zzz", key=None)
    assert seen(forms) == [] and forms._nothing.isVisible()
    qtbot.keyClick(forms.search, Qt.Key.Key_Escape)
    assert forms.search.text() == "" and seen(forms) == before


def test_enter_in_the_search_goes_to_the_first_field(forms, document, qtbot):
    fill(qtbot, forms.search, "seed")
    field = editor(forms, "run.seed")
    assert field.hasFocus()
    fill(qtbot, field, "7")
    assert document.session.scene.run.seed == 7


def test_tab_goes_through_the_fields_as_they_stand(forms, qtbot):
    forms.search.setFocus()
    met, last = [], heading(forms, "Expert")
    while forms.focusWidget() is not last:
        qtbot.keyClick(forms.focusWidget(), Qt.Key.Key_Tab)
        focused = forms.focusWidget()
        met.append(focused.mapTo(forms.widget(), focused.rect().center()).y())
    assert len(met) > 20
    assert all(
        after > before - 8 for before, after in pairwise(met)
    )  # those side by side are level


def test_a_found_field_stands_below_what_it_belongs_to(begin, qtbot):
    _, forms = begin("led-dome")
    fill(qtbot, forms.search, "number of control points", key=None)
    faces = [f"elements[0].faces[{k}]" for k in (0, 1)]
    wanted = [f"{face}.{name}" for face in faces for name in ("shape", "control_points")]
    assert seen(forms) == wanted
