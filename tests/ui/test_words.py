"""The window in other languages."""

import ast
import re
from pathlib import Path

import pytest
from matplotlib.figure import Figure
from PySide6.QtCore import QLocale
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDialogButtonBox, QLabel

import ui
from ui.commands.table import COMMANDS
from ui.widgets.figures import translate, translate_axes
from ui.words import error_text, set_language, system_language, tr
from workbench.errors import Refused
from workbench.jobs import JOBS
from workbench.jobs.lenses import SunPlate


@pytest.fixture
def speaking(qapp):
    """Speaks a language until the test ends."""
    yield lambda language: set_language(qapp, language)
    set_language(qapp, "en")


def test_texts_are_english_without_a_dictionary():
    assert tr("{path} is written.") == "{path} is written."
    assert tr("There is no {optic} yet; Start designs one", optic="mirror") == (
        "There is no mirror yet; Start designs one"
    )
    assert tr("") == ""


@pytest.mark.parametrize(
    ("answers", "stated"),
    [
        (
            {"distance": 3.0},
            "distance: 3 kann die Linse berühren; mehr als 12.5, der höchste Wert, den die "
            "Austrittsfläche erreichen kann",
        ),
        ({"size": [-1.0, 100.0]}, "size[0]: -1.0 ist zu klein; nötig ist mehr als 0"),
        ({"material": "wood"}, "material: 'wood' gibt es nicht; erlaubt: "),
    ],
)
def test_refusals_are_stated_in_the_language_of_the_window(answers, stated, speaking):
    with pytest.raises(Refused) as refused:
        SunPlate(thickness=12.5).with_answers(answers)
    assert error_text(refused.value) == str(refused.value)
    speaking("de")
    assert error_text(refused.value).startswith(stated)


def test_labels_of_pictures_are_translated_and_units_stay(speaking):
    figure = Figure()
    axes = figure.subplots()
    axes.set_xlabel("z of the screen (mm)")
    axes.set_ylabel("× mean")
    axes.plot([0, 1], label="this run")
    axes.legend()
    translate(figure)
    assert axes.get_xlabel() == "z of the screen (mm)"
    speaking("de")
    translate(figure)
    (legend,) = axes.get_legend().get_texts()
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("z des Schirms (mm)", "× Mittel")
    assert legend.get_text() == "dieser Lauf"
    assert axes.legend().get_texts()[0].get_text() == "dieser Lauf"
    axes.set_xlabel("x (mm) at y = 0.5 mm")
    axes.set_ylabel("distance (mm)")
    translate_axes(figure)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x (mm) bei y = 0.5 mm", "Abstand (mm)")
    axes.set_xlabel("x (10⁻³ m) at y = 0.5 m")
    axes.set_ylabel("10³ × mean / mm")
    translate_axes(figure)
    assert (axes.get_xlabel(), axes.get_ylabel()) == (
        "x (10⁻³ m) bei y = 0.5 m",
        "10³ × Mittel / mm",
    )


@pytest.mark.parametrize(
    ("wanted", "expected"), [(["fr-CH", "de"], "fr"), (["nl", "de-AT"], "de"), (["nl"], "en")]
)
def test_the_system_chooses_the_first_language_that_there_is(monkeypatch, wanted, expected):
    monkeypatch.setattr(QLocale, "uiLanguages", lambda _: wanted)
    assert system_language() == expected


@pytest.mark.parametrize(
    ("language", "menu", "check", "dock", "field", "cancel"),
    [
        ("de", "&Datei", "Linse p&rüfen", "Bestrahlungsstärke", "Größe", "Abbrechen"),
        (
            "fr",
            "&Fichier",
            "Vérifier la &lentille",
            "Éclairement",
            "Taille",
            "Annuler",
        ),
    ],
)
def test_a_window_is_translated(speaking, open_window, language, menu, check, dock, field, cancel):
    speaking(language)
    window = open_window()
    assert window.menuBar().actions()[0].text() == menu
    assert window.commands["check"].text() == check
    titles = [action.text() for action in window.panes.images.findChildren(QAction)]
    assert dock in titles
    labels = {label.text() for label in window.forms.findChildren(QLabel)}
    assert field in labels
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel, window)
    assert buttons.button(QDialogButtonBox.StandardButton.Cancel).text().replace("&", "") == cancel


def test_no_command_and_no_job_stays_english(speaking, open_window):
    speaking("de")
    window = open_window()
    alike = {"Auto", "English", "Deutsch", "Français", "Inferno", "Viridis", "Cividis", "&Start"}
    alike |= {"&Pause", "Ball, 512 × 512", "Ball"}
    for name, command in COMMANDS.items():
        if name not in ("undo", "redo") and command.text.replace("{optic}", "lens") not in alike:
            assert window.commands[name].text() != command.text.replace("{optic}", "lens"), name
    jobs = window.start_page.jobs
    titles = [jobs.item(number).text() for number in range(len(JOBS))]
    assert titles[:2] == ["Platte in der Sonne", "Taschenlampe oder Telefon"]
    assert "Mirror" not in titles


# What shows a text that it is given first, or by one of these names.
SHOWS = {
    *(
        "QAction",
        "QCheckBox",
        "QLabel",
        "QMenu",
        "QPushButton",
        "QToolBar",
        "addAction",
    ),
    *("addButton", "addItem", "addMenu", "addTab", "note", "setAccessibleName", "setEmptyLabel"),
    *("setPlaceholderText", "setStatusTip", "setText", "setTitle", "setToolTip", "setWindowTitle"),
    *("showMessage", "tell", "warn", "say", "add_toggle"),
}
NAMED = {"placeholderText", "text", "toolTip", "windowTitle"}
_WORD = re.compile(r"[A-Za-zÄ-ÿ]{2,}")


def texts_that_bypass(tree):
    """Literals with words that are shown without a translation, and their lines."""
    marked = {
        target.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and getattr(node.value, "func", None) is not None
        for target in node.targets
        if isinstance(target, ast.Name) and getattr(node.value.func, "id", "") == "later"
    }
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        called = getattr(call.func, "id", getattr(call.func, "attr", ""))
        shown = [word.value for word in call.keywords if word.arg in NAMED]
        if called in SHOWS:
            shown += call.args[:1]
        for part in shown:
            if isinstance(part, ast.Name) and part.id in marked:
                yield part.lineno, part.id
            for text in literals(part):
                if _WORD.search(re.sub(r"</?\w+>", "", text)):
                    yield part.lineno, text


def literals(node):
    """Literal texts of what is shown, those that are joined or chosen from included."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.JoinedStr):
        yield "".join(part.value for part in node.values if isinstance(part, ast.Constant))
    elif isinstance(node, ast.IfExp):
        yield from literals(node.body)
        yield from literals(node.orelse)
    elif isinstance(node, ast.BinOp):
        yield from literals(node.left)
        yield from literals(node.right)


def test_no_text_is_shown_that_is_not_translated():
    found = {
        f"{file.name}:{line}": text
        for file in Path(ui.__file__).parent.rglob("*.py")
        for line, text in texts_that_bypass(ast.parse(file.read_text(encoding="utf-8")))
    }
    assert not found, f"shown as they are: {found}; wrap each in `ui.words.tr`"
