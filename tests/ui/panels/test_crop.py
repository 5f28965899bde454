"""Crop of a picture by its edges, and its levels."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QDialogButtonBox

from tests.ui.hands import fill
from ui.panels.crop import CropView
from ui.panels.picture_dialog import PictureDialog
from workbench.scene import Scene
from workbench.targets.colour import SRGB
from workbench.targets.picture import Picture

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def view(qtbot):
    view = CropView((0.0, 0.0, 0.0, 0.0))
    view.show_light(np.linspace(0.1, 1, 40 * 80).reshape(40, 80))
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


STORED = np.tile(np.linspace(0.2, 1, 80), (40, 1))  # from dark on the left to white on the right


@pytest.fixture
def dialog(qtbot, view):
    view.resize(900, 800)

    def make(**target):
        scene = Scene.from_data(
            {
                "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [8, 8]},
                "source": {"kind": "collimated"},
                "screen": {"z": 5, "half_width": [1, 1], "pixels": [16, 16]},
                "target": {"image": "picture.png", "tone": "srgb", **target},
            }
        )
        picture = Picture(SRGB.light(STORED), SRGB)
        dialog = PictureDialog(picture, scene, "images[0].target", view)
        dialog.show()
        return dialog

    return make


def row(dialog, name):
    (found,) = (row for row in dialog._form.rows if row.path.endswith(f".{name}"))
    return found


def figures(dialog):
    return dialog._figures.text()


def test_the_dialog_says_what_is_kept(dialog):
    dialog = dialog(crop=[0, 0, 0.5, 0])
    assert "50 × 100 %" in figures(dialog) and "1.00" in figures(dialog)
    dialog.view.show_crop((0.123456, 0, 0, 0))
    assert dialog.changes == {"crop": (0.1235, 0, 0, 0)}


def test_handles_of_the_histogram_set_the_levels(dialog, qtbot):
    dialog = dialog()
    histogram = dialog.histogram
    assert "black: 0 %" in figures(dialog)

    def at(value):
        return round(histogram._x(value)), 40

    drag(qtbot, histogram, at(0.02), at(0.6))
    assert dialog.target.black == pytest.approx(0.6, abs=0.01)
    assert "black: 5" in figures(dialog)  # half of the values lie below
    drag(qtbot, histogram, at(0.99), at(0.2))
    assert dialog.target.white == pytest.approx(dialog.target.black + 0.02)
    drag(qtbot, histogram, at(dialog.target.white), at(0.9))
    drag(qtbot, histogram, at(histogram.places["gamma"]), at(0.6 + 0.3 * 0.25))
    assert dialog.target.gamma == pytest.approx(2, abs=0.15)
    assert histogram.places["gamma"] == pytest.approx(0.675, abs=0.02)
    qtbot.mouseDClick(histogram, LEFT, pos=QPoint(*at(0.5)))
    assert dialog.changes == {}


def test_levels_are_typed_and_refused(dialog, qtbot):
    dialog = dialog()
    fill(qtbot, row(dialog, "black").editors["images[0].target.black"], "0.25")
    row(dialog, "invert").box.click()
    assert dialog.changes == {"black": 0.25, "invert": True}
    white = row(dialog, "white")
    fill(qtbot, white.editors["images[0].target.white"], "0.1")
    ok = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Ok)
    assert "0.26" in white.refusal and not ok.isEnabled()
    fill(qtbot, white.editors["images[0].target.white"], "0.5")
    assert not white.refusal and ok.isEnabled()


def test_the_preview_has_the_levels(dialog):
    dialog = dialog(black=0.6, invert=True)

    def grey(column):
        return dialog.view._picture.pixelColor(column, 20).red()

    assert grey(0) > grey(10) > grey(70) == 0
