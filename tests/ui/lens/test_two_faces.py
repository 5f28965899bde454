"""Hands on a lens of two freeform faces."""

import numpy as np
import pytest

from tests.ui.lens.tool_window import control_point, upwards
from workbench.scene import Scene

pytestmark = pytest.mark.usefixtures("kernels")

TWO_FACES = {"lens.entrance": {"shape": "freeform", "height_range": [-0.1, 0.1]}}


@pytest.fixture
def sculpting(make_tools, qtbot):
    tools = make_tools(TWO_FACES)
    tools.commands["sculpt"]()
    for _ in range(2):
        tools.commands["brush_smaller"]()
    qtbot.waitUntil(lambda: tools.view.nets.picture._shown)
    return tools


def shown(nets):
    return {face for face, picture in nets._pictures.items() if picture._shown}


def test_the_exit_face_is_worked_on_first_and_the_hint_names_it(sculpting, qtbot):
    view = sculpting.view
    assert view.nets.faces == ("lens.front", "lens.back") and view.nets.face == "lens.back"
    assert view._hint.text().startswith("Exit face. Drag control points")
    sculpting.commands["other_face"]()
    qtbot.waitUntil(lambda: view._hint.text().startswith("Entrance face. Drag"))
    assert shown(view.nets) == {"lens.front"}
    assert view._plotter.camera.direction[2] > 0  # it looks along the light
    sculpting.commands["other_face"]()
    qtbot.waitUntil(lambda: shown(view.nets) == {"lens.back"})
    assert view._plotter.camera.direction[2] < 0


@pytest.mark.parametrize(
    "look, face, other",
    [("lens", "lens.back", "lens.front"), ("entrance", "lens.front", "lens.back")],
)
def test_the_face_that_is_seen_under_the_pointer_is_dragged(
    sculpting, drag, qtbot, look, face, other
):
    tools, view, document = sculpting, sculpting.view, sculpting.document
    view.fit(look)
    picture = view.nets._pictures[face]
    ((x, y),) = view.sight.pixels(picture.places((6, 5))[None])
    assert view.nets.aim(x, y) == (6, 5) and view.nets.face == face
    before = view.frame.state.heights
    held = drag(view, control_point(tools, (6, 5)))
    held.move(upwards(view, 0.05))
    held.release()
    qtbot.waitUntil(lambda: document.session.result is not None, timeout=20_000)
    heights = document.session.heights
    np.testing.assert_array_equal(np.argwhere(heights[face] != before[face]), [[6, 5]])
    assert heights[face][6, 5] - before[face][6, 5] == pytest.approx(0.05, abs=0.02)
    assert (heights[other] == before[other]).all()
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.session.result is None


def test_locks_are_painted_on_the_face_that_is_seen(sculpting, drag, qtbot):
    tools, view, document = sculpting, sculpting.view, sculpting.document
    tools.commands["lock"]()
    tools.commands["other_face"]()
    held = drag(view, control_point(tools, (3, 3)))
    held.move(control_point(tools, (4, 3)) - held.at)
    held.release()
    assert set(document.session.locked) == {"lens.front"}
    np.testing.assert_array_equal(
        np.argwhere(document.session.locked["lens.front"]), [[3, 3], [4, 3]]
    )
    qtbot.waitUntil(lambda: view._hint.text().endswith("2 locked"))
    tools.commands["other_face"]()
    qtbot.waitUntil(lambda: view._hint.text().endswith("0 locked"))
    tools.commands["lock_all"]()
    assert all(mask.all() for mask in document.session.locked.values())
    assert set(document.session.locked) == {"lens.front", "lens.back"}


def test_faces_of_two_elements_are_chosen_dragged_and_locked(make_tools, drag, qtbot, make_scene):
    lens = {**make_scene().to_data()["elements"][0], "half_width": [1, 1]}
    data = make_scene().to_data()
    z = data["images"][0]["receiver"]["position"][2]
    data["elements"] = [
        lens | {"name": "first", "position": [0, 0, 0]},
        lens | {"name": "second", "position": [0, 0, z / 2]},
    ]
    tools = make_tools(scene=Scene.from_data(data))
    view, document = tools.view, tools.document
    tools.commands["sculpt"]()
    qtbot.waitUntil(lambda: view._hint.text().startswith("Exit face of second. Drag"))
    tools.commands["other_face"]()
    qtbot.waitUntil(lambda: view._hint.text().startswith("Exit face of first. Drag"))
    before = view.frame.state.heights
    held = drag(view, control_point(tools, (6, 5)))
    assert view.nets.face == "first.back"
    held.move(upwards(view, 0.05))
    held.release()
    qtbot.waitUntil(lambda: document.session.result is not None, timeout=20_000)
    heights = document.session.heights
    assert heights["first.back"][6, 5] > before["first.back"][6, 5]
    assert (heights["second.back"] == before["second.back"]).all()
    tools.commands["lock_all"]()
    assert set(document.session.locked) == {"first.back", "second.back"}
