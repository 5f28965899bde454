"""Images of the screen: zoomed and moved together, read under the pointer, cut along lines."""

import dataclasses

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication, QHBoxLayout, QWidget

from ui.frame import make_frame
from ui.views.error_view import ErrorView
from ui.views.image_link import ImageLink
from ui.views.irradiance_view import IrradianceView
from ui.views.section_view import SectionView
from ui.views.target_view import TargetView
from workbench.pictures.images import signed_error, target_irradiance


@pytest.fixture
def frame(session, snapshots, history):
    n_x, n_y = session.scene.screen.pixels
    image = np.arange(n_x * n_y, dtype=float).reshape(n_y, n_x) / 1000
    snapshot = dataclasses.replace(snapshots(1), irradiance=image)
    return make_frame(session, snapshot, history(1))


@pytest.fixture
def views(frame, qtbot):
    """Irradiance, target and error beside each other, drawn."""
    link, window = ImageLink(), QWidget()
    views = [IrradianceView(link), TargetView(link), ErrorView(link)]
    row = QHBoxLayout(window)
    for view in views:
        row.addWidget(view)
        view.show_frame(frame)
    qtbot.addWidget(window)
    window.resize(1200, 380)
    with qtbot.waitExposed(window):
        window.show()
    qtbot.waitUntil(lambda: all(view._values is not None for view in views))
    yield views


def place(view, x, y):
    """Where a place on the screen is in the canvas."""
    i, j = view._axes.transData.transform((x, y))
    return QPoint(round(i), round(view._canvas.height() - j))


def turn_wheel(view, x, y, steps):
    at = QPointF(place(view, x, y))
    event = QWheelEvent(
        at,
        view._canvas.mapToGlobal(at),
        QPoint(),
        QPoint(0, 120 * steps),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(view._canvas, event)


def limits(view):
    return (*view._axes.get_xlim(), *view._axes.get_ylim())


def test_all_zoom_about_the_pointer(views, qtbot):
    turn_wheel(views[0], 0.5, -0.25, 3)
    qtbot.waitUntil(lambda: all(limits(view) != (-1, 1, -1, 1) for view in views))
    scale = 1.25**-3
    wished = (0.5 - 1.5 * scale, 0.5 + 0.5 * scale, -0.25 - 0.75 * scale, -0.25 + 1.25 * scale)
    for view in views:  # the pointer is on a whole pixel of the window
        np.testing.assert_allclose(limits(view), wished, atol=0.01)
    turn_wheel(views[2], 0.5, -0.25, -9)
    qtbot.waitUntil(lambda: all(limits(view) == (-1, 1, -1, 1) for view in views))


def test_dragging_moves_all_no_farther_than_the_screen(views, qtbot):
    views[0]._link.show_part((-0.5, 0.5, -0.5, 0.5))
    qtbot.waitUntil(lambda: limits(views[1]) == (-0.5, 0.5, -0.5, 0.5))
    canvas, start = views[1]._canvas, place(views[1], 0, 0)
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    end = place(views[1], 0.25, 0)
    qtbot.mouseMove(canvas, end)
    qtbot.waitUntil(lambda: limits(views[0])[0] < -0.7)
    np.testing.assert_allclose(limits(views[0]), (-0.75, 0.25, -0.5, 0.5), atol=0.01)
    qtbot.mouseMove(canvas, end + QPoint(2000, 0))
    qtbot.waitUntil(lambda: limits(views[2])[0] == -1)
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=end)
    qtbot.mouseDClick(canvas, Qt.MouseButton.LeftButton, pos=start)
    qtbot.waitUntil(lambda: all(limits(view) == (-1, 1, -1, 1) for view in views))


def test_all_tell_their_value_under_the_pointer(views, frame, session, qtbot):
    x, y = 0.40625, -0.65625  # the middle of row 26, column 22
    qtbot.mouseMove(views[1]._canvas, place(views[1], x, y))
    image, scene = frame.snapshot.irradiance, session.scene
    wished = [
        image[26, 22],
        target_irradiance(scene, session.target)[26, 22],
        signed_error(scene, session.target, image)[26, 22],
    ]
    for view, value in zip(views, wished, strict=True):
        assert view._readout.text().startswith(f"{value:.4g} / cm² at x = 0.4")
    qtbot.mouseMove(views[1]._canvas, QPoint(2, 2))
    assert [view._readout.text() for view in views] == ["", "", ""]


def test_light_has_a_logarithmic_scale(views, qtbot):
    qtbot.mouseClick(views[0]._button, Qt.MouseButton.LeftButton)
    light, target, error = (view._image.artists[0] for view in views)
    qtbot.waitUntil(lambda: views[1]._button.isChecked())
    for image in (light, target):
        assert image.norm.vmax / image.norm.vmin == pytest.approx(1000)
        assert image.norm(image.norm.vmax / 10) == pytest.approx(2 / 3)
    assert error.norm.vmin == -error.norm.vmax
    qtbot.mouseClick(views[1]._button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not views[0]._button.isChecked())
    assert light.norm.vmin == 0 and light.norm(light.norm.vmax / 2) == 0.5


def test_the_target_is_drawn_once_for_a_run(views, frame, session, snapshots, history):
    later = make_frame(session, snapshots(2), history(2))
    target = views[1]
    target.show_frame(later)
    assert not target._dated


def test_a_cross_section_goes_through_the_place_that_is_clicked(views, frame, session, qtbot):
    section = SectionView(views[0]._link)
    section.resize(400, 260)
    qtbot.addWidget(section)
    section.show_frame(frame)
    with qtbot.waitExposed(section):
        section.show()
    image = frame.snapshot.irradiance
    light = lambda: section._curves.artists[1].get_ydata()  # noqa: E731
    qtbot.waitUntil(lambda: section._shown is not None)
    np.testing.assert_array_equal(light(), image[16])
    qtbot.mouseClick(
        views[2]._canvas, Qt.MouseButton.LeftButton, pos=place(views[2], 0.40625, -0.65625)
    )
    qtbot.waitUntil(lambda: len(light()) and np.array_equal(light(), image[26]))
    assert "at y = -0.65" in section._where.text()
    section._along.setCurrentIndex(1)
    qtbot.waitUntil(lambda: np.array_equal(light(), image[::-1, 22]))
    wish = section._curves.artists[0].get_ydata()
    assert wish.max() == pytest.approx(
        image.mean() * 4 * target_irradiance(session.scene, session.target)[:, 22].max()
    )
    qtbot.waitUntil(lambda: views[1]._pin_lines[0].get_visible())
    section.hide()
    qtbot.waitUntil(lambda: not views[1]._pin_lines[0].get_visible())


def test_another_screen_is_seen_whole(views, make_scene, session, snapshots, history, qtbot):
    views[0]._link.show_part((0, 0.5, 0, 0.5))
    qtbot.waitUntil(lambda: limits(views[0]) == (0, 0.5, 0, 0.5))
    wide = make_scene({"screen.half_width": [3.0, 1.0], "screen.pixels": [24, 8]})
    other = dataclasses.replace(session, scene=wide, target=np.ones((8, 24)))
    snapshot = dataclasses.replace(snapshots(1), irradiance=np.ones((8, 24)))
    for view in views:
        view.show_frame(make_frame(other, snapshot, history(1)))
    qtbot.waitUntil(lambda: all(limits(view) == (-3, 3, -1, 1) for view in views))
