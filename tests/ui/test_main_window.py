from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QMessageBox

from resources import EXAMPLES
from tests.ui.hands import drop, editor, open_example
from ui.commands.table import COMMANDS
from workbench.files.session import Session, read_session
from workbench.scene import Scene
from workbench.targets import load_target

pytestmark = pytest.mark.usefixtures("kernels")

SAVE, DISCARD, CANCEL = (
    QMessageBox.StandardButton.Save,
    QMessageBox.StandardButton.Discard,
    QMessageBox.StandardButton.Cancel,
)


def small_session(iterations=2):
    scene = Scene.from_data(
        {
            "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [6, 6]},
            "source": {"kind": "collimated", "rays": [16, 16]},
            "screen": {"z": 5, "half_width": [1, 1], "pixels": [8, 8]},
            "target": {"builtin": "tophat"},
            "run": {"method": "paper", "iterations": iterations},
        }
    )
    return Session(scene, load_target(scene, Path()))


@pytest.fixture
def answers(monkeypatch):
    """Answers to the questions to come; each is used once."""
    given = []

    def question(*_):
        return given.pop(0)

    monkeypatch.setattr(QMessageBox, "question", question)
    return given


@pytest.fixture
def session():
    return small_session()


@pytest.fixture
def window(answers, window):
    yield window
    assert not answers, "a question that was expected was not asked"


@pytest.fixture
def built(window):
    window.build()
    return window


def edit(window, z):
    editor(window.forms, "images[0].receiver.position[2]").setText(str(z))
    window.forms.commit()


def wait_for_idle(window, qtbot):
    qtbot.waitUntil(lambda: window.loaded.control.runner.state == "idle", timeout=60_000)


def test_the_title_shows_name_and_changes(window, tmp_path):
    assert window.windowTitle() == "small[*] - Freeform Lens Workbench"
    assert not window.isWindowModified()
    edit(window, 7)
    assert window.isWindowModified()
    window.document.save(tmp_path / "mine.freeform")
    assert window.windowTitle() == "mine[*] - Freeform Lens Workbench"
    assert not window.isWindowModified()


def test_undo_in_a_field_takes_typing_back_first_then_the_edit(window, qtbot):
    field = editor(window.forms, "images[0].receiver.position[2]")
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "7")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    qtbot.keyClicks(field, "5")
    qtbot.keyClick(field, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert field.text() == "7"
    assert window.document.session.scene.receiver.z == 7
    qtbot.keyClick(field, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert window.document.session.scene.receiver.z == 5


def test_shortcuts_are_unique():
    keys = [str(command.shortcut) for command in COMMANDS.values() if command.shortcut]
    assert len(keys) == len(set(keys))


def test_text_still_being_typed_is_saved(window, tmp_path, monkeypatch):
    path = tmp_path / "mine.freeform"
    monkeypatch.setattr(window.dialogs, "to_save", lambda *_: path)
    editor(window.forms, "images[0].receiver.position[2]").setText("8")
    window.commands["save"].trigger()
    assert read_session(path).scene.receiver.z == 8


def test_a_save_that_fails_is_reported(window, tmp_path, monkeypatch):
    monkeypatch.setattr(window.dialogs, "to_save", lambda *_: tmp_path / "no" / "a.freeform")
    window.commands["save"].trigger()
    assert str(tmp_path / "no") in window.messages.text
    assert window.messages.isVisible()


@pytest.mark.parametrize(
    ("answer", "closed", "saved"),
    [(SAVE, True, True), (DISCARD, True, False), (CANCEL, False, False)],
)
def test_closing_asks_before_changes_are_lost(
    window, answers, answer, closed, saved, tmp_path, monkeypatch
):
    path = tmp_path / "mine.freeform"
    monkeypatch.setattr(window.dialogs, "to_save", lambda *_: path)
    edit(window, 7)
    answers.append(answer)
    assert window.close() is closed
    assert path.exists() is saved


def test_a_new_design_asks_before_changes_are_lost(window, answers):
    edit(window, 7)
    answers.append(CANCEL)
    open_example(window, "flame")
    assert window.document.session.scene.receiver.z == 7
    answers.append(DISCARD)
    open_example(window, "flame")
    assert window.document.name == "flame"


def test_an_example_begins_an_untitled_design(window):
    name = "flame"
    open_example(window, name)
    assert window.windowTitle().startswith(f"{name}[*]")
    assert window.document.path is None
    assert name in window.document.session.scene.target.image
    (look,) = (example.look for example in EXAMPLES if example.name == name)
    assert window.messages.text == look


def test_a_refused_file_is_reported_and_changes_nothing(window, tmp_path):
    bad = tmp_path / "bad.freeform"
    bad.write_bytes(b"PK but no zip")
    session = window.document.session
    window.files.open(bad)
    assert "bad.freeform" in window.messages.text
    assert window.document.session is session
    assert window.commands.menus["Open &recent"].isEmpty()


def test_recent_files_are_kept_and_removed_when_missing(window, tmp_path, settings):
    paths = [tmp_path / f"{number}.freeform" for number in range(12)]
    for path in paths:
        window.document.save(path)
        window.files.open(path)
    menu = window.commands.menus["Open &recent"]
    digits = "1234567890"  # as mnemonics
    wanted = [f"&{k} {path}" for k, path in zip(digits, paths[:1:-1], strict=True)]
    assert [action.text() for action in menu.actions()] == wanted
    paths[-1].unlink()
    menu.actions()[0].trigger()
    assert str(paths[-1]) in window.messages.text
    assert menu.actions()[0].text() == f"&1 {paths[-2]}"


def test_a_dropped_image_becomes_the_target(window, tmp_path):
    image = tmp_path / "target.png"
    Image.fromarray(np.eye(8, dtype=np.uint8) * 255).save(image)
    drop(window, image)
    assert window.document.session.scene.target.image == str(image)
    np.testing.assert_allclose(window.document.session.target, np.eye(8))


def test_a_picture_that_is_opened_is_offered_as_the_target(window, tmp_path, qtbot, monkeypatch):
    image = tmp_path / "target.png"
    Image.fromarray(np.eye(8, dtype=np.uint8) * 255).save(image)
    monkeypatch.setattr(window.dialogs, "to_open", lambda *_: image)
    before = window.document.session
    window.commands["open"].trigger()
    assert window.messages.text == "target.png is a picture, not a design."
    assert window.document.session is before
    (button,) = window.messages.buttons
    assert button.text() == "Use as target"
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert window.document.session.scene.target.image == str(image)
    assert window.document.undo_stack.count() == 1
    assert window.messages.text == ""


def test_a_dropped_design_is_opened(window, tmp_path):
    path = tmp_path / "other.json"
    path.write_text(small_session().scene.model_copy(update={"unit": "inch"}).to_json())
    drop(window, path)
    assert window.document.session.scene.unit == "inch"


def test_a_run_leaves_its_result_as_one_step(built, qtbot):
    with qtbot.waitSignal(built.loaded.control.ended, timeout=60_000):
        built.commands["start"].trigger()
        assert not built.commands["open"].isEnabled()
        assert not built.commands["undo"].isEnabled()
    result = built.document.session.result
    assert result.iterations == 2
    assert built.isWindowModified()
    assert built.commands["undo"].text() == "&Undo design run"
    with qtbot.waitSignal(built.loaded.control.ended, timeout=60_000):
        built.commands["continue"].trigger()
    assert built.document.session.result.iterations == 4
    built.commands["undo"].trigger()
    assert built.document.session.result is result
    built.commands["undo"].trigger()
    assert built.document.session.result is None
    assert not built.commands["continue"].isEnabled()


def test_a_saved_run_goes_on_after_it_is_opened(built, qtbot, tmp_path):
    with qtbot.waitSignal(built.loaded.control.ended, timeout=60_000):
        built.commands["start"].trigger()
    path = tmp_path / "run.freeform"
    built.document.save(path)
    open_example(built, "flame")
    assert not built.commands["continue"].isEnabled()
    built.files.open(path)
    with qtbot.waitSignal(built.loaded.control.ended, timeout=60_000):
        built.commands["continue"].trigger()
    assert built.document.session.result.iterations == 4


def test_pause_and_stop(built, qtbot):
    built.document.edit(small_session(100_000).scene, "many iterations", "run.iterations")
    built.commands["start"].trigger()
    built.commands["pause"].trigger()
    assert built.loaded.control.runner.state == "paused"
    assert built.commands["pause"].isChecked()
    built.commands["pause"].trigger()
    assert built.loaded.control.runner.state == "running"
    assert not built.commands["pause"].isChecked()
    built.commands["stop"].trigger()
    wait_for_idle(built, qtbot)
    assert built.document.session.result.iterations < 100_000


def test_a_run_that_cannot_begin_is_reported(built, qtbot, monkeypatch):
    scene = built.document.session.scene
    run = scene.run.model_copy(update={"device": "cuda"})
    monkeypatch.setattr("torch.cuda.is_available", lambda: False)
    built.document.edit(scene.model_copy(update={"run": run}), "device", "run.device")
    built.commands["start"].trigger()
    wait_for_idle(built, qtbot)
    qtbot.waitUntil(lambda: "run.device" in built.messages.text)
    assert built.document.session.result is None


@pytest.mark.parametrize(("answer", "saved"), [(SAVE, True), (DISCARD, False)])
def test_closing_during_a_run_stops_it(built, qtbot, answers, answer, saved, tmp_path, monkeypatch):
    path = tmp_path / "run.freeform"
    monkeypatch.setattr(built.dialogs, "to_save", lambda *_: path)
    built.document.edit(small_session(100_000).scene, "many iterations", "run.iterations")
    built.commands["start"].trigger()
    qtbot.wait(100)
    answers.append(answer)
    built.close()
    qtbot.waitUntil(lambda: not built.isVisible(), timeout=60_000)
    assert path.exists() is saved
    if saved:
        assert read_session(path).result is not None


def test_the_camera_turns_to_an_axis_and_back(built, qtbot):
    view = built.loaded.views.scene
    qtbot.waitUntil(lambda: view._contents is not None, timeout=20_000)
    camera = view._plotter.camera
    before = camera.direction
    for name, direction in (("side", (1, 0, 0)), ("top", (0, -1, 0)), ("axis", (0, 0, -1))):
        built.commands[f"{name}_view"].trigger()
        np.testing.assert_allclose(camera.direction, direction, atol=1e-12)
    built.commands["fit_view"].trigger()
    np.testing.assert_allclose(camera.direction, before, atol=1e-12)


def test_a_click_on_the_compass_turns_the_camera_and_a_press_stops_it(
    display, built, qtbot, monkeypatch
):
    view = built.loaded.views.scene
    qtbot.waitUntil(lambda: view._contents is not None, timeout=20_000)
    plotter, picture = view._plotter, view._contents.picture
    plotter.repaint()
    scale, side = plotter.devicePixelRatioF(), view._compass.side
    middle = QPoint(round(plotter.width() - side / 2 / scale), round(side / 2 / scale))

    def ball():  # of +y, which is above the middle in this view
        return middle - QPoint(0, round(side / 2 / 1.35 / scale))

    view.fit("+z")
    plotter.repaint()
    qtbot.mouseClick(plotter, Qt.MouseButton.LeftButton, pos=ball())
    np.testing.assert_allclose(plotter.camera.direction, (0, -1, 0), atol=1e-12)
    assert picture.fitted
    monkeypatch.setattr("ui.views.flight.flight_ms", lambda view: 10_000)
    view.fit("+z")
    assert plotter.camera.direction[2] > -0.9  # on its way
    qtbot.mouseClick(plotter, Qt.MouseButton.MiddleButton, pos=QPoint(30, 30))
    stopped = plotter.camera.direction
    assert not picture.fitted
    qtbot.wait(50)
    assert plotter.camera.direction == stopped
    view.fit("+z")
    built.resize(built.width() - 40, built.height())  # lands at once, fitted to the new size
    qtbot.waitUntil(lambda: picture.fitted)
    np.testing.assert_allclose(plotter.camera.direction, (0, 0, -1), atol=1e-12)
