"""The run panel: what is optimised, what that costs, and a learning rate that may be left out."""

import pytest
from PySide6.QtCore import Qt

from tests.ui.hands import choose, editor, enter, row
from ui.document.document import Document

PAPER_ONLY = ["run.parametrisation", "run.parameters", "run.start", "run.learning_rate"]


@pytest.fixture
def session(make_session):
    return make_session({"lens.control_points": [64, 64], "run": {"method": "paper"}})


def rate(forms):
    return editor(forms, "run.learning_rate")


def test_the_papers_settings_are_there_with_its_method_alone(forms, document):
    assert all(row(forms, path).isVisible() for path in PAPER_ONLY)
    choose(forms, "run.method", "auto")
    assert not any(row(forms, path, visible=False).isVisible() for path in PAPER_ONLY)
    choose(forms, "run.method", "paper")
    assert all(row(forms, path).isVisible() for path in PAPER_ONLY)


def test_another_method_keeps_the_stages(make_session, open_forms):
    session = make_session({"run": {"stages": [{"iterations": 2, "filter": {"size": [5, 5]}}]}})
    document = Document(session, "staged")
    forms = open_forms(document)
    document.setParent(forms)
    choose(forms, "run.method", "paper")
    assert document.session.scene.run.method == "paper"
    assert document.session.scene.run.stages == session.scene.run.stages


@pytest.mark.parametrize(
    ("kind", "size"),
    [
        ("none", "4,096 (131 kB)"),
        ("sparse", "396,576 (6.35 MB)"),
        ("dense", "33,570,816 (537 MB)"),
    ],
)
def test_a_choice_shows_its_parameters_and_their_memory(forms, document, kind, size):
    choose(forms, "run.parametrisation", kind)
    assert document.session.scene.run.parametrisation == kind
    assert row(forms, "run.parameters").text == size


def test_the_size_follows_the_control_net(forms, qtbot):
    choose(forms, "run.parametrisation", "dense")
    enter(qtbot, forms, "lens.control_points[0]", "1024")
    enter(qtbot, forms, "lens.control_points[1]", "1024")
    assert row(forms, "run.parameters").text == "2,199,027,449,856 (35.2 TB)"


@pytest.mark.parametrize("start", ["uniform", "random", "zeros"])
def test_a_start_is_chosen(forms, document, start):
    choose(forms, "run.start", start)
    assert document.session.scene.run.start == start


def test_a_learning_rate_may_be_left_empty(forms, document, qtbot):
    assert (rate(forms).text(), rate(forms).placeholderText()) == ("", "0.003")
    choose(forms, "run.parametrisation", "dense")
    assert (rate(forms).text(), rate(forms).placeholderText()) == ("", "0.0001")
    enter(qtbot, forms, "run.learning_rate", "2e-3")
    assert document.session.scene.run.learning_rate == 2e-3
    assert rate(forms).text() == "0.002"
    enter(qtbot, forms, "run.learning_rate", "")
    assert document.session.scene.run.learning_rate is None
    assert rate(forms).text() == ""


@pytest.mark.parametrize("method", ["auto", "paper"])
@pytest.mark.parametrize(
    ("path", "unit"), [("run.smoothness", ""), ("run.min_radius", "cm")], ids=["weight", "radius"]
)
def test_limits_of_curvature_may_be_left_empty(forms, document, qtbot, path, unit, method):
    choose(forms, "run.method", method)
    typed, field = editor(forms, path), path.removeprefix("run.")
    assert (typed.text(), typed.placeholderText()) == ("", "none")
    assert row(forms, path)._unit.text() == unit
    enter(qtbot, forms, path, "0.05")
    assert getattr(document.session.scene.run, field) == 0.05
    enter(qtbot, forms, path, "-1")
    assert "must be greater than 0" in row(forms, path).refusal
    enter(qtbot, forms, path, "")
    assert getattr(document.session.scene.run, field) is None
    assert (typed.text(), typed.placeholderText()) == ("", "none")


@pytest.mark.parametrize(
    ("text", "reason"), [("0", "must be greater than 0"), ("fast", "'fast' is not a number")]
)
def test_an_impossible_rate_is_refused_beside_it(forms, document, qtbot, text, reason):
    enter(qtbot, forms, "run.learning_rate", text)
    assert reason in row(forms, "run.learning_rate").refusal
    assert document.session.scene.run.learning_rate is None
    qtbot.keyClick(rate(forms), Qt.Key.Key_Escape)
    assert (rate(forms).text(), row(forms, "run.learning_rate").refusal) == ("", "")
