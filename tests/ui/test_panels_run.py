"""The run panel: what is optimised, what that costs, and a learning rate that may be left out."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from ui.document import Document
from ui.panels.forms import Forms
from workbench.files.session import Session
from workbench.targets import load_target

PAPER_ONLY = ["run.parametrisation", "run.parameters", "run.start", "run.learning_rate"]


@pytest.fixture
def document(qapp, make_scene):
    scene = make_scene({"lens.control_points": [64, 64], "run": {"method": "paper"}})
    document = Document(Session(scene, load_target(scene, Path())), "small")
    yield document
    document.deleteLater()


@pytest.fixture
def rows(document, qtbot):
    forms = Forms(document)
    qtbot.addWidget(forms)
    forms.resize(330, 900)
    with qtbot.waitActive(forms):
        forms.show()
        forms.activateWindow()
    yield {row.path: row for panel in forms.panels for row in panel.rows}  # while forms lives


def choose(rows, path, value):
    chooser = rows[path].chooser
    chooser.setCurrentIndex(chooser.findData(value))
    chooser.activated.emit(chooser.currentIndex())


def enter(qtbot, rows, path, text):
    widget = rows[path.partition("[")[0]].editors[path]
    widget.setFocus()
    widget.selectAll()
    qtbot.keyClick(widget, Qt.Key.Key_Delete)
    qtbot.keyClicks(widget, text)
    qtbot.keyClick(widget, Qt.Key.Key_Return)


def rate(rows):
    return rows["run.learning_rate"].editors["run.learning_rate"]


def test_the_papers_settings_are_there_with_its_method_alone(rows, document):
    assert all(rows[path].isVisible() for path in PAPER_ONLY)
    choose(rows, "run.method", "auto")
    assert not any(rows[path].isVisible() for path in PAPER_ONLY)
    choose(rows, "run.method", "paper")
    assert all(rows[path].isVisible() for path in PAPER_ONLY)


def test_another_method_keeps_the_stages(qapp, qtbot, make_scene):
    scene = make_scene({"run": {"stages": [{"iterations": 2, "filter": {"size": [5, 5]}}]}})
    document = Document(Session(scene, load_target(scene, Path())), "staged")
    forms = Forms(document)
    qtbot.addWidget(forms)
    rows = {row.path: row for panel in forms.panels for row in panel.rows}
    choose(rows, "run.method", "paper")
    assert document.session.scene.run.method == "paper"
    assert document.session.scene.run.stages == scene.run.stages
    document.deleteLater()


@pytest.mark.parametrize(
    ("kind", "size"),
    [
        ("none", "4,096 (131 kB)"),
        ("sparse", "396,576 (6.35 MB)"),
        ("dense", "33,570,816 (537 MB)"),
    ],
)
def test_a_choice_shows_its_parameters_and_their_memory(rows, document, kind, size):
    choose(rows, "run.parametrisation", kind)
    assert document.session.scene.run.parametrisation == kind
    assert rows["run.parameters"].text == size


def test_the_size_follows_the_control_net(rows, qtbot):
    choose(rows, "run.parametrisation", "dense")
    enter(qtbot, rows, "lens.control_points[0]", "1024")
    enter(qtbot, rows, "lens.control_points[1]", "1024")
    assert rows["run.parameters"].text == "2,199,027,449,856 (35.2 TB)"


@pytest.mark.parametrize("start", ["uniform", "random", "zeros"])
def test_a_start_is_chosen(rows, document, start):
    choose(rows, "run.start", start)
    assert document.session.scene.run.start == start


def test_a_learning_rate_may_be_left_empty(rows, document, qtbot):
    assert (rate(rows).text(), rate(rows).placeholderText()) == ("", "0.003")
    choose(rows, "run.parametrisation", "dense")
    assert (rate(rows).text(), rate(rows).placeholderText()) == ("", "0.0001")
    enter(qtbot, rows, "run.learning_rate", "2e-3")
    assert document.session.scene.run.learning_rate == 2e-3
    assert rate(rows).text() == "0.002"
    enter(qtbot, rows, "run.learning_rate", "")
    assert document.session.scene.run.learning_rate is None
    assert rate(rows).text() == ""


@pytest.mark.parametrize("method", ["auto", "paper"])
@pytest.mark.parametrize(
    ("path", "unit"), [("run.smoothness", ""), ("run.min_radius", "cm")], ids=["weight", "radius"]
)
def test_bends_are_free_unless_asked(rows, document, qtbot, path, unit, method):
    choose(rows, "run.method", method)
    editor, field = rows[path].editors[path], path.removeprefix("run.")
    assert (editor.text(), editor.placeholderText()) == ("", "none")
    assert rows[path]._unit.text() == unit
    enter(qtbot, rows, path, "0.05")
    assert getattr(document.session.scene.run, field) == 0.05
    enter(qtbot, rows, path, "-1")
    assert "must be greater than 0" in rows[path].refusal
    enter(qtbot, rows, path, "")
    assert getattr(document.session.scene.run, field) is None
    assert (editor.text(), editor.placeholderText()) == ("", "none")


@pytest.mark.parametrize(
    ("text", "reason"), [("0", "must be greater than 0"), ("fast", "'fast' is not a number")]
)
def test_an_impossible_rate_is_refused_beside_it(rows, document, qtbot, text, reason):
    enter(qtbot, rows, "run.learning_rate", text)
    assert reason in rows["run.learning_rate"].refusal
    assert document.session.scene.run.learning_rate is None
    qtbot.keyClick(rate(rows), Qt.Key.Key_Escape)
    assert (rate(rows).text(), rows["run.learning_rate"].refusal) == ("", "")
