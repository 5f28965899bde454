"""Images of the screen: zoomed and moved together, read under the pointer, cut along lines."""

import gc
import math

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QGuiApplication, QWheelEvent
from PySide6.QtWidgets import QApplication, QHBoxLayout, QWidget
from shiboken6 import isValid

from ui.background import close_threads
from ui.views.derivative_view import DerivativeView
from ui.views.focus_view import FocusView
from ui.views.light_images import ErrorView, IrradianceView, PinnedView, TargetView
from ui.views.photo_view import PhotoView
from ui.views.section_view import SectionView
from ui.views.shared_view import SharedView
from workbench.pictures.images import shown_error, target_irradiance


@pytest.fixture
def frame(frames):
    return frames(1, irradiance=np.arange(1024.0).reshape(32, 32) / 1000)


@pytest.fixture
def views(frame, show, qtbot):
    """Irradiance, target and error beside each other, drawn."""
    link, window = SharedView(), QWidget()
    views = [IrradianceView(link), TargetView(link), ErrorView(link)]
    row = QHBoxLayout(window)
    for view in views:
        row.addWidget(view)
        view.show_frame(frame)
    show(window, 1320, 380)
    qtbot.waitUntil(lambda: all(view._values is not None for view in views))
    yield views


def test_the_target_is_shown_before_there_is_a_lens(session, show, qtbot):
    view = TargetView()
    view.show_design(session)
    show(view, 380, 320)
    qtbot.waitUntil(lambda: not view.empty)
    wanted = target_irradiance(session.scene, session.target, 1.0)
    assert view._values / view._values.max() == pytest.approx(wanted / wanted.max())


@pytest.fixture
def section(views, frame, show, qtbot):
    """A cross-section of the same light, drawn."""
    section = SectionView(views[0]._shared)
    section.show_frame(frame)
    show(section, 400, 260)
    qtbot.waitUntil(lambda: section._shown is not None)
    return section


def place(view, x, y):
    """The pixel of the canvas where a place on the screen is."""
    at = view._canvas.position_of(x, y)
    return QPoint(math.floor(at.x()), math.floor(at.y()))


def choose(section, number):
    section._direction.setCurrentIndex(number)
    section._direction.activated.emit(number)


def drag(view, qtbot, start, end, modifier=Qt.KeyboardModifier.NoModifier):
    canvas = view._canvas
    qtbot.mousePress(canvas, Qt.MouseButton.LeftButton, modifier, place(view, *start))
    qtbot.mouseMove(canvas, place(view, *end))
    qtbot.mouseRelease(canvas, Qt.MouseButton.LeftButton, modifier, place(view, *end))


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
    """The part of the screen in the largest square that the canvas has space for."""
    canvas = view._canvas
    half = min(canvas.width(), canvas.height()) / 2
    middle = QPointF(canvas.width() / 2, canvas.height() / 2)
    left, top = canvas.place_at(middle - QPointF(half, half))
    right, bottom = canvas.place_at(middle + QPointF(half, half))
    return tuple(round(end, 9) for end in (left, right, bottom, top))


def test_all_zoom_about_the_pointer(views, qtbot):
    turn_wheel(views[0], 0.5, -0.25, 3)
    qtbot.waitUntil(lambda: all(limits(view) != (-1, 1, -1, 1) for view in views))
    scale = 1.25**-3
    wanted = (0.5 - 1.5 * scale, 0.5 + 0.5 * scale, -0.25 - 0.75 * scale, -0.25 + 1.25 * scale)
    for view in views:  # the pointer is on a whole pixel of the window
        np.testing.assert_allclose(limits(view), wanted, atol=0.01)
    turn_wheel(views[2], 0.5, -0.25, -9)
    qtbot.waitUntil(lambda: all(limits(view) == (-1, 1, -1, 1) for view in views))


def test_dragging_moves_all_no_farther_than_the_screen(views, qtbot):
    views[0]._shared.show(part=(-0.5, 0.5, -0.5, 0.5))
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


def test_all_show_their_value_under_the_pointer(views, frame, session, qtbot):
    x, y = 0.40625, -0.65625  # the middle of row 26, column 22
    qtbot.mouseMove(views[1]._canvas, place(views[1], x, y))
    image, scene = frame.state.irradiance, session.scene
    wanted = [
        4 * image[26, 22],  # of a screen of 4 cm²
        4 * target_irradiance(scene, session.target, scene.receiver.total(image))[26, 22],
        shown_error(scene, session.target, image)[26, 22],
    ]
    for view, value in zip(views, wanted, strict=True):
        assert view._readout.text().startswith(f"{value:.4g} × mean at x = 0.4")
    qtbot.mouseMove(views[1]._canvas, QPoint(views[1]._canvas.width() // 2, -2))
    assert {view._readout.text() for view in views} == {"Viewed from behind the screen"}


def test_a_cross_section_goes_through_the_place_that_is_clicked(
    views, section, frame, session, qtbot
):
    image = frame.state.irradiance
    light = lambda: section._curves.light.get_ydata()  # noqa: E731
    np.testing.assert_array_equal(light(), 4 * image[16])
    qtbot.mouseClick(
        views[2]._canvas, Qt.MouseButton.LeftButton, pos=place(views[2], 0.40625, -0.65625)
    )
    qtbot.waitUntil(lambda: len(light()) and np.array_equal(light(), 4 * image[26]))
    assert " at y = -0.6" in section._curves._axes.get_xlabel()
    choose(section, 1)
    qtbot.waitUntil(lambda: np.array_equal(light(), 4 * image[::-1, 22]))
    wanted = section._curves.wanted.get_ydata()
    assert wanted.max() == pytest.approx(
        4 * image.mean() * 4 * target_irradiance(session.scene, session.target)[:, 22].max()
    )
    qtbot.waitUntil(lambda: views[1]._marks[0].get_visible())
    section.hide()
    qtbot.waitUntil(lambda: not views[1]._marks[0].get_visible())


@pytest.mark.parametrize("with_tool", [False, True])
def test_a_cross_section_follows_a_line_that_is_drawn(views, section, qtbot, with_tool):
    link, modifier = views[0]._shared, Qt.KeyboardModifier.ShiftModifier
    if with_tool:
        qtbot.mouseClick(views[0]._line_tool, Qt.MouseButton.LeftButton)
        qtbot.waitUntil(lambda: views[2]._line_tool.isChecked())
        modifier = Qt.KeyboardModifier.NoModifier
    drag(views[2], qtbot, (-0.5, 0.5), (0.5, -0.25), modifier)
    assert section._direction.currentText() == "Along a line"
    qtbot.waitUntil(lambda: section._curves._axes.get_xlim()[1] == pytest.approx(1.25, abs=0.02))
    (x_0, y_0), (x_1, y_1) = link.now.line
    np.testing.assert_allclose((x_0, y_0, x_1, y_1), (-0.5, 0.5, 0.5, -0.25), atol=0.01)
    # A slanted plane stays a straight line.
    light = section._curves.light.get_ydata()
    np.testing.assert_allclose(np.diff(light), np.diff(light).mean(), rtol=1e-6)
    for view in views:  # what is seen has not moved
        assert limits(view) == (-1, 1, -1, 1)
        qtbot.waitUntil(lambda view=view: view._marks[2].get_visible())
        assert not view._marks[0].get_visible()
    choose(section, 0)
    qtbot.waitUntil(lambda: views[1]._marks[0].get_visible())
    assert link.now.line is None
    section.hide()
    assert link.now.pin is None


@pytest.mark.parametrize("size", [(700, 460), (420, 600)])
def test_all_images_are_at_the_same_place(size, frame, show):
    places = set()
    for kind in (IrradianceView, TargetView, ErrorView, FocusView, PhotoView, DerivativeView):
        view = show(kind(), *size)
        canvas = view._canvas
        places.add((canvas.mapTo(view, QPoint()).toTuple(), canvas.size().toTuple()))
        close_threads(view)
    assert len(places) == 1


def test_the_screen_outlives_views_that_are_collected_while_they_are_shown(show):
    for _ in range(10):
        for kind in (IrradianceView, TargetView, FocusView, DerivativeView):
            view = show(kind(), 400, 300)
            close_threads(view)
        del view
        gc.collect()
        assert all(isValid(screen) and screen.name() for screen in QGuiApplication.screens())


def test_a_photo_and_through_focus_zoom_with_the_light(views, frame, show, qtbot):
    photo, part = PhotoView(views[0]._shared), (-0.5, 0.25, -0.5, 0.25)
    photo.show_frame(frame)
    show(photo, 300, 300)
    views[0]._shared.show(part=part)
    qtbot.waitUntil(lambda: photo._shown is not None)
    assert limits(photo) == limits(views[0]) == part
    turn_wheel(photo, 0.0, 0.0, -20)
    assert limits(views[2]) == (-1, 1, -1, 1)
    close_threads(photo)


def test_moving_the_image_computes_no_colours(views, monkeypatch, qtbot):
    converted = []
    monkeypatch.setattr(type(views[0]._canvas), "show_changes", lambda *_: converted.append(1))
    for k in range(5):
        views[0]._shared.show(part=(-0.5, 0.5, -0.5 + 0.1 * k, 0.5 + 0.1 * k))
    qtbot.wait(50)
    assert not converted and limits(views[1]) == (-0.5, 0.5, -0.1, 0.9)


def test_a_file_shows_and_lists_what_is_seen(views, qtbot):
    views[0].resize(views[0].width(), 2 * views[0].width())
    views[0]._shared.show(part=(0.0, 0.5, 0.0, 0.5))
    x, y, values = (column.values for column in views[0].data())
    _, _, bottom, top = limits(views[0])
    assert (x.min(), x.max()) == (0.03125, 0.46875)
    assert y.max() > top and y.min() < bottom  # there is space for more
    assert values.size == np.unique(x).size * np.unique(y).size


@pytest.fixture
def pinned(views, session, show):
    """The view of the pinned image, with a frame of the design in it."""
    pinned = PinnedView(views[0]._shared)
    pinned.show_design(session)
    pinned.show_frame(views[0]._frame)
    return show(pinned, 400, 380)


def test_the_pinned_image_stays_while_others_come_and_is_removed(views, pinned, frames, qtbot):
    light = views[0]
    qtbot.waitUntil(lambda: pinned._hint.text().startswith("Nothing is pinned"))
    before = light._values
    light._pin.click()
    qtbot.waitUntil(lambda: pinned._values is not None)
    np.testing.assert_array_equal(pinned._values, before)
    other = frames(2, irradiance=np.ones((32, 32)))
    for view in (light, pinned):
        view.show_frame(other)
        view.show_outdated(True)
    qtbot.waitUntil(lambda: light._values.max() == 4)
    qtbot.wait(100)
    np.testing.assert_array_equal(pinned._values, before)
    assert light.outdated and not pinned.outdated
    assert light._pin.isChecked() and pinned._pin.isChecked()
    assert pinned._readout.text().startswith("Pinned at iteration 1, error ")
    pinned._pin.click()
    qtbot.waitUntil(lambda: pinned.empty)
    qtbot.waitUntil(lambda: not light._pin.isChecked())


def test_the_pinned_image_is_drawn_on_its_own_receiver(views, pinned, frames, make_session, qtbot):
    session = make_session({"screen.half_width": [2.0, 3.0]})
    views[0]._shared.pin_image(frames(1, session))
    qtbot.waitUntil(lambda: pinned._shown is not None and not pinned.empty)
    assert pinned._whole() == (-2.0, 2.0, -3.0, 3.0)
    assert views[0]._whole() == (-1.0, 1.0, -1.0, 1.0)
