"""The dock in the real window: hidden at first, one of two tabs when shown, closed with it."""

import numpy as np
import pytest
from PySide6.QtCore import QSettings

from ui.document import Document
from ui.main_window import MainWindow
from workbench.analysis.derivatives import irradiance_derivative
from workbench.design.snapshot import History
from workbench.files.session import Session


@pytest.fixture
def window(display, session, snapshots, tmp_path, qtbot):
    history = History()
    history.add(snapshots(3))
    designed = Session(session.scene, session.target, history.result())
    settings = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    window = MainWindow(Document(designed, "designed"), settings)
    qtbot.addWidget(window, before_close_func=lambda window: window.discard_and_close())
    with qtbot.waitExposed(window):
        window.show()
    window.build()
    return window


def test_the_dock_shows_the_designed_lens(window, session, qtbot):
    dock, other = window.workspace.docks["derivative"], window.workspace.docks["error"]
    assert not dock.isVisible() and other.isVisible()
    entries = window.commands.menus["&View"].actions()
    assert dock.toggleViewAction() in entries
    dock.toggleViewAction().trigger()
    view = dock.widget()
    qtbot.waitUntil(lambda: view._map is not None, timeout=60_000)
    assert not dock.visibleRegion().isEmpty() and other.visibleRegion().isEmpty()
    wished = irradiance_derivative(session.scene, np.full((12, 10), 0.497), view.index)
    np.testing.assert_allclose(view._map.map, wished.map, atol=1e-12)


def test_nothing_is_computed_behind_another_tab(window, qtbot):
    dock, other = window.workspace.docks["derivative"], window.workspace.docks["error"]
    dock.toggleViewAction().trigger()
    view = dock.widget()
    qtbot.waitUntil(lambda: view._wanted is not None, timeout=60_000)
    other.raise_()
    qtbot.waitUntil(lambda: view._wanted is None)
    view._boxes[0].setValue(2)
    qtbot.wait(400)
    assert view._wanted is None and not view._rest.isActive()
    dock.raise_()
    qtbot.waitUntil(lambda: view._wanted is not None)
    assert view._wanted.index[0] == 2


def test_closing_in_the_midst_of_a_computation(window, qtbot):
    window.workspace.docks["derivative"].toggleViewAction().trigger()
    view = window.workspace.docks["derivative"].widget()
    qtbot.waitUntil(lambda: view._wanted is not None, timeout=60_000)
    window.discard_and_close()
    assert view._derivatives._thread is None
