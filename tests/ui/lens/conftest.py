"""Windows with the tools of the 3D view and a design."""

from pathlib import Path

import pytest

from tests.ui.lens.tool_window import Drag, ToolWindow
from workbench.design.task import begin


@pytest.fixture
def make_tools(display, make_session, qtbot):
    def make_tools(changes=None, scene=None):
        session = make_session(changes) if scene is None else begin(scene, Path.cwd())
        tools = ToolWindow(session)
        qtbot.addWidget(tools.window, before_close_func=lambda _: tools.close())
        with qtbot.waitExposed(tools.window):
            tools.window.show()
        # Until the first preview is drawn there is nothing to take hold of.
        view = tools.view
        qtbot.waitUntil(lambda: view.frame is not None and view.optic is not None, timeout=60_000)
        qtbot.waitUntil(lambda: not view._to_draw)
        return tools

    return make_tools


@pytest.fixture
def tools(make_tools):
    return make_tools()


@pytest.fixture
def sculpting(tools, qtbot):
    tools.commands["sculpt"]()
    qtbot.waitUntil(lambda: tools.view.nets.picture._shown)
    return tools


@pytest.fixture
def drag(qtbot):
    return lambda view, start: Drag(qtbot, view, start)
