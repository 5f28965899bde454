"""How a design is looked at travels in its file, and changing it is no edit."""

import pytest

from tests.ui.hands import move_screen

pytestmark = pytest.mark.usefixtures("kernels")


def shown(window):
    return {name for name, dock in window.panes.docks.items() if not dock.isHidden()}


def save(window, path):
    window.document.save(path, window.files.view_data())


def test_docks_and_choices_come_back_with_the_design(open_window, tmp_path, qtbot):
    path = tmp_path / "mine.freeform"
    window = open_window()
    window.build()
    window.commands["workspace_design"].trigger()
    window.panes.docks["history"].show()
    window.panes.docks["light"].hide()
    for name in ("exploded", "rays_5", "colours_viridis"):
        window.commands[name].trigger()
    wanted = shown(window)
    assert not window.document.dirty
    save(window, path)
    assert not window.document.dirty
    window.commands["workspace_check"].trigger()
    for name in ("exploded", "rays_45", "colours_as_seen"):
        window.commands[name].trigger()
    assert not window.document.dirty
    assert window.files.open(path)
    assert shown(window) == wanted and window.workspaces.name == "design"
    switches = ("exploded", "rays_5", "rays_45", "colours_viridis", "colours_as_seen")
    on = [name for name in switches if window.commands[name].isChecked()]
    assert on == ["exploded", "rays_5", "colours_viridis"]
    assert not window.document.dirty and window.document.undo_stack.count() == 0


def test_the_camera_comes_back_with_the_design(display, open_window, tmp_path, qtbot):
    path = tmp_path / "mine.freeform"
    window = open_window()
    window.build()
    scene = window.loaded.views.scene
    qtbot.waitUntil(lambda: scene.camera() is not None and scene.frame is not None, timeout=60_000)
    assert scene.camera() == {"fitted": ""}
    placement = {
        "position": [3.0, 2.0, 1.0],
        "focal_point": [0.0, 0.5, 1.0],
        "up": [0.0, 1.0, 0.0],
        "scale": 2.5,
    }
    scene.set_camera(placement)
    qtbot.waitUntil(lambda: scene._placement is None, timeout=60_000)
    moved = scene.camera()
    assert moved["position"] == pytest.approx(placement["position"])
    save(window, path)
    scene.fit("side")
    assert scene.camera() == {"fitted": "side"}
    assert window.files.open(path)
    qtbot.waitUntil(lambda: scene._placement is None, timeout=60_000)
    for key, value in placement.items():
        assert scene.camera()[key] == pytest.approx(value)


def test_a_fitted_view_stays_one_where_an_edit_moves_nothing(display, open_window, qtbot):
    window = open_window()
    window.build()
    scene, document = window.loaded.views.scene, window.document
    qtbot.waitUntil(lambda: scene.camera() is not None and scene.frame is not None, timeout=60_000)
    scene.fit("side")
    task = document.session.scene
    coarse = task.receiver.model_copy(update={"pixels": (24, 24)})
    document.edit(task.with_receiver(coarse), "coarse", "pixels")
    qtbot.waitUntil(lambda: scene._shown is document.session, timeout=60_000)
    assert scene.camera() == {"fitted": "side"}


def test_revert_goes_back_to_the_file_and_can_be_undone(open_window, tmp_path):
    window = open_window()
    document, revert = window.document, window.commands["revert"]
    move_screen(window.document, 7)
    assert not revert.isEnabled()  # there is no file yet
    save(window, tmp_path / "mine.freeform")
    assert not revert.isEnabled()
    move_screen(window.document, 8)
    assert revert.isEnabled()
    revert.trigger()
    assert document.session.scene.receiver.z == 7
    assert not document.dirty and not revert.isEnabled()
    window.commands["undo"].trigger()
    assert document.session.scene.receiver.z == 8 and document.dirty
