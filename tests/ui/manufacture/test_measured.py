"""Photographs and measured surfaces in the window."""

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QDialog

from ui.dialogs import measured
from ui.dialogs.comparison import ComparisonDialog
from ui.dialogs.corners import CornerView
from workbench.report.content import Fact


class Desk(QObject):
    """Stands in for lens, messages and file dialogs."""

    def __init__(self, session, window, folder):
        super().__init__(window)
        self.session, self.window, self._folder = session, window, folder
        self.messages, self.warnings = self, []

    def warn(self, text):
        self.warnings.append(text)

    def to_save(self, *_):
        return self._folder / "corrected.freeform"


@pytest.fixture
def desk(designed, window, tmp_path):
    return Desk(designed, window, tmp_path)


@pytest.fixture
def comparer(desk, settings, monkeypatch):
    monkeypatch.setattr(QDialog, "exec", lambda _: True)
    found = measured.Measured(desk, settings)
    yield found
    found.background.close()


def test_corners_are_dragged_and_moved_by_keys(qtbot):
    view = CornerView(np.zeros((100, 200)))
    qtbot.addWidget(view)
    view.resize(400, 200)
    assert view.corners[0] == (20, 10)
    at = view.handles[0].toPoint()
    qtbot.mousePress(view, Qt.MouseButton.LeftButton, pos=at)
    view.move_corner(0, -5, 42)
    assert view.corners[0] == (0, 42)
    qtbot.keyClick(view, Qt.Key.Key_Space)
    qtbot.keyClick(view, Qt.Key.Key_Left)
    assert view.corners[1] == (179, 10)


def test_a_photograph_that_is_none_is_refused_in_a_sentence(comparer, desk, tmp_path, qtbot):
    text, black = tmp_path / "text.png", tmp_path / "black.png"
    text.write_text("nothing")
    comparer.compare(desk.session, text)
    Image.fromarray(np.zeros((20, 20), dtype=np.uint8)).save(black)
    comparer.compare(desk.session, black)
    qtbot.waitUntil(lambda: len(desk.warnings) == 2, timeout=60_000)
    assert desk.warnings[0].startswith(repr(str(text)))
    assert "the picture of this lens is not within these corners" in desk.warnings[1]


def saving(dialog):
    return [button for button in dialog.buttons.buttons() if "corrected" in button.text()]


@pytest.mark.full
def test_a_measured_part_is_compared_and_corrected(comparer, desk, tmp_path, window, qtbot):
    from workbench import export, load

    part = tmp_path / "part.height.csv"
    export(desk.session, part)
    comparer.inspect(desk.session, [part])
    qtbot.waitUntil(lambda: not comparer.background.busy, timeout=100_000)
    assert desk.warnings == []
    dialog = window.findChild(ComparisonDialog)
    names = [dialog.table.item(row, 0).text() for row in range(dialog.table.rowCount())]
    assert names[:3] == ["Repeats", "As designed", "Light of part.height.csv"]
    (save,) = saving(dialog)
    save.click()
    qtbot.waitUntil(lambda: not comparer.background.busy, timeout=100_000)
    heights = load(tmp_path / "corrected.freeform").heights["lens.back"]
    assert heights == pytest.approx(desk.session.heights["lens.back"], abs=1e-6)


def test_only_parts_can_be_corrected(comparer, desk, window):
    found = measured.Comparison(lambda figure: None, [Fact("distance", "1 cm")])
    comparer._show(desk.session, found)
    dialog = window.findChild(ComparisonDialog)
    assert dialog.isVisible() and dialog.table.item(0, 1).text() == "1 cm"
    assert saving(dialog) == []
