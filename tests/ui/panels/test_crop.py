"""Crop of a picture by its edges, and its turn."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from ui.panels.crop import CropDialog, CropView

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def view(qtbot):
    view = CropView(np.linspace(0.1, 1, 40 * 80).reshape(40, 80), (0.0, 0.0, 0.0, 0.0))
    qtbot.addWidget(view)
    view.resize(400, 300)  # the picture takes 400 × 200 pixels of it
    view.show()
    return view


def drag(qtbot, view, begin, end):
    qtbot.mousePress(view, LEFT, pos=QPoint(*begin))
    qtbot.mouseMove(view, QPoint(*end))
    qtbot.mouseRelease(view, LEFT, pos=QPoint(*end))


def test_edges_and_corners_are_dragged(view, qtbot):
    drag(qtbot, view, (1, 150), (101, 150))
    assert view.crop == pytest.approx((0.25, 0, 0, 0), abs=0.01)
    drag(qtbot, view, (398, 248), (298, 198))
    assert view.crop == pytest.approx((0.25, 0, 0.25, 0.25), abs=0.01)
    qtbot.mouseDClick(view, LEFT, pos=QPoint(200, 150))
    assert view.crop == (0, 0, 0, 0)


def test_the_rectangle_is_moved_and_stays_within_the_picture(view, qtbot):
    view.show_crop((0.25, 0.25, 0.25, 0.25))
    drag(qtbot, view, (200, 150), (160, 130))
    assert view.crop == pytest.approx((0.15, 0.15, 0.35, 0.35), abs=0.01)
    drag(qtbot, view, (200, 150), (-900, 150))
    assert view.crop == pytest.approx((0, 0.15, 0.5, 0.35), abs=0.01)


def test_arrows_move_and_with_shift_enlarge(view, qtbot):
    view.show_crop((0.2, 0.2, 0.2, 0.2))
    qtbot.keyClick(view, Qt.Key.Key_Right)
    assert view.crop == pytest.approx((0.21, 0.2, 0.19, 0.2))
    qtbot.keyClick(view, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert view.crop == pytest.approx((0.21, 0.2, 0.19, 0.19))


def test_some_of_the_picture_is_always_kept(view, qtbot):
    drag(qtbot, view, (1, 150), (399, 150))
    left, _, right, _ = view.crop
    assert 0.9 < left + right < 0.99


def test_the_dialog_says_what_is_kept(qtbot, view):
    dialog = CropDialog(np.ones((40, 80)), (0.0, 0.0, 0.5, 0.0), view)
    qtbot.addWidget(dialog)
    assert "50 × 100 %" in dialog._size.text() and "1.00" in dialog._size.text()
    dialog.view.show_crop((0.123456, 0, 0, 0))
    assert dialog.crop == (0.1235, 0, 0, 0)
