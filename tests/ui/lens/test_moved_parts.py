"""Parts of a scene moved by their handles, by events of the mouse over the 3D view."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from tests.ui.lens.tool_window import seen_at
from workbench.scene import Scene

pytestmark = pytest.mark.usefixtures("kernels")

POINT = {"kind": "point", "position": [0.0, 0.0, -3.0], "rays": 4096}


def has_handle(view, path):
    return view.handles is not None and path in [each.path for each in view.handles.shown]


def test_the_source_follows_the_pointer_in_its_plane(make_tools, drag, qtbot):
    tools = make_tools({"source": POINT})
    view, document = tools.view, tools.document
    tools.commands["move_source"]()
    qtbot.waitUntil(lambda: has_handle(view, "source.position"))
    camera, start = view._plotter.camera_position, seen_at(view, (0.0, 0.0, -3.0))
    there = seen_at(view, (0.3, -0.2, -3.0)) - start
    held = drag(view, start)
    held.move(there / 2)
    held.move(there - there / 2)
    x, y, z = document.session.scene.source.position
    assert (x, y) == (pytest.approx(0.3, abs=0.05), pytest.approx(-0.2, abs=0.05)) and z == -3.0
    assert x == round(x, 3)
    held.release()
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "move the source"
    qtbot.waitUntil(lambda: view.frame.source.position == (x, y, z), timeout=20_000)
    # At rest the new design is shown; the camera has not moved.
    qtbot.waitUntil(lambda: view.frame.session is document.session, timeout=20_000)
    qtbot.waitUntil(lambda: view._shown is document.session)
    document.undo_stack.undo()
    qtbot.waitUntil(lambda: view._shown is document.session, timeout=20_000)
    document.undo_stack.redo()
    qtbot.waitUntil(lambda: view._shown is document.session, timeout=20_000)
    assert view._plotter.camera_position == camera
    # Along the axis, until the lens is in the way.
    ctrl = Qt.KeyboardModifier.ControlModifier
    start = seen_at(view, (x, y, z))
    held = drag(view, start)
    held.move(seen_at(view, (x, y, -2.0)) - start, ctrl)
    assert document.session.scene.source.position[:2] == (x, y)
    assert document.session.scene.source.position[2] == pytest.approx(-2.0, abs=0.05)
    held.move(seen_at(view, (x, y, 3.0)) - start, ctrl)
    assert document.session.scene.source.position[2] < 0
    assert "source.position" in tools.stated[-1]
    qtbot.keyClick(view._plotter, Qt.Key.Key_Escape)
    assert document.session.scene.source.position == (x, y, z)
    held.release()
    assert document.undo_stack.index() == 1
    qtbot.waitUntil(lambda: view.frame.session is document.session, timeout=20_000)
    assert view.frame.source.position == (x, y, z)
    document.undo_stack.undo()
    assert document.session.scene.source.position == (0.0, 0.0, -3.0)


def test_a_small_source_is_moved_by_any_of_its_corners_and_keeps_its_size(make_tools, drag, qtbot):
    grid = {"kind": "grid", "center": [0.0, 0.0, -3.0], "half_width": [0.02, 0.02]}
    tools = make_tools({"source": {**grid, "points": [2, 2]}})
    view, corner = tools.view, (0.02, 0.02, -3.0)
    tools.commands["move_source"]()
    qtbot.waitUntil(lambda: has_handle(view, "source.position"))
    held = drag(view, seen_at(view, corner))
    held.move(seen_at(view, (0.52, 0.02, -3.0)) - seen_at(view, corner))
    held.release()
    source = tools.document.session.scene.source
    assert source.half_width == (0.02, 0.02)
    assert source.position == (pytest.approx(0.5, abs=0.05), pytest.approx(0, abs=0.05), -3.0)


def test_an_element_of_a_train_is_moved(make_tools, make_scene, drag, qtbot):
    data = make_scene().to_data()
    first = data["elements"][0]
    plate = first | {"name": "plate", "position": [0, 0, 2], "thickness": 0.2, "min_thickness": 0.1}
    plate |= {"faces": [{"shape": "plane"}, {"shape": "plane"}]}
    tools = make_tools(scene=Scene.from_data(data | {"elements": [first, plate]}))
    view, document = tools.view, tools.document
    tools.commands["move_source"]()
    qtbot.waitUntil(lambda: has_handle(view, "elements[1].position"))
    start = seen_at(view, (0, 1, 2))  # its handle
    held = drag(view, start)
    held.move(seen_at(view, (0.3, 0.8, 2)) - start)
    x, y, z = document.session.scene.elements[1].position
    assert (x, y) == (pytest.approx(0.3, abs=0.05), pytest.approx(-0.2, abs=0.05)) and z == 2
    held.release()
    assert document.undo_stack.undoText() == "move the element"
    qtbot.waitUntil(
        lambda: (x, y + 1, z) in [tuple(h.place) for h in view.handles.shown], timeout=20_000
    )
    # Along the axis, but not into the lens before it.
    start = seen_at(view, (x, y + 1, 2))
    held = drag(view, start)
    ctrl = Qt.KeyboardModifier.ControlModifier
    held.move(seen_at(view, (x, y + 1, 3)) - start, ctrl)
    high = document.session.scene.elements[1].position[2]
    assert high == pytest.approx(3, abs=0.1)
    held.move(seen_at(view, (x, y, 0.3)) - seen_at(view, (x, y, 3)), ctrl)
    assert document.session.scene.elements[1].position[2] == high
    assert "elements[1].position" in tools.stated[-1]
    held.release()
    document.undo_stack.undo()
    document.undo_stack.undo()
    assert document.session.scene.elements[1].position == (0, 0, 2)


def test_the_screen_is_dragged_along_the_axis_in_one_step(make_tools, drag, qtbot):
    tools = make_tools()
    view, document = tools.view, tools.document
    tools.commands["move_source"]()
    qtbot.waitUntil(lambda: has_handle(view, "images[0].receiver.position"))
    scene = document.session.scene
    top = (0.0, 1.03 * scene.receiver.half_width[1], 5.0)
    start = seen_at(view, top)
    held = drag(view, start)
    held.move(seen_at(view, (*top[:2], 5.5)) - start)
    assert document.session.scene.receiver.plane_z == pytest.approx(5.5, abs=0.1)
    assert f"Position 0, 0, {document.session.scene.receiver.plane_z:g} cm" in view._tool.hint
    held.release()
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "move the screen"
    moved = document.session.scene.receiver.plane_z
    qtbot.waitUntil(lambda: view.frame.session.scene.receiver.plane_z == moved, timeout=20_000)
    document.undo_stack.undo()
    assert document.session.scene == scene


def test_a_far_field_has_no_distance_to_drag(make_tools, make_scene, qtbot):
    data = make_scene().to_data()
    far = {"kind": "far_field", "half_angle": [10.0, 10.0], "pixels": [32, 32]}
    data["images"][0]["receiver"] = far
    tools = make_tools(scene=Scene.from_data(data))
    tools.commands["move_source"]()
    qtbot.waitUntil(lambda: has_handle(tools.view, "elements[0].position"))
    assert not has_handle(tools.view, "images[0].receiver.position")
    assert "Page Up" not in tools.view._tool.hint  # collimated light has no position


def test_the_thickness_of_a_single_lens_is_dragged_in_one_step(make_tools, drag, qtbot):
    tools = make_tools()
    view, document = tools.view, tools.document
    tools.commands["move_source"]()
    qtbot.waitUntil(lambda: has_handle(view, "elements[0].thickness"))
    lens = document.session.scene.elements[0]
    (handle,) = (each for each in view.handles.shown if each.path.endswith("thickness"))
    start, by = seen_at(view, handle.place), np.array([0.0, 0.0, 0.2])
    qtbot.mouseMove(view._plotter, start)
    qtbot.waitUntil(lambda: f"Thickness {lens.thickness:g} cm" in view._hint.text())
    held = drag(view, start)
    held.move(seen_at(view, handle.place + by) - start)
    thicker = document.session.scene.elements[0]
    assert thicker.thickness == pytest.approx(lens.thickness + 0.2, abs=0.05)
    assert thicker.position == lens.position
    qtbot.waitUntil(lambda: f"Thickness {thicker.thickness:g} cm" in view._hint.text())
    places = [each.place[2] for each in view.handles.shown if each.path.endswith("thickness")]
    assert places == [pytest.approx(thicker.thickness)]  # the handle follows
    held.release()
    assert document.undo_stack.undoText() == "change the thickness"
    qtbot.waitUntil(lambda: view.frame.session is document.session, timeout=20_000)
    document.undo_stack.undo()
    assert document.session.scene.elements[0] == lens
