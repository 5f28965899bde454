"""Hands on the lens, by events of the mouse over the 3D view."""

import numpy as np
import pytest
import torch
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QGuiApplication, QImage, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication

from tests.ui.lens.tool_window import control_point, seen_at, upwards
from workbench.optics.plan import Plan

pytestmark = pytest.mark.usefixtures("kernels")


def test_dragging_a_point_is_one_step_with_its_light(sculpting, drag, qtbot):
    tools, view, document = sculpting, sculpting.view, sculpting.document
    tools.commands["brush_smaller"]()
    tools.commands["brush_smaller"]()
    frames, flat = [], view.frame
    tools.control.runner.frame_ready.connect(frames.append)
    camera = view._plotter.camera_position
    held = drag(view, control_point(tools, (6, 5)))
    for _ in range(4):
        held.move(upwards(view, 0.05))
    qtbot.waitUntil(lambda: bool(frames), timeout=20_000)
    assert document.session.result is None  # not yet a step
    assert frames[-1].snapshot.state.heights["lens.back"][6, 5] > 0.5
    held.release()
    qtbot.waitUntil(lambda: document.session.result is not None, timeout=20_000)
    result = document.session.result
    np.testing.assert_array_equal(np.argwhere(result.state.heights["lens.back"] != 0.5), [[6, 5]])
    assert result.state.heights["lens.back"][6, 5] == pytest.approx(0.7, abs=0.06)
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "move control points"
    assert view._plotter.camera_position == camera
    assert result.iterations == 0 and 0 < result.state.loss < 1
    # Light and account are those of this lens.
    scene = document.session.scene
    traced = (
        Plan(scene).trace({"lens.back": torch.tensor(result.state.heights["lens.back"])}).account
    )
    assert result.state.account.to_data() == pytest.approx(traced.to_data(), abs=5e-3)
    # A filter spreads some light of the outer pixels over the rim.
    flux = result.state.irradiance.sum() * scene.receiver.pixel_measure
    assert flux == pytest.approx(traced.on_screen, rel=0.05)
    assert np.ptp(result.state.irradiance) > 5 * np.ptp(flat.snapshot.state.irradiance[4:-4, 4:-4])
    document.undo_stack.undo()
    assert document.session.result is None


def test_shift_moves_finely_and_escape_undoes_the_drag(sculpting, drag, qtbot):
    tools, view = sculpting, sculpting.view
    held = drag(view, control_point(tools, (6, 5)))
    held.move(upwards(view, 0.2), Qt.KeyboardModifier.ShiftModifier)
    qtbot.waitUntil(lambda: view.frame.state.heights["lens.back"][6, 5] > 0.5, timeout=20_000)
    assert view.frame.state.heights["lens.back"][6, 5] == pytest.approx(0.51, abs=0.002)
    qtbot.waitUntil(lambda: "Moved by +0.0" in view._hint.text())
    qtbot.keyClick(view._plotter, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: view.frame.state.heights["lens.back"][6, 5] == 0.5, timeout=20_000)
    held.release()
    assert tools.document.undo_stack.count() == 0 and not tools.put_away
    qtbot.keyClick(view._plotter, Qt.Key.Key_Escape)
    assert tools.put_away


def test_the_brush_takes_a_smooth_bump_and_stays_in_range(sculpting, drag, qtbot):
    tools, view = sculpting, sculpting.view
    for _ in range(3):
        tools.commands["brush_larger"]()
    held = drag(view, control_point(tools, (6, 5)))
    held.move(upwards(view, 0.1))
    held.release()
    qtbot.waitUntil(lambda: tools.document.session.result is not None, timeout=20_000)
    found = tools.heights()
    assert found.min() == 0.5
    assert 10 < (found > 0.5).sum() < 120
    assert found[6, 5] > found[8, 5] > found[9, 5]
    held = drag(view, control_point(tools, (6, 5)))
    held.move(upwards(view, 1.0))
    held.release()
    qtbot.waitUntil(lambda: tools.heights().max() > 0.7, timeout=20_000)
    assert tools.heights().max() == pytest.approx(0.8)  # the end of the height range
    assert tools.document.undo_stack.count() == 2


def wheel(view, place, keys):
    event = QWheelEvent(
        QPointF(place),
        view._plotter.mapToGlobal(QPointF(place)),
        QPoint(),
        QPoint(0, 240),
        Qt.MouseButton.NoButton,
        keys,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(view._plotter, event)


def test_the_wheel_with_ctrl_is_the_brush_and_without_it_the_zoom(sculpting, qtbot):
    view, camera = sculpting.view, sculpting.view._plotter.camera
    place = control_point(sculpting, (6, 5))
    move = QMouseEvent(
        QEvent.Type.MouseMove,
        QPointF(place),
        view._plotter.mapToGlobal(QPointF(place)),
        Qt.MouseButton.NoButton,
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
    )
    QApplication.sendEvent(view._plotter, move)
    index, radius = view.nets.brush
    assert index == (6, 5)
    scale = camera.parallel_scale
    wheel(view, place, Qt.KeyboardModifier.ControlModifier)
    assert view.nets.brush[1] > 1.2 * radius and camera.parallel_scale == scale
    qtbot.waitUntil(lambda: f"radius {view.nets.brush[1]:.2g} cm" in view._hint.text())
    wheel(view, place, Qt.KeyboardModifier.NoModifier)
    assert camera.parallel_scale < scale
    QApplication.sendEvent(view._plotter, QEvent(QEvent.Type.Leave))
    assert view.nets.brush is None


def test_locked_points_do_not_move(sculpting, drag):
    tools = sculpting
    tools.commands["lock_all"]()
    locked = tools.document.session.locked["lens.back"]
    assert locked.shape == (12, 10) and locked.all() and not locked.flags.writeable
    held = drag(tools.view, control_point(tools, (6, 5)))
    held.move(upwards(tools.view, 0.1))
    held.release()
    assert "locked" in tools.stated[-1]
    assert tools.document.session.result is None
    tools.commands["unlock_all"]()
    assert not tools.document.session.locked
    tools.commands["invert_locks"]()
    assert (
        tools.document.session.locked["lens.back"].all() and tools.document.undo_stack.count() == 3
    )
    tools.commands["lock_all"]()  # which they are
    assert tools.document.undo_stack.count() == 3


def test_painting_locks_and_unlocks(tools, drag, qtbot):
    view, document = tools.view, tools.document
    tools.commands["lock"]()
    for _ in range(2):
        tools.commands["brush_smaller"]()
    qtbot.waitUntil(lambda: view.nets.picture._shown)
    held = drag(view, control_point(tools, (3, 3)))
    held.move(control_point(tools, (4, 3)) - held.at)
    held.move(control_point(tools, (5, 3)) - held.at)
    assert view.nets.locked.sum() == 3 and not document.session.locked
    held.release()
    np.testing.assert_array_equal(
        np.argwhere(document.session.locked["lens.back"]), [[3, 3], [4, 3], [5, 3]]
    )
    assert document.undo_stack.undoText() == "lock points"
    qtbot.waitUntil(lambda: view.nets.picture._locked is not None)
    held = drag(view, control_point(tools, (4, 3)))
    held.move(control_point(tools, (4, 4)) - held.at)
    held.release()
    np.testing.assert_array_equal(
        np.argwhere(document.session.locked["lens.back"]), [[3, 3], [5, 3]]
    )
    held = drag(view, control_point(tools, (8, 8)))
    qtbot.keyClick(view._plotter, Qt.Key.Key_Escape)
    np.testing.assert_array_equal(np.argwhere(view.nets.locked), [[3, 3], [5, 3]])
    held.release()
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert not document.session.locked and view.nets.locked is None


def hold_key(view, key, times, as_repeats=True):
    """A key that is pressed and repeats itself, and is not released yet."""
    for time in range(times):
        for kind in (QEvent.Type.KeyRelease, QEvent.Type.KeyPress)[time == 0 :]:
            again = as_repeats and time > 0
            event = QKeyEvent(kind, key, Qt.KeyboardModifier.NoModifier, "", again)
            QApplication.sendEvent(view._plotter, event)


@pytest.mark.parametrize("as_repeats", [True, False], ids=["received as repeats", "as on X11"])
def test_a_held_key_is_one_step(sculpting, qtbot, as_repeats):
    tools, view, document = sculpting, sculpting.view, sculpting.document
    tools.commands["brush_smaller"]()
    tools.commands["brush_smaller"]()
    hold_key(view, Qt.Key.Key_PageUp, 10, as_repeats)
    qtbot.waitUntil(lambda: view.frame.state.heights["lens.back"][6, 5] > 0.5, timeout=20_000)
    qtbot.waitUntil(lambda: "Moved by +0.06 cm" in view._hint.text())
    assert document.session.result is None
    # Neither hand nor pointer is in its way.
    qtbot.mouseMove(view._plotter, control_point(tools, (3, 4)))
    QApplication.sendEvent(view._plotter, QEvent(QEvent.Type.Leave))
    assert view.nets.brush[0] == (6, 5)
    qtbot.keyRelease(view._plotter, Qt.Key.Key_PageUp)
    qtbot.waitUntil(lambda: document.session.result is not None, timeout=20_000)
    np.testing.assert_array_equal(np.argwhere(tools.heights() != 0.5), [[6, 5]])
    assert tools.heights()[6, 5] == pytest.approx(0.56)  # ten times 1/100 of 0.6
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "move control points"
    qtbot.keyClick(view._plotter, Qt.Key.Key_PageDown, Qt.KeyboardModifier.ShiftModifier)
    qtbot.waitUntil(lambda: document.undo_stack.count() == 2, timeout=20_000)
    assert tools.heights()[6, 5] == pytest.approx(0.5597)
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert document.session.result is None


def test_in_the_window(display, make_session, open_window, tmp_path, drag, qtbot, monkeypatch):
    """Commands, all views and the run, from a drag to what goes on from it."""
    window = open_window(make_session({"run.iterations": 3}))
    window.build()
    view, commands, document = window.loaded.views.scene, window.commands, window.document
    qtbot.waitUntil(lambda: view.frame is not None and view.optic is not None, timeout=60_000)
    menu = commands.scene_menu
    monkeypatch.setattr(menu, "popup", lambda at: None)
    view.menu_asked.emit(view._plotter.mapToGlobal(seen_at(view, (0.0, 0.0, 0.25))))
    entry = menu.actions()[0]
    assert entry.isVisible() and entry.text() == "Edit lens in the form"
    entry.trigger()
    qtbot.waitUntil(lambda: window.forms.isAncestorOf(QApplication.focusWidget()))
    view.menu_asked.emit(view._plotter.mapToGlobal(QPoint(1, 1)))
    assert not entry.isVisible()
    commands["sculpt"].trigger()
    qtbot.waitUntil(lambda: view.nets.picture._shown)
    held = drag(view, seen_at(view, view.nets.picture.places((6, 5))))
    held.move(upwards(view, 0.1))
    held.release()
    qtbot.waitUntil(lambda: document.session.result is not None, timeout=20_000)
    shaped = document.session.heights["lens.back"]
    for shows in window.loaded.views.around.values():
        assert (shows._frame.state.heights["lens.back"] == shaped).all()
    qtbot.keyClick(view._plotter, Qt.Key.Key_Escape)
    assert commands["turn"].isChecked()

    frames = []
    window.loaded.control.runner.frame_ready.connect(frames.append)
    commands["continue"].trigger()
    assert not commands["lock_all"].isEnabled()
    qtbot.waitUntil(lambda: window.loaded.control.runner.state == "idle", timeout=60_000)
    assert document.session.result.iterations > 0
    np.testing.assert_allclose(frames[0].snapshot.state.heights["lens.back"], shaped, atol=0.1)

    file = tmp_path / "lens.png"
    monkeypatch.setattr(window.dialogs, "to_save", lambda *_: file)
    size = view._plotter.size() * view.devicePixelRatioF()  # less, below a message
    commands["save_scene"].trigger()
    assert QImage(str(file)).size() == size * round(1800 / view.width())
    seen = QImage(str(file))
    assert len({seen.pixel(x, seen.height() // 2) for x in range(seen.width())}) > 20
    commands["copy_scene"].trigger()
    assert QGuiApplication.clipboard().image().width() == size.width()
    window.panes.docks["scene"].hide()
    file.unlink()
    commands["save_scene"].trigger()
    assert not file.exists() and "hidden" in window.messages.text


def test_two_clicks_measure_a_distance_and_snap_to_corners(tools, qtbot):
    view = tools.view
    tools.commands["measure"]()
    assert "Click two points" in view._hint.text()
    view.fit("screen")
    (x, y), z = tools.document.session.scene.receiver.half_width, 5.0
    for place in ((-x, -y, z), (x, -y, z)):
        near = seen_at(view, place) + QPoint(2 if place[0] < 0 else -2, -2)
        qtbot.mouseClick(view._plotter, Qt.MouseButton.LeftButton, pos=near)
    assert view._tool.ruled[0] == pytest.approx([-x, -y, z])
    qtbot.waitUntil(lambda: view._hint.text() == f"Distance {2 * x:g} cm: x {2 * x:g}, y 0, z 0")
    ends = view._contents._rule._mesh.points
    np.testing.assert_allclose(ends, [[-x, -y, z], [x, -y, z]], atol=1e-6)
    qtbot.mouseClick(view._plotter, Qt.MouseButton.LeftButton, pos=seen_at(view, (0, 0, z)))
    assert len(view._tool.ruled) == 1  # the next measurement begins


def test_a_right_click_opens_the_menu_and_a_right_drag_does_not(tools, qtbot):
    view, asked, right = tools.view, [], Qt.MouseButton.RightButton
    view.menu_asked.connect(asked.append)
    at = QPoint(100, 200)
    qtbot.mousePress(view._plotter, right, pos=at)
    qtbot.mouseRelease(view._plotter, right, pos=at + QPoint(60, 0))
    qtbot.wait(20)
    assert not asked
    tools.commands["measure"]()
    qtbot.mouseClick(view._plotter, right, pos=at)
    qtbot.waitUntil(lambda: asked == [view._plotter.mapToGlobal(at)])
