"""The window in other languages."""

import ast
import re
from dataclasses import replace
from pathlib import Path
from typing import get_args

import pytest
import torch
from matplotlib.backend_bases import MouseEvent
from matplotlib.figure import Figure
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QDialogButtonBox, QLabel, QWidget

import ui
import workbench
import workbench.pictures
import workbench.scene
from tests.ui.hands import rows
from ui.commands.language_choice import LANGUAGE
from ui.commands.table import COMMANDS
from ui.jobs.page import StartPage
from ui.run.comparison import RunComparison
from ui.run.kept import called, renamed, with_followed, with_run
from ui.widgets.plot_words import LABELS, translate, translate_axes
from ui.words import begun, error_text, inside, later, speak, spoken, spoken_by_system, tr
from workbench.design.endings import IN_VAIN, SMALL
from workbench.design.loss import check_light
from workbench.design.origin import origin
from workbench.design.shortfall import Cause, Shortfall
from workbench.design.snapshot import History
from workbench.errors import Refused, RunFailed
from workbench.files.session import open_design, read_session, write_session
from workbench.jobs import JOBS
from workbench.jobs.sun_plate import SunPlate
from workbench.optics.account import Account
from workbench.said import Said


@pytest.fixture
def speaking(qapp):
    """Speaks a language until the test ends."""
    yield lambda language: speak(qapp, language)
    speak(qapp, "en")


def test_texts_are_english_without_a_dictionary():
    assert tr("{path} is written.") == "{path} is written."
    assert tr("There is no {optic} yet: Start designs one", optic="mirror") == (
        "There is no mirror yet: Start designs one"
    )
    assert tr("") == ""


def test_another_language_can_be_chosen_again(speaking):
    speaking("de")
    assert (tr("&Open…"), spoken()) == ("&Öffnen …", "de")
    speaking("fr")
    assert (tr("&Open…"), spoken()) == ("&Ouvrir…", "fr")
    speaking("en")
    assert (tr("&Open…"), spoken()) == ("&Open…", "en")


def test_a_text_without_a_translation_stays_english(speaking):
    speaking("de")
    assert tr("No dictionary has this.") == "No dictionary has this."


def test_sentences_agree_with_the_optic(speaking):
    speaking("de")
    said = {tr("There is no {optic} yet: Start designs one", optic=o) for o in ("lens", "mirror")}
    assert said == {
        "Es gibt noch keine Linse: Start entwirft eine",
        "Es gibt noch keinen Spiegel: Start entwirft einen",
    }


def test_sentences_of_the_engine_keep_their_values(speaking):
    net = Said("{n_u} × {n_v} control points, {n_x} × {n_y} pixels", n_u=9, n_v=8, n_x=7, n_y=6)
    thick = Said("{height:.3g} {unit} thick, {net}", height=2.5, unit="mm", net=net)
    caught = Said("Light on the {optic}", optic="mirror")
    assert tr(thick) == thick == "2.5 mm thick, 9 × 8 control points, 7 × 6 pixels"
    speaking("de")
    assert tr(thick) == "2.5 mm dick, 9 × 8 Kontrollpunkte, 7 × 6 Pixel"
    assert tr(caught) == "Licht auf dem Spiegel"


@pytest.mark.parametrize(
    ("answers", "said"),
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
def test_refusals_are_said_in_the_language_of_the_window(answers, said, speaking):
    with pytest.raises(Refused) as refused:
        SunPlate(thickness=12.5).with_answers(answers)
    assert error_text(refused.value) == str(refused.value)
    speaking("de")
    assert error_text(refused.value).startswith(said)


def test_a_run_that_fails_says_why_in_the_language_of_the_window(speaking):
    dark = "no light of this lens reaches the screen, so there is nothing to see"
    speaking("fr")
    assert error_text(RunFailed(Said(dark))).startswith("aucune lumière")


def test_light_that_is_lost_is_named_in_the_language_of_the_window(make_scene, speaking):
    account = Account(0.0, {"total_reflection": 0.9, "missed_lens": 0.1})
    with pytest.raises(RunFailed) as failed:
        check_light(torch.zeros(2, 2), account, make_scene())
    assert error_text(failed.value) == str(failed.value)
    assert "of the emitted light 10.0% misses the lens, 90.0% is totally refl" in str(failed.value)
    speaking("de")
    said = error_text(failed.value)
    assert said.startswith("kein Licht erreicht den Schirm: vom ausgesandten Licht 10.0% verfehlt")
    assert said.endswith("das weniger Ablenkung braucht, lässt es hinaus")


def test_advice_on_lost_light_is_said_in_the_language_of_the_window(make_scene, speaking):
    lost = {"missed_lens": 0.1, "total_reflection": 0.8}
    advice = Account(0.1, lost).advice(make_scene())
    speaking("de")
    assert tr(advice) == (
        "Nur 10.0 % des Lichts kommen auf dem Schirm an; 80 % wird totalreflektiert: dickeres "
        "Material, ein kleinerer Brechungsindex oder ein Ziel, das weniger Ablenkung braucht, "
        "lässt es hinaus."
    )


@pytest.mark.parametrize("cause", get_args(Cause))
@pytest.mark.parametrize("needed", [None, (-1.0, 3.4)])
def test_limits_that_are_too_narrow_are_said_in_the_language_of_the_window(
    make_scene, speaking, cause, needed
):
    entrance = {"shape": "freeform", "height_range": [-0.1, 0.1]}
    short, scene = (
        Shortfall(cause, needed, (-0.2, 0.3), 0.4),
        make_scene({"lens.entrance": entrance}),
    )
    said = short.in_full(scene)
    speaking("de")
    words = re.sub(r"\w+(\.\w+)+", "", tr(said))  # paths of fields are the same everywhere
    assert not re.search(r"\b(the|of|to|is|are|range|lens)\b", words, re.IGNORECASE)
    cure = short.cure_in(scene)
    assert str(cure) in said and tr(cure) in tr(said)


def test_a_narrow_height_range_has_its_numbers_in_other_languages(make_scene, speaking):
    short = Shortfall("height_range", (-2.2, 2.2), (-0.2, 0.3), 0.4)
    speaking("fr")
    assert tr(short.sentence(make_scene())) == (
        "La lentille a besoin de ±2.2 cm\N{NO-BREAK SPACE}; la limite est de -0.2 à 0.3 cm"
    )


def test_refusals_of_files_are_said_in_the_language_of_the_window(tmp_path, speaking):
    with pytest.raises(Refused) as refused:
        open_design(tmp_path / "none.json")
    speaking("fr")
    assert error_text(refused.value).endswith(
        "n'existe pas ; il faut le nom d'un fichier".replace(" ;", "\u00a0;")
    )


# What only the command line and scripts are told.
_NO_WINDOW = re.compile(r"(cli|sweep|analysis/benchmark)/|analysis/mitsuba|scene/further_image")


def test_what_a_window_shows_of_refusals_has_words_and_values_apart():
    root = Path(workbench.__file__).parent
    found = [
        f"{name}:{call.lineno}"
        for file in sorted(root.rglob("*.py"))
        if not _NO_WINDOW.match(name := file.relative_to(root).as_posix())
        for call in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(call, ast.Call)
        and getattr(call.func, "id", "") in ("Refused", "RunFailed")
        and any(literals(call.args[-1]))
    ]
    assert not found, f"said in English alone: {found}; use `workbench.said.Said`"


def test_why_a_run_ended_is_said_in_the_language_of_the_window_from_a_file(
    session, history, tmp_path, speaking
):
    ended = Said(IN_VAIN, ended=Said(SMALL, error=0.1))
    result = replace(history(5).result(), ended=ended)
    write_session(replace(session, result=result), tmp_path / "one.freeform")
    found = read_session(tmp_path / "one.freeform").result.ended
    speaking("de")
    assert tr(found) == "konvergiert: Fehler unter 0.1 %; keine Iteration hat die Linse verbessert"


def test_a_run_that_failed_is_said_in_the_language_of_the_window(snapshots, speaking):
    def failing():
        yield snapshots(0, 3)
        raise RunFailed(Said("no light reaches the lens"))

    history = History()
    with pytest.raises(RunFailed):
        list(history.follow(failing()))
    assert history.result().ended == "failed: no light reaches the lens"
    speaking("fr")
    assert tr(history.result().ended).startswith("échec\u00a0: ")


def test_what_a_lens_was_designed_for_is_said_in_the_language_of_the_window(
    session, history, speaking
):
    session, _ = with_run(session, history(5).result())
    screen = session.scene.receiver.model_copy(update={"z": 7.0})
    other = session.with_scene(session.scene.with_receiver(screen), session.target)
    found = origin(other, called)
    assert found == origin(other)
    speaking("de")
    assert tr(origin(other, called)) == (
        "für eine andere Aufgabe entworfen (Lauf 1: auto, 12 × 10): screen.z 5.0, jetzt 7.0"
    )


def test_names_that_the_program_gives_to_runs_are_said_in_the_language_of_the_window(
    session, history, speaking
):
    session, _ = with_run(session, history(5).result())
    session, _ = with_followed(session, history(6).result())
    own = renamed(session, session.runs[0], "Flame").runs[0]
    assert [called(run) for run in (*session.runs, own)] == [
        *(run.name for run in session.runs),
        "Flame",
    ]
    speaking("de")
    assert [called(run) for run in (*session.runs, own)] == [
        "Lauf 1: auto, 12 × 10",
        "Gefolgt 2: auto, 12 × 10",
        "Flame",
    ]


def test_labels_of_pictures_are_translated_and_units_stay(speaking):
    figure = Figure()
    axes = figure.subplots()
    axes.set_xlabel("z of the screen (mm)")
    axes.set_ylabel("flux / mm²")
    axes.plot([0, 1], label="this run")
    axes.legend()
    translate(figure)
    assert axes.get_xlabel() == "z of the screen (mm)"
    speaking("de")
    translate(figure)
    (legend,) = axes.get_legend().get_texts()
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("z des Schirms (mm)", "Fluss / mm²")
    assert legend.get_text() == "dieser Lauf"
    assert axes.legend().get_texts()[0].get_text() == "dieser Lauf"
    axes.set_xlabel("x (mm) at y = 0.5 mm")
    axes.set_ylabel("distance (mm)")
    translate_axes(figure)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x (mm) bei y = 0.5 mm", "Abstand (mm)")
    axes.set_xlabel("x (10⁻³ m) at y = 0.5 m")
    axes.set_ylabel("10⁻⁶ flux / mm²")
    translate_axes(figure)
    assert (axes.get_xlabel(), axes.get_ylabel()) == (
        "x (10⁻³ m) bei y = 0.5 m",
        "10⁻⁶ Fluss / mm²",
    )


def test_two_runs_are_compared_in_the_language_that_is_spoken(session, history, speaking, qtbot):
    session, _ = with_run(session, history(5).result())
    session, _ = with_run(session, history(6).result())
    session = renamed(session, session.runs[1], "target")  # a word of pictures, but a name here
    speaking("de")
    window = QWidget()
    qtbot.addWidget(window)
    shown = RunComparison(lambda run: "", window)
    shown.show_pair(session.runs)
    axes = shown._figure.axes
    titles = ["Lauf 1: auto, 12 × 10", "target"]
    assert [each.get_title() for each in axes] == [
        *titles,
        "Zweites minus erstes",
        "Zielfunktion",
    ]
    assert [text.get_text() for text in axes[3].get_legend().get_texts()] == titles
    assert (axes[3].get_xlabel(), axes[3].get_ylabel()) == ("Iteration", "Zielfunktion")
    assert {each.child_axes[0].get_ylabel() for each in axes[:3]} == {"Fluss / cm²"}
    place = axes[0].transData.transform((0.5, 0.25))
    MouseEvent("motion_notify_event", shown._canvas, *place)._process()
    assert shown.readout == "0.25 → 0.25 / cm² bei x = 0.5 cm, y = 0.25 cm"


def test_labels_stand_in_the_pictures_of_the_engine():
    folder = Path(workbench.pictures.__file__).parent
    code = "".join(file.read_text(encoding="utf-8") for file in folder.glob("*.py"))
    code += Path(workbench.scene.__file__).parent.joinpath("screen.py").read_text(encoding="utf-8")
    code += Path(workbench.scene.__file__).parent.joinpath("far_field.py").read_text("utf-8")
    assert [label for label in LABELS if label not in code] == []


@pytest.mark.parametrize(
    ("language", "title", "expected"),
    [
        ("en", "Control points", "control points"),
        ("en", "LED size", "LED size"),
        ("en", "", ""),
        ("fr", "Épaisseur", "épaisseur"),
        ("de", "Dicke", "Dicke"),
    ],
)
def test_titles_are_small_inside_of_sentences_but_for_german(speaking, language, title, expected):
    speaking(language)
    assert inside(title) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("light grazes the wall", "Light grazes the wall"),
        ("étendue", "Étendue"),
        ("λ / width of the lens", "λ / width of the lens"),
        ("√(λ · distance)", "√(λ · distance)"),
        ("", ""),
    ],
)
def test_a_sentence_begins_with_a_large_letter_but_symbols_stay(text, expected):
    assert begun(text) == expected


def test_tables_stay_as_they_are():
    table = {"key": ("Title", "tip")}
    assert later(table) is table


def test_an_unknown_language_is_refused(speaking):
    with pytest.raises(ValueError, match="'xx' is none of en, de, fr"):
        speaking("xx")


@pytest.mark.parametrize(
    ("wanted", "expected"), [(["fr-CH", "de"], "fr"), (["nl", "de-AT"], "de"), (["nl"], "en")]
)
def test_the_system_chooses_the_first_language_that_there_is(monkeypatch, wanted, expected):
    monkeypatch.setattr(QLocale, "uiLanguages", lambda _: wanted)
    assert spoken_by_system() == expected


@pytest.mark.parametrize(
    ("language", "menu", "check", "dock", "field", "cancel"),
    [
        ("de", "&Datei", "Linse p&rüfen", "Bestrahlungsstärke", "Halbbreite", "Abbrechen"),
        (
            "fr",
            "&Fichier",
            "Vérifier la &lentille",
            "Éclairement énergétique",
            "Demi-largeur",
            "Annuler",
        ),
    ],
)
def test_a_window_is_translated(speaking, open_window, language, menu, check, dock, field, cancel):
    speaking(language)
    window = open_window()
    assert window.menuBar().actions()[0].text() == menu
    assert window.commands["check"].text() == check
    assert window.workspace.docks["irradiance"].windowTitle() == dock
    labels = {label.text() for label in window.forms.findChildren(QLabel)}
    assert field in labels
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel, window)
    assert buttons.button(QDialogButtonBox.StandardButton.Cancel).text().replace("&", "") == cancel


def test_materials_are_called_as_people_call_them(speaking, open_window):
    speaking("de")
    forms = open_window().forms
    material = next(each for each in rows(forms) if each.path == "lens.refractive_index")
    called = [material.chooser.itemText(k) for k in range(material.chooser.count())]
    assert called == ["Eigene Brechzahl", "PMMA", "PC", "PS", "N-BK7", "Quarzglas"]


def test_no_command_and_no_job_stays_english(speaking, open_window):
    speaking("de")
    window = open_window()
    alike = {"Auto", "English", "Deutsch", "Français", "Inferno", "Viridis", "Cividis", "&Start"}
    alike |= {"&Pause", "Ball, 512 × 512", "Ball"}
    for name, command in COMMANDS.items():
        if name not in ("undo", "redo") and command.text.replace("{optic}", "lens") not in alike:
            assert window.commands[name].text() != command.text.replace("{optic}", "lens"), name
    page = StartPage(window.early.dialogs, window)
    titles = [page._jobs.item(number).text() for number in range(len(JOBS))]
    page.reject()
    assert titles[:2] == ["Platte in der Sonne", "Taschenlampe oder Telefon"]
    assert "Mirror" not in titles


def test_a_chosen_language_is_kept_and_reported_to_count_from_the_next_start(window, settings):
    assert LANGUAGE.kept(settings) == "system"
    window.commands["language_fr"].trigger()
    assert LANGUAGE.kept(settings) == "fr"
    assert window.messages.text == "The language changes at the next start."
    assert window.commands["language_fr"].isChecked()


def test_choosing_the_present_language_is_not_reported(window, settings):
    window.commands["language_en"].trigger()
    assert (LANGUAGE.kept(settings), window.messages.text) == ("en", "")


def test_an_unknown_choice_is_that_of_the_system(settings):
    settings.setValue("window/language", "tlh")
    assert LANGUAGE.kept(settings) == "system"


# What shows a text that it is given first, or by one of these names.
SHOWS = {
    *(
        "QAction",
        "QCheckBox",
        "QLabel",
        "QMenu",
        "QPushButton",
        "QToolBar",
        "MenuButton",
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


@pytest.mark.parametrize(
    ("shown", "bypasses"),
    [
        ('label.setText("Ready")', True),
        ('QLabel(f"Moved by {x} mm")', True),
        ('field.setToolTip("Wide" if wide else tr("Narrow"))', True),
        ('QLineEdit(placeholderText="Type here")', True),
        ('_HINT = later("Ready")\nlabel.setText(_HINT)', True),
        ('_HINT = later("Ready")\nlabel.setText(tr(_HINT))', False),
        ('label.setText(tr("Ready"))', False),
        ('label.setText(f"<b>{name}</b>")', False),
        ('label.setText("…")', False),
        ('widget.setObjectName("figures")', False),
    ],
)
def test_texts_that_bypass_translation_are_found(shown, bypasses):
    assert bool(list(texts_that_bypass(ast.parse(shown)))) is bypasses
