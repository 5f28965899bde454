"""Commands for plots and for the colours of light, in the window."""

import pytest
from PIL import Image
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMainWindow

from ui.commands.actions import Commands, keep_colours


@pytest.fixture
def window(display, window):
    window.build()
    window.commands["workspace_design"].trigger()
    return window


def test_colours_reach_all_views_and_the_next_window(window, settings, qtbot):
    assert window.commands["colours_by_target"].isChecked()
    window.commands["colours_cividis"].trigger()
    assert window.loaded.views.shared.now.colours == "cividis"
    irradiance = window.loaded.views.around["irradiance"]
    qtbot.waitUntil(lambda: not irradiance.empty, timeout=30_000)
    qtbot.waitUntil(lambda: irradiance._image.image.get_cmap().name == "cividis")
    assert settings.value("view/colours") == "cividis"
    other, received = QMainWindow(), []
    qtbot.addWidget(other)
    commands = Commands(other)
    commands.connect_choices({"colours_cividis": lambda: received.append("cividis")})
    keep_colours(settings, commands)
    assert received == ["cividis"] and commands["colours_cividis"].isChecked()


def test_the_plot_on_show_is_copied_by_a_key(window, qtbot):
    view = window.loaded.views.around["irradiance"]
    qtbot.waitUntil(lambda: not view.empty, timeout=30_000)
    QGuiApplication.clipboard().clear()
    keys = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    qtbot.keyClick(window, Qt.Key.Key_C, keys)
    assert not QGuiApplication.clipboard().image().isNull()
    assert [action.text() for action in view._canvas.actions()] == ["Copy &plot", "Save p&lot…"]


def test_a_line_that_is_drawn_brings_its_cross_section(window, qtbot):
    dock, link = window.panes.docks["section"], window.loaded.views.shared
    assert not dock.isVisible()
    link.drawn.emit(((-0.5, 0.0), (0.5, 0.25)))
    qtbot.waitUntil(dock.isVisible)
    assert link.now.line == ((-0.5, 0.0), (0.5, 0.25))
    section = window.loaded.views.around["section"]
    qtbot.waitUntil(lambda: not section.empty, timeout=30_000)
    assert section._curves._axes.get_xlabel() == "distance (cm)"


def test_the_iterations_of_a_run_are_saved_as_a_video(window, frames, qtbot, tmp_path, monkeypatch):
    path = tmp_path / "run.gif"
    monkeypatch.setattr(window.early.dialogs, "to_save", lambda *_: path)
    window.commands["save_video"].trigger()
    assert "needs a run" in window.messages.text
    for iteration in range(4):
        window.loaded.control.history.add(frames(iteration))
    window.commands["save_video"].trigger()
    qtbot.waitUntil(path.exists, timeout=30_000)
    qtbot.waitUntil(lambda: not window.loaded.videos.background.busy)
    with Image.open(path) as found:
        assert found.n_frames == 4
